#pragma once
// scene/mesh.h -- triangles with what shading needs.
#include <array>
#include <cstdint>
#include <vector>

#include "base/math.h"

namespace luminist {

/// Indexed triangles. normals has the size of positions (always filled after loading); uvs, tangents and
/// line_widths are empty or of the same size. Front faces wind counter-clockwise.
struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;       ///< unit
  std::vector<Vec2> uvs;           ///< v = 0 at the top row of the texture, as in glTF
  std::vector<Vec4> tangents;      ///< unit xyz, w = sign of the bitangent, as in glTF
  std::vector<float> line_widths;  ///< 0 to 1, share of an outline's width there; the alpha of vertex colours
  std::vector<std::array<std::uint32_t, 3>> triangles;

  /// A vertex of a mesh with the same attributes, this one included, as the last one.
  void append_vertex(const Mesh& from, std::size_t vertex);
  [[nodiscard]] Box bounds() const;
  /// The length of a triangle's side in the mean; 0 without triangles.
  [[nodiscard]] float mean_side() const;
};

/// For every position a number that those at the same place share: equal up to about a millionth of the size of all,
/// because seams and poles are often written with different roundings. Numbers are dense, in order of appearance.
/// cost O(positions).
std::vector<std::uint32_t> places_of(const std::vector<Vec3>& positions);

/// Fills normals: angle-weighted over the triangles around a place (places_of()), apart where they meet at more than
/// crease_angle (radians; kPi joins all). Triangles without area have no say. May split vertices; uvs and line widths
/// follow, tangents are dropped. cost O(triangles log triangles); kPi: O(triangles).
void compute_normals(Mesh& mesh, double crease_angle);

/// Fills tangents from uvs and normals (zero-area uv triangles get any tangent). Does nothing without uvs. Splits the
/// vertices on the seam of a mirrored texture.
void compute_tangents(Mesh& mesh);

}  // namespace luminist
