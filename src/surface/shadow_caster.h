#pragma once
// surface/shadow_caster.h -- which sides of a shadow mesh block light, so that it never darkens what it stands in for.
#include <array>
#include <cstdint>
#include <vector>

#include "scene/mesh.h"

namespace luminist {

/// A shadow mesh is not quite where the surface is that is seen, and would throw blotches on it. A closed piece throws
/// the same shadow on others if it blocks light only where light would leave it; then all that lies in it, or before
/// it, stays lit. A piece with a border has no inside, and blocks light on both sides.
///
/// source: second-depth shadow mapping (Wang and Molnar 1994), for what has a proxy.
struct ShadowCaster {
  using Triangle = std::array<std::uint32_t, 3>;

  std::vector<Vec3> positions;
  std::vector<Triangle> closed;  ///< of closed pieces; counter-clockwise seen from where their normals point
  std::vector<Triangle> open;    ///< of the others
  /// How far what is seen is kept off it, in the mesh's units, above 0 if it has triangles: a twentieth of a side of
  /// its triangles in the mean, at most 1/200 of its radius, because shadows of others on the object begin that much
  /// later.
  float slack = 0.0F;
};

/// The same in the world, for an object that is placed there.
float world_slack(const ShadowCaster& caster, const Mat4& world_from_object);

/// The mesh is repaired first. A piece whose borders are so short that what they enclose is below a hundredth of its
/// area is closed: scans have holes where they stood. cost that of repair(), about 3 us a triangle.
ShadowCaster shadow_caster(const Mesh& mesh);

}  // namespace luminist
