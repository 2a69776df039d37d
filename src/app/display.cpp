#include "app/display.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace luminist {
namespace {

constexpr int kDropped = 13;  // bits of the mantissa that a code of 8 bits does not show
constexpr float kShoulder = 0.6F;

std::uint32_t opaque(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  return 0xFF000000U | static_cast<std::uint32_t>(b) << 16U | static_cast<std::uint32_t>(g) << 8U | r;
}

}  // namespace

std::span<const std::string> view_transform_names() {
  static const std::array<std::string, 3> names = {"Standard", "Soft highlights", "Raw"};
  return names;
}

float displayed(float linear, const DisplayOptions& options) {
  if (!(linear > 0.0F)) return 0.0F;
  const float x = linear * std::exp2(options.exposure);
  if (options.transform == ViewTransform::kRaw) return std::min(1.0F, x);
  if (options.transform == ViewTransform::kSoft && x > kShoulder) {
    const float room = 1.0F - kShoulder;
    return srgb_from_linear(1.0F - room * room / (x - kShoulder + room));  // of slope 1 where the shoulder begins
  }
  return srgb_from_linear(x);
}

DisplayTable::DisplayTable(const DisplayOptions& options) : options_(options), codes_(1U << (31 - kDropped)) {
  for (std::size_t i = 0; i < codes_.size(); ++i) {
    const auto bits = static_cast<std::uint32_t>(i) << kDropped | 1U << (kDropped - 1);
    const float value = std::bit_cast<float>(bits);  // what lies beyond the numbers is infinity: no NaN is looked up
    codes_[i] = static_cast<std::uint8_t>(std::isnan(value) ? 255.0F : 255.0F * displayed(value, options) + 0.5F);
  }
}

std::uint8_t DisplayTable::operator()(float linear) const {
  return linear > 0.0F ? codes_[std::bit_cast<std::uint32_t>(linear) >> kDropped] : std::uint8_t{0};
}

void to_display(const Image& image, const DisplayTable& table, std::span<std::uint32_t> out) {
  LUM_CHECK(out.size() == image.pixels(), "the caller makes room for every pixel");
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (image.channels == 1) {
      const std::uint8_t grey = table(image.data[i]);
      out[i] = opaque(grey, grey, grey);
    } else {
      const float* rgb = &image.data[3 * i];
      out[i] = opaque(table(rgb[0]), table(rgb[1]), table(rgb[2]));
    }
  }
}

}  // namespace luminist
