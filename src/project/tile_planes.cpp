#include "project/tile_planes.h"

#include <algorithm>
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
      LUM_TRY_VOID(visit(box, fmt::format("{}/{},{}", plane, x / kTileSide, y / kTileSide)));
    }
  }
  return {};
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

Result<std::vector<float>> read_tile(const Json& tile, const std::string& path, std::size_t count, std::size_t channels,
                                     const TileStore& tiles) {
  std::vector<float> values(count);
  if (tile.is_string()) {
    LUM_TRY(const std::string bytes, tiles.get(tile.get<std::string>()));
    if (bytes.size() != count * 4) return wrong_paint(path, "the tile has another size than the picture needs");
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  const Json pixel = tile.is_number() ? Json::array({tile}) : tile;
  const bool numbers = pixel.is_array() && pixel.size() == channels &&
                       std::all_of(pixel.begin(), pixel.end(), [](const Json& v) { return v.is_number(); });
  if (!numbers) return wrong_paint(path, "neither a tile's name nor a pixel's values");
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<float>(pixel[i % channels].get<double>());
  return values;
}

}  // namespace

Error wrong_paint(const std::string& path, const std::string& what) {
  return {ErrorKind::kBadContent, what, "", path, "undo the paint, or restore the project from a copy"};
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
  return document.has(plane + "/0,0");
}

}  // namespace luminist
