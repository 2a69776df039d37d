#pragma once
// scene/gltf_lights.h -- the lights of a glTF file, as KHR_lights_punctual has them.
#include <string>

#include "base/diagnostics.h"
#include "scene/scene.h"

namespace tinygltf {
class Model;
class Node;
}  // namespace tinygltf

namespace luminist {

/// The light of a node, if it has one; place: the node among the scene's. What makes no sense is left out with a
/// warning.
void add_gltf_light(const tinygltf::Model& model, const tinygltf::Node& node, int place, const Mat4& world_from_node,
                    const std::string& path, Scene& scene, Diagnostics& diagnostics);

}  // namespace luminist
