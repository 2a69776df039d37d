#include "project/paint_document.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"

namespace luminist {
namespace {

using Json = nlohmann::json;
static_assert(std::endian::native == std::endian::little, "tiles are little-endian floats");

/// The pixels of an image that one tile covers.
struct TileBox {
  int x0, y0, width, height;

  [[nodiscard]] std::size_t row_floats(const Image& image) const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(image.channels);
  }
};

template <class Visit>
Result<void> for_each_tile(const Image& image, const std::string& plane, const Visit& visit) {
  for (int y = 0; y < image.height; y += kTileSide) {
    for (int x = 0; x < image.width; x += kTileSide) {
      const TileBox box{x, y, std::min(kTileSide, image.width - x), std::min(kTileSide, image.height - y)};
      LUM_TRY_VOID(visit(box, fmt::format("paint/{}/{},{}", plane, x / kTileSide, y / kTileSide)));
    }
  }
  return {};
}

Error wrong(const std::string& path, const std::string& what) {
  return {ErrorKind::kBadContent, what, "", path, "undo the paint, or restore the project from a copy"};
}

std::vector<float> cut(const Image& image, const TileBox& box) {
  std::vector<float> values;
  values.reserve(box.row_floats(image) * static_cast<std::size_t>(box.height));
  for (int y = 0; y < box.height; ++y) {
    const float* row = &image.data[image.index(box.x0, box.y0 + y) * static_cast<std::size_t>(image.channels)];
    values.insert(values.end(), row, row + box.row_floats(image));
  }
  return values;
}

void put_back(Image& image, const TileBox& box, const std::vector<float>& values) {
  for (int y = 0; y < box.height; ++y) {
    float* row = &image.data[image.index(box.x0, box.y0 + y) * static_cast<std::size_t>(image.channels)];
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(box.row_floats(image)) * y;
    std::copy_n(from, box.row_floats(image), row);
  }
}

/// The one pixel that fills a tile, as JSON, or "". Bits are compared: -0 is not 0.
std::string constant_tile(const std::vector<float>& values, std::size_t channels) {
  const auto same_bits = [](float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
  };
  Json pixel = Json::array();
  for (std::size_t c = 0; c < channels; ++c) {
    if (!std::isfinite(values[c])) return "";
    pixel.push_back(shortest_double(values[c]));
  }
  for (std::size_t i = channels; i < values.size(); ++i) {
    if (!same_bits(values[i], values[i - channels])) return "";
  }
  return channels == 1 ? pixel[0].dump() : pixel.dump();
}

Result<void> write_plane(const Image& image, const std::string& plane, Document& document, TileStore& tiles) {
  return for_each_tile(image, plane, [&](const TileBox& box, const std::string& path) -> Result<void> {
    const std::vector<float> values = cut(image, box);
    std::string text = constant_tile(values, static_cast<std::size_t>(image.channels));
    if (text.empty()) {
      LUM_TRY(const std::string name, tiles.put({reinterpret_cast<const char*>(values.data()), values.size() * 4}));
      text = Json(name).dump();
    }
    document.set(path, std::move(text));
    return {};
  });
}

Result<std::vector<float>> read_tile(const Json& tile, const std::string& path, std::size_t count, std::size_t channels,
                                     const TileStore& tiles) {
  std::vector<float> values(count);
  if (tile.is_string()) {
    LUM_TRY(const std::string bytes, tiles.get(tile.get<std::string>()));
    if (bytes.size() != count * 4) return wrong(path, "the tile has another size than the picture needs");
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  const Json pixel = tile.is_number() ? Json::array({tile}) : tile;
  const bool numbers = pixel.is_array() && pixel.size() == channels &&
                       std::all_of(pixel.begin(), pixel.end(), [](const Json& v) { return v.is_number(); });
  if (!numbers) return wrong(path, "neither a tile's name nor a pixel's values");
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(pixel[i % channels].get<double>());
  return values;
}

Result<void> read_plane(const Document& document, const std::string& plane, const TileStore& tiles, Image& image) {
  return for_each_tile(image, plane, [&](const TileBox& box, const std::string& path) -> Result<void> {
    const Json tile = Json::parse(document.get(path), nullptr, false);
    const std::size_t count = box.row_floats(image) * static_cast<std::size_t>(box.height);
    LUM_TRY(const std::vector<float> values,
            read_tile(tile, path, count, static_cast<std::size_t>(image.channels), tiles));
    put_back(image, box, values);
    return {};
  });
}

bool has_plane(const Document& document, const std::string& plane) {
  return document.has(fmt::format("paint/{}/0,0", plane));
}

/// Stroke numbers as floats: exact up to 2^24 of them.
Image stroke_image(const CanvasState& canvas) {
  Image image(canvas.target.color.width, canvas.target.color.height, 1);
  std::transform(canvas.target.stroke.begin(), canvas.target.stroke.end(), image.data.begin(),
                 [](std::uint32_t stroke) { return static_cast<float>(stroke); });
  return image;
}

Result<double> number_at(const Document& document, const std::string& path) {
  const Json value = Json::parse(document.get(path), nullptr, false);
  if (!value.is_number()) return wrong(path, "a number is wanted");
  return value.get<double>();
}

constexpr double kMostStrokes = 16777216.0;  // 2^24: what a float counts exactly

/// errors kBadContent unless least <= number <= most.
Result<double> number_within(const Document& document, const std::string& path, double least, double most) {
  LUM_TRY(const double number, number_at(document, path));
  if (!(number >= least && number <= most)) {
    return wrong(path, fmt::format("a number from {} to {} is wanted", least, most));
  }
  return number;
}

Result<std::optional<Peak>> read_peak(const Document& document) {
  if (!document.has("paint/peak")) return std::optional<Peak>{};
  const Json value = Json::parse(document.get("paint/peak"), nullptr, false);
  const bool numbers = value.is_array() && value.size() == 4 &&
                       std::all_of(value.begin(), value.end(), [](const Json& v) { return v.is_number(); });
  if (!numbers) return wrong("paint/peak", "four numbers are wanted");
  const auto number = [&](std::size_t i) { return static_cast<float>(value[i].get<double>()); };
  Peak peak;
  peak.kind = number(0) == 0.0F ? PeakKind::kDiffuse : PeakKind::kSpecular;
  peak.direction = Vec3(number(1), number(2), number(3));
  if (!(std::abs(glm::length(peak.direction) - 1.0F) < 1e-3F)) return wrong("paint/peak", "a unit vector is wanted");
  return std::optional<Peak>(peak);
}

Result<void> read_strokes(const Document& document, const TileStore& tiles, CanvasState& canvas) {
  LUM_TRY(const double strokes, number_within(document, "paint/strokes", 0.0, kMostStrokes));
  canvas.strokes = static_cast<std::uint32_t>(strokes);
  LUM_TRY(canvas.peak, read_peak(document));
  Image stroke = stroke_image(canvas);
  LUM_TRY_VOID(read_plane(document, "stroke", tiles, stroke));
  const auto counts = [&](float number) { return number >= 0.0F && number <= static_cast<float>(canvas.strokes); };
  if (!std::all_of(stroke.data.begin(), stroke.data.end(), counts)) {
    return wrong("paint/stroke", "a tile names a stroke that is not there");
  }
  std::transform(stroke.data.begin(), stroke.data.end(), canvas.target.stroke.begin(),
                 [](float number) { return static_cast<std::uint32_t>(number); });
  LUM_TRY_VOID(read_plane(document, "color", tiles, canvas.target.color));
  LUM_TRY_VOID(read_plane(document, "before", tiles, canvas.target.before));
  LUM_TRY_VOID(read_plane(document, "left", tiles, canvas.paint_left));
  if (has_plane(document, "importance")) {
    canvas.importance.paint = Image(stroke.width, stroke.height, 2);
    LUM_TRY_VOID(read_plane(document, "importance", tiles, canvas.importance.paint));
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
    LUM_TRY_VOID(write_plane(canvas.importance.previous, "previous", document, tiles));
  }
  if (canvas.strokes == 0) return {};
  document.set("paint/strokes", Json(canvas.strokes).dump());
  if (canvas.peak) {
    const Vec3& d = canvas.peak->direction;
    const std::array<double, 4> peak = {canvas.peak->kind == PeakKind::kDiffuse ? 0.0 : 1.0, d.x, d.y, d.z};
    document.set("paint/peak", Json(peak).dump());
  }
  LUM_TRY_VOID(write_plane(canvas.target.color, "color", document, tiles));
  LUM_TRY_VOID(write_plane(canvas.target.before, "before", document, tiles));
  LUM_TRY_VOID(write_plane(canvas.paint_left, "left", document, tiles));
  LUM_TRY_VOID(write_plane(stroke_image(canvas), "stroke", document, tiles));
  if (canvas.importance.paint.empty()) return {};
  return write_plane(canvas.importance.paint, "importance", document, tiles);
}

void turn_paint(Document& document, double from_frame, double to_frame) {
  const auto move = [&](const std::string& from, const std::string& to) {
    std::vector<std::pair<std::string, std::string>> moved;
    const auto& entries = document.entries();
    for (auto entry = entries.lower_bound(from); entry != entries.end() && entry->first.starts_with(from); ++entry) {
      moved.emplace_back(to + entry->first.substr(from.size()), entry->second);
    }
    document.erase_below(from);
    for (auto& [path, value] : moved) document.set(path, std::move(value));
  };
  move("paint/", fmt::format("frames/{}/paint/", number_text(from_frame + 0.0)));
  move(fmt::format("frames/{}/paint/", number_text(to_frame + 0.0)), "paint/");
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
  if (has_plane(document, "previous")) {
    canvas.importance.previous = Image(canvas.target.color.width, canvas.target.color.height, 1);
    LUM_TRY_VOID(read_plane(document, "previous", tiles, canvas.importance.previous));
  }
  if (has_paint(document)) LUM_TRY_VOID(read_strokes(document, tiles, canvas));
  for (std::size_t pixel = 0; pixel < canvas.target.importance.pixels(); ++pixel) {
    canvas.target.importance.data[pixel] = canvas.importance.at(pixel, canvas.target.stroke[pixel] != 0);
  }
  return canvas;
}

}  // namespace luminist
