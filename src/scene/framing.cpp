#include "scene/framing.h"

#include <algorithm>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "base/check.h"

namespace luminist {
namespace {

/// What a set of points needs of a pinhole in given axes: see fit().
struct Reach {
  float lo_x = -std::numeric_limits<float>::infinity(), hi_x = lo_x, lo_y = lo_x, hi_y = lo_x, nearest = lo_x;
};

/// Axes of a camera that looks from `towards` (unit) at the scene: columns right, up, back.
Mat3 camera_axes(const Vec3& towards) {
  const Vec3 right = glm::normalize(glm::cross(Vec3(0.0F, 1.0F, 0.0F), towards));
  return {right, glm::cross(towards, right), towards};
}

/// A point (x, y, z) in camera axes is inside the frustum of an eye at (cx, cy, d) with slope t where
/// x + t z <= cx + t d and -x + t z <= -cx + t d, and the same for y: so the largest left sides give cx, cy and d.
Reach reach_of(const Scene& scene, const Mat3& axes, const Vec3& center, float slope) {
  Reach reach;
  for (const Object& object : scene.objects) {
    if (object.backdrop) continue;
    for (const Vec3& position : scene.meshes[static_cast<std::size_t>(object.mesh)].positions) {
      const Vec3 p = glm::transpose(axes) * (Vec3(object.world_from_object * Vec4(position, 1.0F)) - center);
      reach.hi_x = std::max(reach.hi_x, p.x + slope * p.z), reach.lo_x = std::max(reach.lo_x, -p.x + slope * p.z);
      reach.hi_y = std::max(reach.hi_y, p.y + slope * p.z), reach.lo_y = std::max(reach.lo_y, -p.y + slope * p.z);
      reach.nearest = std::max(reach.nearest, p.z);
    }
  }
  return reach;
}

/// A square grid in the plane of two unit vectors, with normal u x v, texture coordinates 0 to 1.
Mesh plane(const Vec3& origin, const Vec3& u, const Vec3& v, float length_u, float length_v) {
  constexpr std::uint32_t kCells = 48;
  Mesh mesh;
  for (std::uint32_t j = 0; j <= kCells; ++j) {
    for (std::uint32_t i = 0; i <= kCells; ++i) {
      const Vec2 uv(static_cast<float>(i) / kCells, static_cast<float>(j) / kCells);
      mesh.positions.push_back(origin + uv.x * length_u * u + uv.y * length_v * v);
      mesh.normals.push_back(glm::normalize(glm::cross(u, v)));
      mesh.uvs.emplace_back(uv.x, 1.0F - uv.y);
    }
  }
  for (std::uint32_t j = 0; j < kCells; ++j) {
    for (std::uint32_t i = 0; i < kCells; ++i) {
      const std::uint32_t a = j * (kCells + 1) + i, b = a + 1, c = a + kCells + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

void add_backdrop(Scene& scene, const std::string& name, Mesh mesh, int material) {
  Object object;
  object.name = name;
  object.mesh = static_cast<int>(scene.meshes.size());
  object.material = material;
  object.backdrop = true;
  scene.meshes.push_back(std::move(mesh));
  scene.objects.push_back(std::move(object));
}

}  // namespace

Camera automatic_camera(const Scene& scene) {
  constexpr float kAzimuth = 0.55F, kElevation = 0.28F;  // radians: 32 degrees to the right, 16 above
  constexpr float kMargin = 1.12F;                       // air around the objects, of their size in the picture
  const Vec3 towards(std::sin(kAzimuth) * std::cos(kElevation), std::sin(kElevation),
                     std::cos(kAzimuth) * std::cos(kElevation));
  const Mat3 axes = camera_axes(towards);
  const SceneFrame frame = scene.frame();
  Camera camera;
  camera.name = "auto";
  camera.fov_y = 0.6F;
  const float slope = std::tan(0.5F * camera.fov_y) / kMargin;
  const Reach reach = reach_of(scene, axes, frame.center, slope);
  LUM_CHECK(std::isfinite(reach.nearest), "a scene has vertices before it gets a camera");
  const float distance = std::max({(reach.hi_x + reach.lo_x) / (2.0F * slope),
                                   (reach.hi_y + reach.lo_y) / (2.0F * slope), reach.nearest + 0.1F * frame.radius});
  const Vec3 eye =
      frame.center + axes * Vec3(0.5F * (reach.hi_x - reach.lo_x), 0.5F * (reach.hi_y - reach.lo_y), distance);
  camera.world_from_camera = Mat4(axes);
  camera.world_from_camera[3] = Vec4(eye, 1.0F);
  camera.near_plane = camera.far_plane = 0.0F;
  return camera;
}

void add_backdrops(Scene& scene, const SceneOptions& options) {
  if (!options.floor && !options.wall) return;
  LUM_CHECK(!scene.cameras.empty(), "backdrops stand where a camera sees them");
  const Box box = scene.bounds();
  const SceneFrame frame = scene.frame();
  const Vec3 up(0.0F, 1.0F, 0.0F);
  // The backdrop is turned to the camera like a photographer's, level even if the camera looks down.
  Vec3 towards = Vec3(scene.cameras[0].world_from_camera[2]) * Vec3(1.0F, 0.0F, 1.0F);
  towards = glm::length(towards) > 1e-3F ? glm::normalize(towards) : Vec3(0.0F, 0.0F, 1.0F);
  const Vec3 right = glm::cross(up, towards);
  float behind = 0.0F;
  for (const float x : {box.lo.x, box.hi.x}) {
    for (const float z : {box.lo.z, box.hi.z}) {
      behind = std::max(behind, -glm::dot(towards, Vec3(x, 0.0F, z) - frame.center * Vec3(1.0F, 0.0F, 1.0F)));
    }
  }
  const float eye = glm::distance(scene.cameras[0].position(), frame.center);
  const float width = std::max(24.0F * frame.radius, 4.0F * eye);
  const float wall_at = options.wall ? behind + 0.5F * frame.radius : 0.5F * width;
  const float floor_y = box.lo.y - 1e-3F * frame.radius;
  const Vec3 ground(frame.center.x, floor_y, frame.center.z);
  Material grey;
  grey.name = "backdrop";
  grey.base_color = Vec3(0.42F);
  grey.roughness = 0.9F;
  const auto material = static_cast<int>(scene.materials.size());
  scene.materials.push_back(grey);
  const Vec3 left_back = ground - 0.5F * width * right - wall_at * towards;
  if (options.floor) {
    // From the wall's foot towards and past the camera; u x v = right x -towards points up.
    const float depth = wall_at + std::max(0.5F * width, 1.5F * eye);
    add_backdrop(scene, "floor", plane(left_back + depth * towards, right, -towards, width, depth), material);
  }
  if (options.wall) {
    const float below = options.floor ? 0.0F : 0.5F * width;
    add_backdrop(scene, "wall", plane(left_back - below * up, right, up, width, 0.5F * width + below), material);
  }
  for (Camera& camera : scene.cameras) camera.far_plane = 0.0F;  // unknown again, now that there is more to see
}

void fit_clip_planes(Scene& scene) {
  const Box box = scene.bounds(true);
  const float radius = scene.frame().radius;
  for (Camera& camera : scene.cameras) {
    const float farthest = glm::distance(camera.position(), box.center()) + box.radius();
    if (!(camera.near_plane > 0.0F)) {
      camera.fitted_near = true;
      camera.near_plane = std::min(0.02F * radius, 0.1F * glm::distance(camera.position(), scene.frame().center));
      camera.near_plane = std::max(camera.near_plane, 1e-4F * radius);
    }
    if (!(camera.far_plane > camera.near_plane)) {
      camera.fitted_far = true;
      camera.far_plane = std::max(1.05F * farthest, 2.0F * camera.near_plane);
    }
  }
}

}  // namespace luminist
