// make_scene -- builds the project's demo scenes: `make_scene NAME -o FILE.glb`, `make_scene --all meshes`.
#include <cstdio>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "base/files.h"
#include "make_scene/recipes.h"

namespace luminist {
namespace {

Result<void> write(const Recipe& recipe, const std::filesystem::path& path) {
  const Scene scene = recipe.build();
  LUM_TRY_VOID(make_folder(path.parent_path().empty() ? "." : path.parent_path()));
  LUM_TRY_VOID(save_scene(scene, path.string()));
  std::printf("%s: %zu objects, %zu triangles\n", path.string().c_str(), scene.objects.size(), scene.triangle_count());
  return {};
}

Result<void> run(const std::string& name, const std::string& output, const std::string& all_below) {
  if (!all_below.empty()) {
    for (const Recipe& recipe : recipes()) {
      LUM_TRY_VOID(write(recipe, std::filesystem::path(all_below) / recipe.name / (recipe.name + ".glb")));
    }
    return {};
  }
  std::vector<std::string> names;
  for (const Recipe& recipe : recipes()) {
    if (recipe.name == name) return write(recipe, output);
    names.push_back(recipe.name);
  }
  const std::string near = nearest_name(name, names);
  return Error{ErrorKind::kUsage, "no scene is called '" + name + "'", "", "NAME",
               near.empty() ? "the scenes are bust, creature, room and still_life" : "did you mean '" + near + "'?"};
}

}  // namespace
}  // namespace luminist

int main(int argc, char** argv) {
  CLI::App app("Builds the demo scenes; the same bytes every time.");
  std::string name;
  std::string output;
  std::string all_below;
  auto* name_option = app.add_option("NAME", name, "bust, creature, room or still_life");
  auto* output_option = app.add_option("-o,--output", output, "the .glb to write");
  auto* all_option = app.add_option("--all", all_below, "write every scene to FOLDER/<name>/<name>.glb");
  name_option->needs(output_option);
  all_option->excludes(name_option)->excludes(output_option);
  CLI11_PARSE(app, argc, argv);
  if (name.empty() && all_below.empty()) {
    std::fputs(app.help().c_str(), stderr);
    return 2;
  }
  const auto done = luminist::run(name, output, all_below);
  if (done) return 0;
  std::fprintf(stderr, "%s\n", done.error().message().c_str());
  return static_cast<int>(done.error().kind);
}
