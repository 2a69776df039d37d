#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/shot_words.h"
#include "prep/repair.h"

namespace luminist {
namespace {

struct Words {
  std::string scene;
  std::string output;
  bool json = false;
};

using Json = nlohmann::ordered_json;

Json to_json(const std::string& name, std::size_t triangles, const RepairReport& report) {
  return {{"mesh", name},
          {"triangles", triangles},
          {"components", report.components},
          {"open_edges", report.open_edges},
          {"welded", report.welded},
          {"degenerate", report.degenerate},
          {"duplicate", report.duplicate},
          {"flipped", report.flipped},
          {"split_edges", report.split_edges},
          {"torn_edges", report.torn_edges},
          {"split_positions", report.split_positions}};
}

std::string counted(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string line_of(const std::string& name, std::size_t triangles, const RepairReport& report) {
  std::string line =
      fmt::format("{}: {} in {}, {}", name, counted(triangles, "triangle"), counted(report.components, "piece"),
                  report.open_edges == 0 ? "closed" : counted(report.open_edges, "open edge"));
  if (report.was_good()) return line + "; nothing to repair";
  const auto say = [&line](std::size_t count, const char* noun, const char* fate) {
    if (count > 0) line += fmt::format("; {} {}", counted(count, noun), fate);
  };
  say(report.degenerate, "triangle", "without area dropped");
  say(report.duplicate, "triangle", "dropped, there twice");
  say(report.flipped, "triangle", "turned");
  say(report.split_edges, "edge", "of more than two triangles split");
  say(report.torn_edges, "edge", "torn where the surface has one side only");
  say(report.split_positions, "position", "split where surfaces touch");
  return line;
}

/// The name of the first object that shows a mesh: meshes have none.
std::string name_of(const Scene& scene, std::size_t mesh) {
  for (const Object& object : scene.objects) {
    if (static_cast<std::size_t>(object.mesh) == mesh) return object.name;
  }
  return fmt::format("mesh {}", mesh);
}

Result<int> prep(const Words& words, VerbContext& context) {
  if (!words.output.empty() && !words.output.ends_with(".glb")) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no place for a scene", words.output), "", "--output",
                 "give a file that ends in .glb"};
  }
  LUM_TRY(const std::string path, find_input(words.scene, ".", context.roots));
  Diagnostics diagnostics;
  auto scene = load_scene(path, {}, diagnostics);
  context.console.warn(diagnostics);
  if (!scene) return std::move(scene).error();
  for (std::size_t i = 0; i < scene->meshes.size(); ++i) {
    const std::string name = name_of(*scene, i);
    context.console.progress(name);
    const Repaired repaired = repair(scene->meshes[i]);
    scene->meshes[i] = with_surface(scene->meshes[i], repaired.surface);
    const std::size_t triangles = repaired.surface.triangles.size();
    context.console.result(words.json ? to_json(name, triangles, repaired.report).dump()
                                      : line_of(name, triangles, repaired.report));
  }
  if (words.output.empty()) return 0;
  LUM_TRY_VOID(save_scene(*scene, words.output));
  if (!words.json) context.console.result(words.output);
  return 0;
}

}  // namespace

Verb declare_prep(CLI::App& app) {
  const auto words = std::make_shared<Words>();  // the parser and the returned function both use it
  app.add_option("SCENE", words->scene, "glTF (.gltf, .glb), .obj, .ply, .stl or .off")->required();
  app.add_option("-o,--output", words->output, "Repaired scene, .glb");
  app.add_flag("--json", words->json, "Prints one object for each mesh");
  app.footer(
      "Welds, orients, drops triangles without area and those that are there twice, and splits what is no manifold.\n"
      "Examples:\n"
      "  luminist prep scan.ply\n"
      "  luminist prep scan.ply -o scan.glb --json");
  return [words](VerbContext& context) { return prep(*words, context); };
}

}  // namespace luminist
