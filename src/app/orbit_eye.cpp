#include "app/orbit_eye.h"

#include <algorithm>
#include <cmath>

#include "app/light_pose.h"

namespace luminist {
namespace {

constexpr float kHighest = 1.5F;  // short of the pole, where a turn has no meaning

}  // namespace

Camera OrbitEye::camera(float fov_y) const {
  const Vec3 back(std::sin(turn) * std::cos(height), std::sin(height), std::cos(turn) * std::cos(height));
  const Vec3 right(std::cos(turn), 0.0F, -std::sin(turn));
  Camera camera;
  camera.fov_y = fov_y;
  camera.near_plane = 0.001F * distance;
  camera.far_plane = 1000.0F * distance;
  camera.world_from_camera = Mat4(Vec4(right, 0.0F), Vec4(glm::cross(back, right), 0.0F), Vec4(back, 0.0F),
                                  Vec4(center + distance * back, 1.0F));
  return camera;
}

void OrbitEye::turn_by(const Vec2& pixels) {
  constexpr float kTurnPerPixel = 0.008F;
  turn -= kTurnPerPixel * pixels.x;
  height = std::clamp(height + kTurnPerPixel * pixels.y, -kHighest, kHighest);
}

void OrbitEye::pan_by(const Vec2& pixels, float fov_y, int picture_height) {
  center = dragged(camera(fov_y), center, -pixels, picture_height);
}

void OrbitEye::come_nearer(float notches) {
  distance *= std::pow(1.1F, -notches);
}

OrbitEye orbit_from(const Camera& camera, const Vec3& around) {
  const Vec3 back = glm::normalize(Vec3(camera.world_from_camera[2]));
  OrbitEye eye;
  eye.distance = std::max(glm::dot(camera.position() - around, back), 0.01F * glm::length(camera.position() - around));
  eye.distance = std::max(eye.distance, 1e-3F);
  eye.center = camera.position() - eye.distance * back;
  eye.turn = std::atan2(back.x, back.z);
  eye.height = std::clamp(std::asin(std::clamp(back.y, -1.0F, 1.0F)), -kHighest, kHighest);
  return eye;
}

Vec3 way_through(const Camera& camera, const ScreenRect& rect, const Vec2& screen) {
  const Vec2 size = rect.size();
  const float up = std::tan(0.5F * camera.fov_y);
  const Vec2 place = 2.0F * (screen - rect.lo) / size - 1.0F;
  return glm::normalize(Mat3(camera.world_from_camera) * Vec3(place.x * up * size.x / size.y, -place.y * up, -1.0F));
}

}  // namespace luminist
