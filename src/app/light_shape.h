#pragma once
// app/light_shape.h -- how far and how wide a light shines, as handles turn it: barn and distance cutoffs.
#include <optional>
#include <string>
#include <vector>

#include "app/light_pose.h"

namespace luminist {

/// Found by the roles of its parameters; what a type lacks is empty.
struct LightShape {
  std::optional<Vec3> barn;         ///< half width, half height, softness of the edge; tangents of angles
  std::optional<Vec2> near_cutoff;  ///< no light before the first, full light after both together; world lengths
  std::optional<Vec2> far_cutoff;   ///< full light up to the first, none after both together
};
LightShape shape_of(const Light& light);
/// What turns `before` into `now`: "lights/key/barn=0.3,0.3,0.1"; nothing that is as it was.
std::vector<std::string> shape_assignments(const Light& light, const LightShape& now, const LightShape& before);

enum class ShapePart { kRight, kLeft, kUp, kDown, kNear, kFar };
/// "width 0.42"
std::string shape_words(const LightShape& shape, ShapePart part);

/// A place that is dragged along a direction (unit).
struct ShapeHandle {
  ShapePart part = ShapePart::kRight;
  Vec3 at{0.0F};
  Vec3 way{0.0F};
};
/// reach: how far away what it shines at lies, > 0; the barn's four sides are held there, where the light ends. A
/// cutoff that lies nearer than an eighth of it, or farther than kFarthest times, is held at that distance.
std::vector<ShapeHandle> shape_handles(const LightPose& pose, const LightShape& shape, float reach);
inline constexpr float kFarthest = 1.6F;

/// The shape after its handle was dragged so far along its way, in world lengths, from where it was.
LightShape dragged_shape(const LightShape& shape, ShapePart part, float length, float reach);

/// Where the light ends, soft edge and all, on the plane across its axis at a distance, as a closed line of world
/// places; empty without a barn.
std::vector<Vec3> barn_ring(const LightPose& pose, const LightShape& shape, float distance);
/// The same on the sphere around the light, where a cutoff lies; without a barn a level circle.
std::vector<Vec3> cutoff_ring(const LightPose& pose, const LightShape& shape, float distance);

/// How far along a way a drag of so many pixels leads from a point, seen in a picture of width x height; nothing where
/// the way points at the eye, so that pixels say nothing.
std::optional<float> slid(const Camera& camera, const Vec3& point, const Vec3& way, const Vec2& pixels, int width,
                          int height);

}  // namespace luminist
