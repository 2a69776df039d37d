#include "app/light_pose.h"

#include <cmath>

#include <fmt/format.h>

#include "params/param_text.h"

namespace luminist {
namespace {

std::string assignment(const Light& light, int param, const Vec3& value) {
  return fmt::format("lights/{}/{}={},{},{}", light.name, light.params.schema()[param].name,
                     number_text(shortest_double(value.x)), number_text(shortest_double(value.y)),
                     number_text(shortest_double(value.z)));
}

Vec3 in_camera(const Camera& camera, const Vec3& way) {
  return glm::transpose(Mat3(camera.world_from_camera)) * way;
}

}  // namespace

std::optional<LightPose> pose_of(const Light& light, const SceneFrame& scene) {
  const ParamSchema& schema = light.params.schema();
  const auto position = schema.by_role("position");
  const auto direction = schema.by_role("direction");
  if (!position && !direction) return std::nullopt;
  LightPose pose;
  if (direction) pose.direction = light.params.vec3(*direction);
  if (position) {
    pose.position = light.params.vec3(*position);
  } else {
    pose.around = scene.center;
    pose.position = scene.center - scene.radius * unit_direction(*pose.direction).value_or(Vec3(0.0F, -1.0F, 0.0F));
  }
  return pose;
}

std::vector<std::string> pose_assignments(const Light& light, const LightPose& pose) {
  const ParamSchema& schema = light.params.schema();
  std::vector<std::string> result;
  if (const auto position = schema.by_role("position")) result.push_back(assignment(light, *position, pose.position));
  const auto direction = schema.by_role("direction");
  if (direction && pose.direction) result.push_back(assignment(light, *direction, *pose.direction));
  return result;
}

std::optional<Vec3> aim_point(const SurfaceBuffer& surface, const LightPose& pose) {
  if (pose.around) return pose.around;
  float best = pose.direction ? 0.0F : -std::numeric_limits<float>::infinity();
  std::optional<Vec3> point;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == 0) continue;
    const Vec3 way = surface.position[i] - pose.position;
    const float distance = glm::length(way);
    if (!(distance > 0.0F)) continue;
    const float fit = pose.direction ? glm::dot(way, *pose.direction) / distance : -distance;
    if (fit > best) best = fit, point = surface.position[i];
  }
  return point;
}

LightPose aimed_at(const LightPose& pose, const Vec3& point) {
  LightPose result = pose;
  const auto way = unit_direction(point - pose.position);
  if (pose.direction && way) result.direction = way;
  return result;
}

LightPose moved_to(const LightPose& pose, const Vec3& position, const std::optional<Vec3>& aim) {
  LightPose result = pose;
  result.position = position;
  if (aim) result = aimed_at(result, *aim);
  if (pose.around) result.position = *pose.around - glm::length(pose.position - *pose.around) * *result.direction;
  return result;
}

Vec3 seen_from(const Camera& camera, const Vec3& aim, const Vec3& position) {
  const auto way = unit_direction(position - aim);
  return in_camera(camera, way.value_or(Vec3(0.0F, 1.0F, 0.0F)));
}

Vec3 place_at(const Camera& camera, const Vec3& aim, const Vec3& position, const Vec3& way) {
  return aim + glm::length(position - aim) * (Mat3(camera.world_from_camera) * way);
}

std::array<std::array<Vec3, 2>, 5> rim_rays(const LightPose& pose) {
  const Vec3 way = pose.around.value_or(pose.position) - pose.position;
  const float radius = std::max(glm::length(way), 1e-6F);
  Vec3 right;
  Vec3 up;
  tangent_frame(way / radius, right, up);
  std::array<std::array<Vec3, 2>, 5> rays;
  const float apart = 0.1F * radius;
  const std::array<Vec3, 5> offsets{Vec3(0.0F), apart * right, -apart * right, apart * up, -apart * up};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Vec3 from = pose.position + offsets[i];
    rays[i] = {from, from + 0.35F * way};
  }
  return rays;
}

std::optional<Vec2> project(const Camera& camera, const Vec3& point, int width, int height) {
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  const Vec4 clip = camera.clip_from_world(aspect) * Vec4(point, 1.0F);
  if (!(clip.w > camera.near_plane)) return std::nullopt;
  return Vec2(0.5F * (clip.x / clip.w + 1.0F) * static_cast<float>(width),
              0.5F * (1.0F - clip.y / clip.w) * static_cast<float>(height));
}

Vec3 dragged(const Camera& camera, const Vec3& point, const Vec2& pixels, int height) {
  const float depth = -in_camera(camera, point - camera.position()).z;
  const float pixel = 2.0F * depth * std::tan(0.5F * camera.fov_y) / static_cast<float>(height);
  return point + Mat3(camera.world_from_camera) * (pixel * Vec3(pixels.x, -pixels.y, 0.0F));
}

}  // namespace luminist
