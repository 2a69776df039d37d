#pragma once
// scene/obj_materials.h -- an OBJ file's material library as metallic-roughness materials.
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/scene.h"

namespace luminist {

/// A material whose textures are still names, as written in the .mtl file.
struct ObjMaterial {
  Material material;
  std::string base_color, roughness, metallic, normal, emissive;  ///< empty: none
};

/// Without the white space at both ends.
std::string trimmed(std::string_view text);

/// Parses a library that stands beside the .obj and adds its materials by name (the last of a name counts).
/// errors kBadContent for a reference that leaves the folder, kMissing.
Result<void> read_mtl(const std::string& obj_path, const std::string& reference,
                      std::map<std::string, ObjMaterial>& materials);

/// Reads the textures of the used materials, in one go, and appends the materials to the scene. A texture that is not
/// there is left out with a warning. errors kBadContent for a reference that leaves the folder or a broken image.
Result<void> add_obj_materials(const std::string& obj_path, const std::vector<ObjMaterial>& used, Scene& scene,
                               Diagnostics& diagnostics);

}  // namespace luminist
