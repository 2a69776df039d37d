#pragma once
// base/image.h -- an array of float pixels. What the numbers mean is the owner's business.
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/check.h"
#include "base/math.h"

namespace luminist {

/// width x height x channels floats, interleaved, row 0 on top. Colour is linear RGB, unclamped, unless said otherwise.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> data;

  Image() = default;
  Image(int width_px, int height_px, int channel_count, float fill = 0.0F);

  [[nodiscard]] bool empty() const { return data.empty(); }
  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] bool same_size(const Image& other) const { return width == other.width && height == other.height; }
  float& at(int x, int y, int c) {
    return data[index(x, y) * static_cast<std::size_t>(channels) + static_cast<std::size_t>(c)];
  }
  [[nodiscard]] float at(int x, int y, int c) const {
    return data[index(x, y) * static_cast<std::size_t>(channels) + static_cast<std::size_t>(c)];
  }
  /// The pixel of a three-channel image by linear index.
  [[nodiscard]] Vec3 rgb(std::size_t pixel) const {
    return {data[pixel * 3], data[pixel * 3 + 1], data[pixel * 3 + 2]};
  }
  void set_rgb(std::size_t pixel, const Vec3& color) {
    data[pixel * 3] = color.x, data[pixel * 3 + 1] = color.y, data[pixel * 3 + 2] = color.z;
  }
};

/// sRGB transfer function of IEC 61966-2-1, one value; the encoder clamps to [0,1] first.
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);

/// Resized by area averaging (down) or bilinearly (up). cost O(source + result).
Image resized(const Image& image, int width, int height);

/// Separable gaussian blur, sigma in pixels, edges clamped; sigma <= 0 returns the image.
Image blurred(const Image& image, float sigma_px);

}  // namespace luminist
