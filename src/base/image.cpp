#include "base/image.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

/// One axis of an area-averaging or bilinear resize: weights of the source pixels under each result pixel.
struct Tap {
  int first = 0;
  std::vector<float> weights;
};

std::vector<Tap> resize_taps(int from, int to) {
  std::vector<Tap> taps(static_cast<std::size_t>(to));
  const double scale = static_cast<double>(from) / to;
  const double support = std::max(scale, 1.0);
  for (int i = 0; i < to; ++i) {
    const double center = (i + 0.5) * scale;
    const int lo = std::clamp(static_cast<int>(std::floor(center - support)), 0, from - 1);
    const int hi = std::clamp(static_cast<int>(std::ceil(center + support)), 1, from);
    Tap& tap = taps[static_cast<std::size_t>(i)];
    tap.first = lo;
    double sum = 0.0;
    for (int s = lo; s < hi; ++s) {
      const double overlap = scale > 1.0
                                 ? std::min(s + 1.0, center + 0.5 * scale) - std::max<double>(s, center - 0.5 * scale)
                                 : 1.0 - std::abs(s + 0.5 - center);
      tap.weights.push_back(static_cast<float>(std::max(overlap, 0.0)));
      sum += tap.weights.back();
    }
    for (float& w : tap.weights) w = static_cast<float>(w / sum);
  }
  return taps;
}

/// Applies one filter per result column; the transpose makes the same code serve both axes.
Image filtered_columns(const Image& image, const std::vector<Tap>& taps) {
  Image result(image.height, static_cast<int>(taps.size()), image.channels);  // transposed
  for (int y = 0; y < image.height; ++y) {
    for (std::size_t x = 0; x < taps.size(); ++x) {
      const Tap& tap = taps[x];
      for (int c = 0; c < image.channels; ++c) {
        float sum = 0.0F;
        for (std::size_t k = 0; k < tap.weights.size(); ++k) {
          if (tap.weights[k] != 0.0F) sum += tap.weights[k] * image.at(tap.first + static_cast<int>(k), y, c);
        }
        result.at(y, static_cast<int>(x), c) = sum;
      }
    }
  }
  return result;
}

std::vector<Tap> gaussian_taps(int size, float sigma_px) {
  const int radius = static_cast<int>(std::ceil(3.0F * sigma_px));
  std::vector<Tap> taps(static_cast<std::size_t>(size));
  for (int i = 0; i < size; ++i) {
    Tap& tap = taps[static_cast<std::size_t>(i)];
    tap.first = std::max(i - radius, 0);
    const int last = std::min(i + radius, size - 1);
    tap.weights.assign(static_cast<std::size_t>(last - tap.first + 1), 0.0F);
    float sum = 0.0F;
    for (int k = -radius; k <= radius; ++k) {
      const float weight = std::exp(-0.5F * static_cast<float>(k * k) / (sigma_px * sigma_px));
      tap.weights[static_cast<std::size_t>(std::clamp(i + k, 0, size - 1) - tap.first)] += weight;
      sum += weight;
    }
    for (float& w : tap.weights) w /= sum;
  }
  return taps;
}

}  // namespace

Image::Image(int width_px, int height_px, int channel_count, float fill)
    : width(width_px), height(height_px), channels(channel_count) {
  LUM_CHECK(width >= 0 && height >= 0 && channels >= 0, "sizes are counted, not read");
  data.assign(pixels() * static_cast<std::size_t>(channels), fill);
}

float srgb_from_linear(float linear) {
  const float v = std::clamp(linear, 0.0F, 1.0F);
  return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
}

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

Image resized(const Image& image, int width, int height) {
  if (image.width == width && image.height == height) return image;
  return filtered_columns(filtered_columns(image, resize_taps(image.width, width)), resize_taps(image.height, height));
}

Image blurred(const Image& image, float sigma_px) {
  if (!(sigma_px > 0.0F) || image.empty()) return image;
  return filtered_columns(filtered_columns(image, gaussian_taps(image.width, sigma_px)),
                          gaussian_taps(image.height, sigma_px));
}

}  // namespace luminist
