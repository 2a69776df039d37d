#pragma once
// scene/gltf_animation.h -- the animations of a glTF file.
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/animation.h"

namespace tinygltf {
class Model;
}

namespace luminist {

/// The tracks of all clips in the file, played together, because exporters write one clip an object as often as one for
/// all. place_of: for each glTF node its index among the scene's, or -1 where it is not in the scene.
/// What is left out with a warning: morph weights, skins that move, nodes given as a matrix, a second clip for a
/// property that has one. errors kBadContent naming the field: counts that do not fit, times that do not ascend,
/// numbers that are not finite.
Result<std::vector<Track>> gltf_tracks(const tinygltf::Model& model, const std::vector<int>& place_of,
                                       const std::string& path, Diagnostics& diagnostics);

}  // namespace luminist
