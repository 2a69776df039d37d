#pragma once
// rig/light_type.h -- the kinds of light there are: one manifest and one GLSL file each, in shaders/light/.
#include <memory>
#include <string>
#include <vector>

#include "base/files.h"
#include "params/param_schema.h"

namespace luminist {

/// What a light's shadow map has to cover.
enum class ShadowKind {
  kNone,
  kSpot,
  kCube,
  kSun,  ///< parallel rays: all of the scene
};

/// shaders/light/<name>.toml: `doc`, `shadow = "none" | "spot" | "cube" | "sun"` and [[param]] tables; <name>.glsl
/// beside it defines `LightSample sample_<name>(<Struct> light, Surface s)`.
struct LightType {
  std::string name;
  std::string doc;
  ShadowKind shadow = ShadowKind::kNone;
  std::string glsl_path;
  std::shared_ptr<const ParamSchema> schema;

  [[nodiscard]] std::string struct_name() const;  ///< "Cinematic" for "cinematic"
};

class LightTypes {
 public:
  /// Every manifest in shaders/light; ambient.toml is the rig's ambient block and no type.
  /// errors kStyle at the manifest's line; kMissing without any type.
  static Result<LightTypes> load(const AssetRoots& roots);

  [[nodiscard]] const std::vector<LightType>& all() const { return types_; }
  [[nodiscard]] const LightType* find(const std::string& name) const;
  [[nodiscard]] int index(const std::string& name) const;  ///< position in all(), or -1
  [[nodiscard]] const std::shared_ptr<const ParamSchema>& ambient() const { return ambient_; }
  [[nodiscard]] std::vector<std::string> names() const;

 private:
  std::vector<LightType> types_;
  std::shared_ptr<const ParamSchema> ambient_;
};

}  // namespace luminist
