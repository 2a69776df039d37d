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
/// What is left out with a warning: nodes given as a matrix, a second clip for a property that has one. Morph weights
/// are in tracks of their own (scene/gltf_deform.h). errors kBadContent naming the field: counts that do not fit, times
/// that do not ascend, numbers that are not finite.
Result<std::vector<Track>> gltf_tracks(const tinygltf::Model& model, const std::vector<int>& place_of,
                                       const std::string& path, Diagnostics& diagnostics);

/// A sampler's interpolation by its word, and its times: finite, ascending, at least one. errors as above.
Result<Track::Interpolation> gltf_interpolation(const std::string& word, const std::string& path,
                                                const std::string& field);
Result<std::vector<float>> gltf_times(const tinygltf::Model& model, int accessor, const std::string& path,
                                      const std::string& field);

}  // namespace luminist
