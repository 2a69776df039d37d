#include "project/paint_document.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "project/layer_document.h"
#include "project/peak_json.h"
#include "project/tile_planes.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

/// Stroke numbers as floats: exact up to 2^24 of them.
Image stroke_image(const CanvasState& canvas) {
  Image image(canvas.target.color.width, canvas.target.color.height, 1);
  std::transform(canvas.target.stroke.begin(), canvas.target.stroke.end(), image.data.begin(),
                 [](std::uint32_t stroke) { return static_cast<float>(stroke); });
  return image;
}

Result<double> number_at(const Document& document, const std::string& path) {
  const Json value = Json::parse(document.get(path), nullptr, false);
  if (!value.is_number()) return wrong_paint(path, "a number is wanted");
  return value.get<double>();
}

constexpr double kMostStrokes = 16777216.0;  // 2^24: what a float counts exactly

/// errors kBadContent unless least <= number <= most.
Result<double> number_within(const Document& document, const std::string& path, double least, double most) {
  LUM_TRY(const double number, number_at(document, path));
  if (!(number >= least && number <= most)) {
    return wrong_paint(path, fmt::format("a number from {} to {} is wanted", least, most));
  }
  return number;
}

Result<std::optional<Peak>> read_peak(const Document& document) {
  if (!document.has("paint/peak")) return std::optional<Peak>{};
  LUM_TRY(const Peak peak, peak_from_json(Json::parse(document.get("paint/peak"), nullptr, false), "paint/peak"));
  return std::optional<Peak>(peak);
}

Result<void> read_strokes(const Document& document, const TileStore& tiles, CanvasState& canvas) {
  LUM_TRY(const double strokes, number_within(document, "paint/strokes", 0.0, kMostStrokes));
  canvas.strokes = static_cast<std::uint32_t>(strokes);
  LUM_TRY(canvas.peak, read_peak(document));
  Image stroke = stroke_image(canvas);
  LUM_TRY_VOID(read_plane(document, "paint/stroke", tiles, stroke));
  const auto counts = [&](float number) { return number >= 0.0F && number <= static_cast<float>(canvas.strokes); };
  if (!std::all_of(stroke.data.begin(), stroke.data.end(), counts)) {
    return wrong_paint("paint/stroke", "a tile names a stroke that is not there");
  }
  std::transform(stroke.data.begin(), stroke.data.end(), canvas.target.stroke.begin(),
                 [](float number) { return static_cast<std::uint32_t>(number); });
  LUM_TRY_VOID(read_plane(document, "paint/color", tiles, canvas.target.color));
  LUM_TRY_VOID(read_plane(document, "paint/before", tiles, canvas.target.before));
  LUM_TRY_VOID(read_plane(document, "paint/left", tiles, canvas.paint_left));
  if (has_plane(document, "paint/importance")) {
    canvas.importance.paint = Image(stroke.width, stroke.height, 2);
    LUM_TRY_VOID(read_plane(document, "paint/importance", tiles, canvas.importance.paint));
  }
  return {};
}

}  // namespace

Result<void> write_paint(const CanvasState& canvas, Document& document, TileStore& tiles) {
  for (const char* plane : {"previous", "color", "before", "left", "stroke", "importance"}) {
    document.erase_below(fmt::format("paint/{}/", plane));
  }
  document.set("paint/strokes", "");
  document.set("paint/peak", "");
  document.set("paint/nu", Json(shortest_double(canvas.importance.nu)).dump());
  document.set("paint/delta", Json(shortest_double(canvas.importance.delta)).dump());
  if (!canvas.importance.previous.empty()) {
    LUM_TRY_VOID(write_plane(canvas.importance.previous, "paint/previous", document, tiles));
  }
  LUM_TRY_VOID(write_layers(canvas.layers, document, tiles));
  if (canvas.strokes == 0) return {};
  document.set("paint/strokes", Json(canvas.strokes).dump());
  if (canvas.peak) document.set("paint/peak", peak_to_json(*canvas.peak).dump());
  LUM_TRY_VOID(write_plane(canvas.target.color, "paint/color", document, tiles));
  LUM_TRY_VOID(write_plane(canvas.target.before, "paint/before", document, tiles));
  LUM_TRY_VOID(write_plane(canvas.paint_left, "paint/left", document, tiles));
  LUM_TRY_VOID(write_plane(stroke_image(canvas), "paint/stroke", document, tiles));
  if (canvas.importance.paint.empty()) return {};
  return write_plane(canvas.importance.paint, "paint/importance", document, tiles);
}

bool has_paint(const Document& document) {
  return document.has("paint/strokes");
}

Result<CanvasState> read_paint(const Document& document, const TileStore& tiles, CanvasState fresh) {
  CanvasState canvas = std::move(fresh);
  if (document.has("paint/nu")) {
    LUM_TRY(const double nu, number_within(document, "paint/nu", 0.0, 1.0));
    LUM_TRY(const double delta, number_within(document, "paint/delta", 0.0, 1.0));
    canvas.importance.nu = static_cast<float>(nu);
    canvas.importance.delta = static_cast<float>(delta);
  }
  if (has_plane(document, "paint/previous")) {
    canvas.importance.previous = Image(canvas.target.color.width, canvas.target.color.height, 1);
    LUM_TRY_VOID(read_plane(document, "paint/previous", tiles, canvas.importance.previous));
  }
  if (has_paint(document)) LUM_TRY_VOID(read_strokes(document, tiles, canvas));
  LUM_TRY_VOID(read_layers(document, tiles, canvas));
  for (std::size_t pixel = 0; pixel < canvas.target.importance.pixels(); ++pixel) {
    canvas.target.importance.data[pixel] = canvas.importance_at(pixel);
  }
  return canvas;
}

}  // namespace luminist
