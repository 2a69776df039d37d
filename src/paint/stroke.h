#pragma once
// paint/stroke.h -- what the hand did: a brush and the points it went through (paper, section 4.1).
#include <string>
#include <vector>

#include "base/math.h"
#include "base/result.h"

namespace luminist {

enum class PaintTool {
  kColor,       ///< composite the brush colour
  kBrighten,    ///< multiply towards brighter by the brush's strength
  kDarken,      ///< the same, darker
  kCopy,        ///< copy from an image edited elsewhere
  kShadow,      ///< copy from the picture with the free lights off
  kLight,       ///< the shadow eraser: copy from the picture with all lights on and no shadows
  kBucket,      ///< every pixel of the object (or of the picture, unclipped) at once
  kImportance,  ///< paint into the importance map
};
enum class PeakKind { kDiffuse, kSpecular };

/// The qualities of a brush. Lengths are fractions of the picture's height.
struct Brush {
  PaintTool tool = PaintTool::kColor;
  Vec3 color{1.0F};           ///< c, linear RGB, may exceed 1
  float diameter = 0.1F;      ///< d; the dab is a gaussian of sigma d/4
  float opacity = 1.0F;       ///< alpha
  float texture = 1.0F;       ///< tau: how much the surface's diffuse texture modulates the colour
  float gradient = 0.0F;      ///< gamma: how much the turning of the normal away from n_peak does
  PeakKind peak = PeakKind::kDiffuse;
  bool repeat_peak = false;   ///< keep the n_peak of the stroke before
  bool screen_gradient = false;  ///< fade along the drag from the first point to the last instead of by normals
  bool add_light = false;     ///< never darken: p_f = max(p_b, c_c)
  float strength = 0.5F;      ///< of brighten and darken, in stops
  float importance = 1.0F;    ///< what kImportance paints
  std::string clip;           ///< name of the object to stay on; "@" is the object under the first point; empty: none
  std::string copy_from;      ///< image file of kCopy, relative to the stroke file
};

/// x in [0, aspect] from the left, y in [0, 1] from the top, both in picture heights.
struct StrokePoint {
  float x = 0.0F;
  float y = 0.0F;
  float pressure = 1.0F;  ///< scales the diameter
};

struct Stroke {
  Brush brush;
  std::vector<StrokePoint> points;
};

/// One painting session on one picture: strokes and how the importance of the rest is implied (section 4.2).
struct StrokeFile {
  float nu = 0.1F;     ///< weight of what was never painted
  float delta = 0.5F;  ///< weight of what was painted before
  std::vector<Stroke> strokes;
};

/// JSON, written by hand or by program; unset qualities keep the defaults above. `"units": "height" | "pixels"`.
/// errors kMissing; kBadContent at path:line:col naming the field, with the nearest valid key.
Result<StrokeFile> load_strokes(const std::string& path);
Result<StrokeFile> parse_strokes(const std::string& json, const std::string& path);
std::string strokes_to_json(const StrokeFile& file);

}  // namespace luminist
