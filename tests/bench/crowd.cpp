#include "bench/crowd.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "prep/decimate.h"
#include "prep/subdivide.h"

namespace luminist {
namespace {

constexpr float kTurn = 2.4F;  // radians, the golden angle: no two rounds fall together

Vec3 turned(const Vec3& v, float angle) {
  return {std::cos(angle) * v.x + std::sin(angle) * v.z, v.y, std::cos(angle) * v.z - std::sin(angle) * v.x};
}

}  // namespace

ParamState crowded(const ParamState& state, const SceneFrame& frame, int count) {
  const std::vector<Light>& model = state.rig.lights;
  LUM_CHECK(count >= 1 && !model.empty(), "a rig that can be repeated");
  ParamState result = state;
  result.rig.lights.clear();
  const auto models = static_cast<int>(model.size());
  const float share = std::min(1.0F, static_cast<float>(models) / static_cast<float>(count));
  for (int i = 0; i < count; ++i) {
    Light light = model[static_cast<std::size_t>(i % models)];
    const float angle = kTurn * static_cast<float>(i / models);
    const ParamSchema& schema = light.params.schema();
    if (i >= models) light.name = fmt::format("{}-{}", light.name, 1 + i / models);
    if (const auto position = schema.by_role("position")) {
      light.params.set_vec3(*position, frame.center + turned(light.params.vec3(*position) - frame.center, angle));
    }
    if (const auto direction = schema.by_role("direction")) {
      light.params.set_vec3(*direction, glm::normalize(turned(light.params.vec3(*direction), angle)));
    }
    if (const auto color = schema.by_role("color")) {
      light.params.set_vec3(*color, share * light.params.vec3(*color));
    }
    result.rig.lights.push_back(std::move(light));
  }
  return result;
}

Result<Scene> refined(Scene scene, int levels) {
  for (Mesh& mesh : scene.meshes) {
    if (levels < 0) {
      mesh = decimate(mesh, std::max<std::size_t>(4, mesh.triangles.size() >> static_cast<unsigned>(-2 * levels)));
      continue;
    }
    auto finer = subdivide_loop(mesh, levels);
    if (finer) {
      mesh = std::move(*finer);
    } else if (finer.error().kind == ErrorKind::kLimit) {
      return finer.error();
    }
  }
  for (Material& material : scene.materials) {
    material.base_color_texture = material.metallic_roughness_texture = -1;
    material.normal_texture = material.emissive_texture = -1;
  }
  scene.textures.clear();
  return scene;
}

}  // namespace luminist
