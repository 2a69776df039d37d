#include "make_scene/recipes.h"

namespace luminist {

std::vector<Recipe> recipes() {
  return {{"bust", build_bust}, {"creature", build_creature}, {"room", build_room}, {"still_life", build_still_life}};
}

Scene (*find_recipe(const std::string& name))() {
  for (const Recipe& recipe : recipes()) {
    if (recipe.name == name) return recipe.build;
  }
  return nullptr;
}

}  // namespace luminist
