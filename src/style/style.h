#pragma once
// style/style.h -- a look as a folder: styles/<name>/{style.toml, *.glsl, textures/, golden/} and no C++.
#include <memory>
#include <optional>
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

/// A picture that the style's GLSL reads as a sampler2D of this name. With levels it is a strip: the tile of `width`
/// squared texels on top, below it half of that, and so on, which become the levels of detail as they are; it repeats.
struct StyleTexture {
  std::string name;
  std::string path;
  int levels = 0;       ///< of a strip; 0: an ordinary picture of one level, clamped at its sides
  bool colors = false;  ///< integer files hold sRGB, as pictures do, and are read as linear colours; else numbers
};

/// One golden picture: a shot, rendered and compared with golden/<name>.exr by two numbers and the reason for them.
struct GoldenCase {
  std::string name;
  std::string style;   ///< empty: the style itself; of a style that draws over others, the one below
  std::string scene;   ///< relative to an asset root
  std::string rig;     ///< relative to an asset root; empty for an empty rig
  std::string camera;  ///< empty: the first
  int width = 256;
  int height = 256;
  std::vector<std::string> link;  ///< "light=objects", see rig/light_links.h
  std::vector<std::string> set;   ///< "path=value"
  double max_difference = 0.0;    ///< of any channel, absolute below 1 and relative above
  double mean_difference = 0.0;
  bool blurred = false;  ///< compared as the style's metric blurs it
  std::string reason;    ///< why these two numbers; required
};

/// How far a graphics processor may be from the references, which software GL draws: it filters textures in its own
/// way.
struct GoldenAllowance {
  double max_difference = 0.0;
  double mean_difference = 0.0;
  std::string reason;  ///< required
};

/// Who draws a style: the raster engine by its GLSL, or the path tracer.
enum class StyleEngine { kRaster, kPath };

struct Style {
  std::string name;
  std::string folder;
  std::string doc;
  StyleEngine engine = StyleEngine::kRaster;
  std::string glsl_path;   ///< defines `vec3 shade(Surface s)`; empty for a style that only draws lines
  std::string ink_folder;  ///< of the manifest of ink_path
  std::string ink_path;    ///< defines `vec4 ink(Surface s)`, the colour of lines; empty: there are none
  bool strokes = false;    ///< shade() reads Surface.stroke, so the meshes are unwrapped
  std::vector<StyleTexture> textures;
  LightCombination lights = LightCombination::kJoint;
  int lights_param = -1;  ///< the choice that says how lights combine, in place of `lights`; -1: none
  StyleMetric metric;
  std::shared_ptr<const ParamSchema> schema;
  std::vector<GoldenCase> golden;
  std::optional<GoldenAllowance> golden_gpu;

  /// How lights combine under these values of the style's parameters.
  [[nodiscard]] LightCombination combination(const ParamBlock& params) const;
  /// Else it needs another below it.
  [[nodiscard]] bool shades() const { return !glsl_path.empty() || engine == StyleEngine::kPath; }
};

/// Reads styles/<name>/style.toml: `doc`, `engine = "raster" | "path"` (raster if left out), `shade` (the GLSL file;
/// none for the path tracer), `lights = "sum" | "joint"` or the name of a [[param]] of type choice, one of whose words
/// is "sum" ("key", one term a light for the objects whose key it is, is a sum too; any other is joint), `strokes`,
/// [metric] `blur`,
/// [[param]], [[texture]], [[golden]], [golden_gpu]. A manifest with `ink` in place of `shade` draws lines over another
/// style: "toon+outline" is both, with the parameters of both. errors kStyle at path:line:col with the nearest valid
/// key; kMissing with the styles there are; kUsage for a stack that is none.
Result<Style> load_style(const AssetRoots& roots, const std::string& name);

/// The same for a style that can be a picture of its own. errors kUsage for one that only draws lines over others.
Result<Style> load_whole_style(const AssetRoots& roots, const std::string& name);

/// The names of all styles, sorted; those that draw lines over others too.
std::vector<std::string> style_names(const AssetRoots& roots);

}  // namespace luminist
