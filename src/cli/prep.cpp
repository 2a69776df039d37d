#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/atlas_picture.h"
#include "cli/proxy_words.h"
#include "cli/shot_words.h"
#include "image_io/image_io.h"
#include "prep/unwrap.h"
#include "surface/repair.h"

namespace luminist {
namespace {

struct PrepWords {
  std::string scene;
  std::string output;
  std::string drawing;
  ProxyWords proxies;
  bool unwrap = false;
  bool json = false;
};

using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const std::string& name, std::size_t triangles, const RepairReport& report) {
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

/// How many charts each method made.
std::map<std::string, int> methods_of(const Unwrapped& unwrapped) {
  std::map<std::string, int> methods;
  for (const Chart& chart : unwrapped.charts) ++methods[name_of(chart.method)];
  return methods;
}

OrderedJson to_json(const Unwrapped& unwrapped, double seconds) {
  const UnwrapTotals& totals = unwrapped.totals;
  return {{"charts", unwrapped.charts.size()},
          {"methods", methods_of(unwrapped)},
          {"flipped", totals.flipped},
          {"area_distortion", totals.area},
          {"worst_area_distortion", totals.worst_area},
          {"angle_distortion", totals.angle},
          {"worst_angle_distortion", totals.worst_angle},
          {"stretch", totals.stretch},
          {"coherence", totals.coherence},
          {"seams", totals.seams},
          {"utilization", totals.utilization},
          {"seconds", seconds}};
}

std::string line_of(const Unwrapped& unwrapped, double seconds) {
  const UnwrapTotals& totals = unwrapped.totals;
  std::string methods;
  for (const auto& [method, count] : methods_of(unwrapped)) {
    methods += fmt::format("{}{} {}", methods.empty() ? "" : ", ", count, method);
  }
  return fmt::format(
      "  {} ({}), {} flipped; areas off by a factor of {:.3f} (worst {:.3g}), angles {:.3f} (worst {:.3g}); strokes "
      "parallel {:.2f}; atlas {:.0f} % covered; {:.2f} s",
      counted(unwrapped.charts.size(), "chart"), methods, totals.flipped, totals.area, totals.worst_area, totals.angle,
      totals.worst_angle, totals.coherence, 100.0 * totals.utilization, seconds);
}

/// picture.png, or picture_2.png for another than the only mesh.
std::string numbered(const std::string& path, std::size_t mesh, std::size_t meshes) {
  if (meshes <= 1) return path;
  return fmt::format("{}_{}.png", path.substr(0, path.size() - 4), mesh);
}

bool is_seen(const Scene& scene, std::size_t mesh) {
  return std::ranges::any_of(scene.objects,
                             [&](const Object& object) { return static_cast<std::size_t>(object.mesh) == mesh; });
}

/// The name of the first object that shows a mesh, or whose shadow it casts: meshes have none.
std::string name_of(const Scene& scene, std::size_t mesh) {
  for (const Object& object : scene.objects) {
    if (static_cast<std::size_t>(object.mesh) == mesh) return object.name;
  }
  for (const Object& object : scene.objects) {
    if (object.shadow_mesh == static_cast<int>(mesh)) return "shadow of " + object.name;
  }
  return fmt::format("mesh {}", mesh);
}

/// Gives a mesh without texture coordinates its atlas, and says and draws what came of it.
Result<void> unwrap_mesh(const PrepWords& words, std::size_t index, Scene& scene, OrderedJson& json,
                         std::string& text) {
  constexpr int kDrawing = 2048;  // pixels a side
  const auto start = std::chrono::steady_clock::now();
  Unwrapped unwrapped = unwrap(scene.meshes[index]);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  json["unwrap"] = to_json(unwrapped, seconds);
  text += "\n" + line_of(unwrapped, seconds);
  if (!words.drawing.empty()) {
    LUM_TRY_VOID(write_image(numbered(words.drawing, index, scene.meshes.size()), draw_atlas(unwrapped, kDrawing)));
  }
  if (!scene.meshes[index].uvs.empty()) return {};
  unwrapped.mesh.uvs = std::move(unwrapped.atlas);
  scene.meshes[index] = std::move(unwrapped.mesh);
  return {};
}

Result<void> check_words(const PrepWords& words) {
  if (!words.output.empty() && !words.output.ends_with(".glb")) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no place for a scene", words.output), "", "--output",
                 "give a file that ends in .glb"};
  }
  if (!words.drawing.empty() && !words.drawing.ends_with(".png")) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no place for a drawing", words.drawing), "", "--draw",
                 "give a file that ends in .png"};
  }
  return {};
}

Result<int> prep(const PrepWords& words, VerbContext& context) {
  LUM_TRY_VOID(check_words(words));
  LUM_TRY(const std::string path, find_input(words.scene, ".", context.roots));
  Diagnostics diagnostics;
  auto scene = load_scene(path, {}, diagnostics);
  context.console.warn(diagnostics);
  if (!scene) return std::move(scene).error();
  LUM_TRY(const ProxyShares shares, proxy_shares(words.proxies, *scene));
  const std::size_t meshes = scene->meshes.size();
  for (std::size_t i = 0; i < meshes; ++i) {
    const std::string name = name_of(*scene, i);
    context.console.progress(name);
    const Repaired repaired = repair(scene->meshes[i]);
    scene->meshes[i] = with_surface(scene->meshes[i], repaired.surface);
    const std::size_t triangles = repaired.surface.triangles.size();
    OrderedJson json = to_json(name, triangles, repaired.report);
    std::string text = line_of(name, triangles, repaired.report);
    const bool unwrapped = words.unwrap || !words.drawing.empty();
    if (unwrapped && is_seen(*scene, i)) LUM_TRY_VOID(unwrap_mesh(words, i, *scene, json, text));
    add_proxies(shares, i, *scene, json, text);
    context.console.result(words.json ? json.dump() : text);
  }
  if (words.output.empty()) return 0;
  LUM_TRY_VOID(save_scene(*scene, words.output));
  if (!words.json) context.console.result(words.output);
  return 0;
}

}  // namespace

Verb declare_prep(CLI::App& app) {
  const auto words = std::make_shared<PrepWords>();  // the parser and the returned function both use it
  app.add_option("SCENE", words->scene, "glTF (.gltf, .glb), .obj, .ply, .stl or .off")->required();
  app.add_option("-o,--output", words->output, "Repaired scene, .glb");
  app.add_flag("--unwrap", words->unwrap,
               "Cuts each mesh into charts and lays them flat; the atlas becomes the texture coordinates of a mesh "
               "that has none");
  app.add_option("--draw", words->drawing,
                 "Picture of the atlas, .png; of several meshes _0.png, _1.png...; implies "
                 "--unwrap");
  declare_proxies(app, words->proxies);
  app.add_flag("--json", words->json, "Prints one object for each mesh");
  app.footer(
      "Welds, orients, drops triangles without area and those that are there twice, and splits what is no manifold.\n"
      "Examples:\n"
      "  luminist prep scan.ply\n"
      "  luminist prep scan.ply -o scan.glb --json\n"
      "  luminist prep scan.ply --unwrap --draw atlas.png -o scan.glb\n"
      "  luminist prep shot.glb --shadow-proxy 'hair*=0.02' --shading-proxy 'face=0.05' -o shot_lit.glb");
  return [words](VerbContext& context) { return prep(*words, context); };
}

}  // namespace luminist
