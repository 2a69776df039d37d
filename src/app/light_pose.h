#pragma once
// app/light_pose.h -- where a light stands and shines, as handles move it.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "render/surface_buffer.h"
#include "rig/light_rig.h"
#include "scene/scene.h"

namespace luminist {

struct LightPose {
  Vec3 position{0.0F};
  std::optional<Vec3> direction;  ///< unit; a point light has none
  /// Of a light without a place, as the sun: the centre of the scene, around which its handle goes at the scene's rim.
  std::optional<Vec3> around = std::nullopt;
};

/// Found by the roles of its parameters; nothing for a light that has neither a place nor a direction.
std::optional<LightPose> pose_of(const Light& light, const SceneFrame& scene);
/// What puts a light there: "lights/key/position=1,2,3"; of a light without a place its direction alone.
std::vector<std::string> pose_assignments(const Light& light, const LightPose& pose);

/// The surface point that lies nearest to a light's axis, in angle; of a light without one the point nearest to it; of
/// a light without a place the centre of the scene. Nothing if the picture is empty or all of it lies behind. cost
/// O(pixels).
std::optional<Vec3> aim_point(const SurfaceBuffer& surface, const LightPose& pose);

/// Turned so that it shines at a point.
LightPose aimed_at(const LightPose& pose, const Vec3& point);
/// At another place; what it shines at stays. A light without a place turns: it stays at the rim.
LightPose moved_to(const LightPose& pose, const Vec3& position, const std::optional<Vec3>& aim);

/// The way from the aim to the light, in the camera's frame: x right, y up, z towards the eye. unit.
Vec3 seen_from(const Camera& camera, const Vec3& aim, const Vec3& position);
/// The place at that way from the aim, as far away as before.
Vec3 place_at(const Camera& camera, const Vec3& aim, const Vec3& position, const Vec3& way);

/// Parallel rays of a light without a place, as lines from the rim inwards; the middle one first.
std::array<std::array<Vec3, 2>, 5> rim_rays(const LightPose& pose);

/// Pixels of a picture of width x height from the upper left corner; nothing behind the eye.
std::optional<Vec2> project(const Camera& camera, const Vec3& point, int width, int height);
/// A point moved so that its projection moves by so many pixels, at its distance from the image plane.
Vec3 dragged(const Camera& camera, const Vec3& point, const Vec2& pixels, int height);

}  // namespace luminist
