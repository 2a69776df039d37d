#pragma once
// scene/polygon_soup.h -- collects vertices and polygons of a bare mesh file into a Mesh.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/face_faults.h"
#include "scene/scene.h"

namespace luminist {

/// Polygons are checked (every index inside, every corner usable) and cut into triangles as they come, so all vertices
/// they use must have been added before.
class PolygonSoup {
 public:
  explicit PolygonSoup(std::string path) : path_(std::move(path)) {}

  void reserve(std::size_t vertices) { mesh_.positions.reserve(vertices); }
  void add_vertex(const Vec3& position) { mesh_.positions.push_back(position); }
  void add_normal(const Vec3& normal) { mesh_.normals.push_back(normal); }
  /// where: path or path:line, for messages.
  void add_polygon(std::span<const std::int64_t> corners, const std::string& where);
  [[nodiscard]] const std::string& path() const { return path_; }

  /// One object named after the file, with the default material; faults become warnings.
  Scene finish(Diagnostics& diagnostics);

 private:
  std::string path_;
  Mesh mesh_;
  std::size_t polygons_ = 0;
  std::vector<Vec3> points_;  ///< of the present polygon
  FaceFaults outside_{"an index points to nothing"};
  FaceFaults not_finite_{"a corner is not a finite number"};
  FaceFaults too_small_{"fewer than three corners"};
};

/// The formats; bytes is the whole file. errors kBadContent at path:line, or at path with a byte offset in the text.
Result<void> read_ply(std::string_view bytes, PolygonSoup& soup);
Result<void> read_off(std::string_view bytes, PolygonSoup& soup);
Result<void> read_stl(std::string_view bytes, PolygonSoup& soup);

}  // namespace luminist
