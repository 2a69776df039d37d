#pragma once
// scene/gltf_materials.h -- materials and their pictures from a parsed glTF file.
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/scene.h"

namespace tinygltf {
class Model;
}

namespace luminist {

/// Appends every material of the file (`"extras": {"luminist": {"line_width_texture": 2}}` is its mask of line widths),
/// a default one behind them, and the textures they use, decoded in one go. A picture that is not there is left out
/// with a warning. errors kBadContent for one that is broken.
Result<void> add_gltf_materials(const tinygltf::Model& model, const std::string& path, Scene& scene,
                                Diagnostics& diagnostics);

/// The texture coordinate set that a material's pictures use (the base colour's, if they differ).
int gltf_uv_set(const tinygltf::Model& model, int material);

}  // namespace luminist
