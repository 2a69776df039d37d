#pragma once
// studio/solid_scene.h -- the triangles of a scene in the world, for whoever draws them plainly.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace luminist {

/// One object: a run of triangles of one colour.
struct SolidPart {
  std::string object;
  std::uint32_t first = 0;  ///< of SolidScene::corners
  std::uint32_t count = 0;  ///< three a triangle
  Vec3 color{0.8F};  ///< linear: the material's base colour times the mean of its texture, not darker than a tenth
};

struct SolidScene {
  std::vector<Vec3> positions;         ///< world
  std::vector<Vec3> normals;           ///< unit, of the size of positions
  std::vector<std::uint32_t> corners;  ///< indices into both
  std::vector<SolidPart> parts;
};

/// All objects as the scene stands. cost O(triangles + texels).
SolidScene solid_scene(const Scene& scene);

/// What a ray meets first. returns the distance along the unit `way`, nothing if it meets nothing. cost O(triangles).
std::optional<float> first_hit(const SolidScene& solid, const Vec3& origin, const Vec3& way);

}  // namespace luminist
