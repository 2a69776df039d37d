#include "scene/material.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

/// The pixel of a coordinate that may lie outside: of the next repetition, or the last one.
int pixel_at(int index, int size, bool repeat) {
  if (!repeat) return std::clamp(index, 0, size - 1);
  const int rest = index % size;
  return rest < 0 ? rest + size : rest;
}

/// Where a coordinate lies in a picture, in pixels from the first one's centre; a finite number of moderate size.
float place_of(float coordinate, int size, bool repeat) {
  if (!std::isfinite(coordinate)) return 0.0F;
  const float share = repeat ? coordinate - std::floor(coordinate) : std::clamp(coordinate, 0.0F, 1.0F);
  return share * static_cast<float>(size) - 0.5F;
}

}  // namespace

float Texture::red_at(const Vec2& uv) const {
  const float x = place_of(uv.x, image.width, repeat_u);
  const float y = place_of(uv.y, image.height, repeat_v);
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const auto at = [&](int column, int row) {
    return image.at(pixel_at(column, image.width, repeat_u), pixel_at(row, image.height, repeat_v), 0);
  };
  const float right_share = x - static_cast<float>(left);
  const float upper = std::lerp(at(left, top), at(left + 1, top), right_share);
  const float lower = std::lerp(at(left, top + 1), at(left + 1, top + 1), right_share);
  return std::lerp(upper, lower, y - static_cast<float>(top));
}

}  // namespace luminist
