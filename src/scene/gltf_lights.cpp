#include "scene/gltf_lights.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "scene/gltf_document.h"

namespace luminist {

void add_gltf_light(const tinygltf::Model& model, const tinygltf::Node& node, int place, const Mat4& world_from_node,
                    const std::string& path, Scene& scene, Diagnostics& diagnostics) {
  const auto warn = [&](std::string what) { diagnostics.warn(path, std::move(what)); };
  const auto extension = node.extensions.find("KHR_lights_punctual");
  if (extension == node.extensions.end() || !extension->second.Has("light")) return;
  const tinygltf::Value& reference = extension->second.Get("light");
  const int index = reference.IsNumber() ? reference.GetNumberAsInt() : -1;
  if (!inside(index, model.lights.size())) return warn("a node names a light that is not there");
  const tinygltf::Light& from = model.lights[static_cast<std::size_t>(index)];
  const std::map<std::string, PunctualLight::Kind> kinds{{"point", PunctualLight::Kind::kPoint},
                                                         {"spot", PunctualLight::Kind::kSpot},
                                                         {"directional", PunctualLight::Kind::kSun}};
  const auto kind = kinds.find(from.type);
  if (kind == kinds.end()) return warn(fmt::format("lights[{}] is of the unknown type \"{}\"", index, from.type));
  PunctualLight light;
  light.name = !node.name.empty() ? node.name : (!from.name.empty() ? from.name : from.type);
  light.kind = kind->second;
  if (from.color.size() == 3) light.color = Vec3(glm::dvec3(from.color[0], from.color[1], from.color[2]));
  light.intensity = static_cast<float>(std::max(from.intensity, 0.0));
  light.range = static_cast<float>(std::max(from.range, 0.0));
  light.outer_angle = static_cast<float>(std::clamp(from.spot.outerConeAngle, 1e-3, 0.5 * kPi));
  light.inner_angle = static_cast<float>(std::clamp<double>(from.spot.innerConeAngle, 0.0, light.outer_angle));
  const Mat4 frame = without_scale(world_from_node);
  light.position = Vec3(frame[3]);
  light.direction = -Vec3(frame[2]);
  light.mount.node = place;
  scene.lights.push_back(std::move(light));
}

}  // namespace luminist
