#pragma once
// make_scene/recipes.h -- the demo scenes by name.
#include <string>
#include <vector>

#include "scene/scene.h"

namespace luminist {

struct Recipe {
  std::string name;
  Scene (*build)() = nullptr;  ///< cost up to some seconds; the same bits every time
};

/// All recipes, in the order of their names.
std::vector<Recipe> recipes();

/// nullptr if there is none of the name.
Scene (*find_recipe(const std::string& name))();

Scene build_still_life();
Scene build_bust();
Scene build_creature();
Scene build_room();

}  // namespace luminist
