#pragma once
// scene/gltf_deform.h -- the skins and morph targets of a glTF file.
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/animation.h"
#include "scene/deform.h"
#include "scene/mesh.h"

namespace tinygltf {
class Model;
class Node;
struct Primitive;
}  // namespace tinygltf

namespace luminist {

/// Whether the vertices of a node's primitive move.
bool gltf_deforms(const tinygltf::Model& model, const tinygltf::Node& node, const tinygltf::Primitive& primitive);

/// What moves them; joints are named as nodes of the file until they are known as the scene's (place_joints()).
/// mesh: the primitive as it was read. errors kBadContent naming the field: counts that do not fit, a joint that is not
/// there, numbers that are not finite.
Result<Deformer> gltf_deformer(const tinygltf::Model& model, const tinygltf::Node& node,
                               const tinygltf::Primitive& primitive, const Mesh& mesh, const std::string& path,
                               const std::string& field, Diagnostics& diagnostics);

/// place_of: for each glTF node its index among the scene's, or -1. returns false if a joint is not in the scene.
bool place_joints(Deformer& deformer, const std::vector<int>& place_of);

/// The tracks of morph weights of all clips; those of a mesh without targets are left out with a warning. errors as
/// gltf_tracks().
Result<std::vector<WeightTrack>> gltf_weight_tracks(const tinygltf::Model& model, const std::vector<int>& place_of,
                                                    const std::string& path, Diagnostics& diagnostics);

}  // namespace luminist
