#include "scene/polygon_soup.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"
#include "scene/mesh_repair.h"
#include "scene/polygon.h"
#include "scene/readers.h"

namespace luminist {

void PolygonSoup::add_polygon(std::span<const std::int64_t> corners, const std::string& where) {
  const std::size_t face = polygons_++;
  if (corners.size() < 3) return too_small_.add(where, fmt::format("face {} with {}", face, corners.size()));
  points_.clear();
  for (const std::int64_t index : corners) {
    const bool inside = index >= 0 && static_cast<std::size_t>(index) < mesh_.positions.size();
    const Vec3 point = inside ? mesh_.positions[static_cast<std::size_t>(index)] : Vec3(0.0F);
    if (!inside || !is_usable(point)) {
      return (inside ? not_finite_ : outside_).add(where, fmt::format("face {}, vertex {}", face, index));
    }
    points_.push_back(point);
  }
  const auto corner = [&](std::uint32_t i) { return static_cast<std::uint32_t>(corners[i]); };
  if (corners.size() == 3) {
    mesh_.triangles.push_back({corner(0), corner(1), corner(2)});
    return;
  }
  for (const auto& t : triangulate(points_)) mesh_.triangles.push_back({corner(t[0]), corner(t[1]), corner(t[2])});
}

Scene PolygonSoup::finish(Diagnostics& diagnostics) {
  for (const FaceFaults* faults : {&outside_, &not_finite_, &too_small_}) faults->report(diagnostics);
  Scene scene;
  scene.materials.push_back({.name = "default"});
  Object object;
  object.name = std::filesystem::path(path_).stem().string();
  scene.objects.push_back(std::move(object));
  scene.meshes.push_back(std::move(mesh_));
  return scene;
}

Result<Scene> read_polygons(const std::string& path, Diagnostics& diagnostics) {
  LUM_TRY(const std::string bytes, read_file(path));
  PolygonSoup soup(path);
  const std::string extension = lower_extension(path);
  if (extension == ".ply") {
    LUM_TRY_VOID(read_ply(bytes, soup));
  } else if (extension == ".stl") {
    LUM_TRY_VOID(read_stl(bytes, soup));
  } else {
    LUM_TRY_VOID(read_off(bytes, soup));
  }
  return soup.finish(diagnostics);
}

}  // namespace luminist
