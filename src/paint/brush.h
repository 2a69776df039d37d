#pragma once
// paint/brush.h -- the qualities of a brush, declared once (paper, section 4.1).
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/math.h"
#include "base/result.h"

namespace luminist {

enum class PaintTool {
  kColor,         ///< composite the brush colour
  kBrighten,      ///< multiply by 2^(strength x amount)
  kDarken,        ///< divide by it
  kCopy,          ///< composite an image edited elsewhere
  kShadow,        ///< composite the picture with the free lights off
  kShadowEraser,  ///< composite the picture with all lights on and no shadows
  kErase,         ///< back to the picture under the paint, and to the implied importance
  kImportance,    ///< paint into the importance map
};
enum class PeakKind {
  kDiffuse,   ///< n_peak is the normal at the stroke's start; paint fades with n . n_peak
  kSpecular,  ///< n_peak is the view vector mirrored there; paint fades with (mirrored view) . n_peak
};

/// The largest colour component that a brush holds or makes: far above any display, far below what overflows.
inline constexpr float kBrightest = 1e6F;

/// Lengths are fractions of the picture's height. Any tool can be a bucket, clipped, faded.
struct Brush {
  PaintTool tool = PaintTool::kColor;
  Vec3 color{1.0F};       ///< c, linear RGB, may exceed 1
  float diameter = 0.1F;  ///< d; the dab is a gaussian of sigma d/4
  float opacity = 1.0F;   ///< alpha
  float texture = 1.0F;   ///< tau: how much the surface's diffuse texture modulates the colour
  float gradient = 0.0F;  ///< gamma: how much the turning of the surface away from n_peak does
  PeakKind peak = PeakKind::kDiffuse;
  bool repeat_peak = false;  ///< keep the n_peak, and its kind, of the last stroke that had a gradient
  bool screen_gradient =
      false;                ///< gamma makes the paint run out from the first point to the last, whatever the normals
  bool add_light = false;   ///< never darken: p_f = max(p_b, c_c)
  bool bucket = false;      ///< cover every pixel of the clip object (of the picture, without one) at once
  float strength = 0.5F;    ///< of kBrighten and kDarken, in stops
  float importance = 1.0F;  ///< what kImportance paints
  std::string clip;         ///< name of the object to stay on; "@" is the object under the first point; empty: none
  std::string copy_from;    ///< image file of kCopy, relative to the stroke file
};

/// One quality: stroke files, widgets and the reference follow from the table of these.
struct BrushQuality {
  using Member = std::variant<float Brush::*, bool Brush::*, Vec3 Brush::*, std::string Brush::*, PaintTool Brush::*,
                              PeakKind Brush::*>;
  const char* name;
  Member member;
  float least;  ///< numbers and colour components must lie in [least, most]
  float most;
  const char* unit;
  const char* doc;
};
std::span<const BrushQuality> brush_qualities();

/// "0 to 16 stops", or the words it may be; empty where anything goes.
std::string quality_range(const BrushQuality& quality);

/// The words of stroke files, by the enumerators' values.
std::span<const std::string> tool_words();
std::span<const std::string> peak_words();

/// errors kBadContent if a number is not finite or out of its range; names the field.
Result<void> check_quality(const Brush& brush, const BrushQuality& quality);

}  // namespace luminist
