#pragma once
// style/style.h -- a look as a folder: styles/<name>/{style.toml, *.glsl, textures/, golden/} and no C++.
#include <memory>
#include <string>
#include <vector>

#include "base/files.h"
#include "params/param_block.h"
#include "params/param_schema.h"

namespace luminist {

/// How lights combine, so that the solver knows what it may assume.
/// kSum: shade() = emission and ambient + one term per light, each linear in the light's colour.
/// kJoint: no such promise; the solver evaluates all lights together.
enum class LightCombination { kSum, kJoint };

/// How pictures are compared: pixel by pixel, or after a gaussian blur of picture and target.
struct StyleMetric {
  float blur = 0.0F;  ///< sigma as a fraction of the picture's height; 0 is plain
};

/// One golden picture: a shot, rendered and compared with golden/<name>.exr by two numbers and the reason for them.
struct GoldenCase {
  std::string name;
  std::string scene;   ///< relative to an asset root
  std::string rig;     ///< relative to an asset root; empty for an empty rig
  std::string camera;  ///< empty: the first
  int width = 256;
  int height = 256;
  std::vector<std::string> set;  ///< "path=value"
  double max_difference = 0.0;   ///< of any channel, absolute below 1 and relative above
  double mean_difference = 0.0;
  std::string reason;  ///< why these two numbers; required
};

struct Style {
  std::string name;
  std::string folder;
  std::string doc;
  std::string glsl_path;  ///< defines `vec3 shade(Surface s)`
  LightCombination lights = LightCombination::kJoint;
  int lights_param = -1;  ///< the choice that says how lights combine, in place of `lights`; -1: none
  StyleMetric metric;
  std::shared_ptr<const ParamSchema> schema;
  std::vector<GoldenCase> golden;

  /// How lights combine under these values of the style's parameters.
  [[nodiscard]] LightCombination combination(const ParamBlock& params) const;
};

/// Reads styles/<name>/style.toml: `doc`, `shade` (the GLSL file), `lights = "sum" | "joint"` or the name
/// of a [[param]] of type choice, one of whose words is "sum" (any other is joint), [metric] `blur`,
/// [[param]], [[golden]]. errors kStyle at path:line:col with the nearest valid key; kMissing with the styles there
/// are.
Result<Style> load_style(const AssetRoots& roots, const std::string& name);

/// The names of all styles, sorted.
std::vector<std::string> style_names(const AssetRoots& roots);

}  // namespace luminist
