#pragma once
// paint/stroke.h -- what the hand did: a brush and the points it went through; files of strokes.
#include <string>
#include <vector>

#include "paint/brush.h"

namespace luminist {

/// x in [0, aspect] from the left, y in [0, 1] from the top, both in picture heights; outside is allowed.
struct StrokePoint {
  float x = 0.0F;
  float y = 0.0F;
  float pressure = 1.0F;  ///< in [0,1], scales the diameter
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

/// Qualities in their ranges, points finite, at least one point (a bucket may have none), kCopy with an image.
/// errors kBadContent naming the field.
Result<void> check_stroke(const Stroke& stroke);

/// Stroke files are JSON, written by hand or by program. Unset qualities keep the defaults of Brush:
///
///   { "units": "height",                 optional; or "pixels", then "height": of the picture they were measured on
///     "nu": 0.1, "delta": 0.5,           optional
///     "brushes": { "warm": { "color": "#ffb060", "diameter": 0.2, "gradient": 1 } },
///     "strokes": [ { "brush": "warm", "opacity": 0.8, "clip": "@", "points": [[0.5, 0.4], [0.6, 0.45, 0.7]] } ] }
///
/// A stroke may name a brush of the table and override any quality of it. Colours are [r, g, b], linear, or "#rrggbb",
/// sRGB. Points are [x, y] or [x, y, pressure].
/// errors kMissing; kBadContent at path:line:column naming the field, with the nearest valid key.
Result<StrokeFile> load_strokes(const std::string& path);
Result<StrokeFile> parse_strokes(const std::string& json, const std::string& path);

/// One stroke a paragraph, only qualities that differ from the defaults; parses to the same values bit by bit.
std::string strokes_to_json(const StrokeFile& file);

/// A brush with some qualities changed: an object of them, as in stroke files. errors as parse_strokes().
Result<Brush> parse_brush(const std::string& json, const std::string& path, const Brush& brush);
/// The qualities of `to` that are others than those of `from`, as such an object.
std::string brush_changes(const Brush& from, const Brush& to);

/// The qualities of a stroke as a Markdown table: name, default, range, what it does.
std::string stroke_reference();

}  // namespace luminist
