#include "bench/prep.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include <fmt/format.h>

#include "prep/curvature.h"
#include "prep/nasty_meshes.h"
#include "prep/unwrap.h"
#include "scene/scene.h"
#include "surface/repair.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void measure(const std::string& scene, const std::string& name, const Mesh& mesh, bool json) {
  const double start = now();
  const WeldedMesh surface = repair(mesh).surface;
  const double repaired = now();
  const StrokeField field = stroke_field(surface, sides_of(surface));
  const double bent = now();
  const Unwrapped unwrapped = unwrap(mesh);
  const double done = now();
  const UnwrapTotals& totals = unwrapped.totals;
  const auto rigid = std::ranges::count(unwrapped.charts, ChartMethod::kRigid, &Chart::method);
  if (json) {
    const nlohmann::ordered_json line{{"bench", "prep"},
                                      {"kind", "result"},
                                      {"scene", scene},
                                      {"mesh", name},
                                      {"faces", surface.triangles.size()},
                                      {"charts", unwrapped.charts.size()},
                                      {"rigid", rigid},
                                      {"flipped", totals.flipped},
                                      {"area", totals.area},
                                      {"worst_area", totals.worst_area},
                                      {"angle", totals.angle},
                                      {"worst_angle", totals.worst_angle},
                                      {"stretch", totals.stretch},
                                      {"coherence", totals.coherence},
                                      {"seams", totals.seams},
                                      {"utilization", totals.utilization},
                                      {"repair_seconds", repaired - start},
                                      {"curvature_seconds", bent - repaired},
                                      {"unwrap_seconds", done - bent}};
    std::printf("%s\n", line.dump().c_str());
  } else {
    fmt::print(
        "{:<16} {:<16} {:>7} faces {:>4} charts {:>2} flipped  area {:.3f} (worst {:.3g})  angle {:.3f} (worst "
        "{:.3g})  parallel {:.2f}  {:.2f} s\n",
        scene, name, surface.triangles.size(), unwrapped.charts.size(), totals.flipped, totals.area, totals.worst_area,
        totals.angle, totals.worst_angle, totals.coherence, done - bent);
  }
  std::fflush(stdout);
}

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    const std::string extension = entry.path().extension().string();
    for (const char* known : {".obj", ".ply", ".stl", ".off", ".glb", ".gltf"}) {
      if (extension == known) files.push_back(entry.path().string());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

Result<void> run_prep(const PrepOptions& options) {
  if (options.meshes.empty()) {
    for (const auto& [name, mesh] : test::nasty_meshes()) measure("generated", name, mesh, options.json);
    return {};
  }
  const std::vector<std::string> files = files_below(options.meshes);
  if (files.empty()) {
    return Error{ErrorKind::kMissing, "no meshes in this folder", options.meshes, "meshes", "name a folder of meshes"};
  }
  for (const std::string& file : files) {
    Diagnostics diagnostics;
    const auto scene = load_scene(file, {}, diagnostics);
    if (!scene) {
      std::fprintf(stderr, "luminist-bench: %s\n", scene.error().message().c_str());
      continue;
    }
    for (std::size_t i = 0; i < scene->meshes.size(); ++i) {
      const auto shows = [&](const Object& object) { return static_cast<std::size_t>(object.mesh) == i; };
      const auto object = std::ranges::find_if(scene->objects, shows);
      const std::string name = object == scene->objects.end() ? fmt::format("mesh {}", i) : object->name;
      measure(fs::path(file).stem().string(), name, scene->meshes[i], options.json);
    }
  }
  return {};
}

}  // namespace luminist
