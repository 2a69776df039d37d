#pragma once
// app/display.h -- from scene-linear numbers to the 8 bits of a screen.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/image.h"

namespace luminist {

/// How light becomes a screen's colours, after the exposure.
enum class ViewTransform {
  kStandard,  ///< sRGB, clipped at 1
  kSoft,  ///< sRGB with a shoulder: x up to 0.6, from there towards 1 without end, so that highlights keep their form
  kRaw,   ///< the numbers themselves, clipped: for data
};
std::span<const std::string> view_transform_names();

struct DisplayOptions {
  float exposure = 0.0F;  ///< stops
  ViewTransform transform = ViewTransform::kStandard;
  bool operator==(const DisplayOptions&) const = default;
};

/// A table over the upper bits of a float: a value is looked up, not computed. cost of making one: 262,144 powers.
class DisplayTable {
 public:
  explicit DisplayTable(const DisplayOptions& options);
  [[nodiscard]] const DisplayOptions& options() const { return options_; }
  /// One channel; what is negative or no number is 0. Within a step of the exact code (10 bits of mantissa).
  [[nodiscard]] std::uint8_t operator()(float linear) const;

 private:
  DisplayOptions options_;
  std::vector<std::uint8_t> codes_;
};

/// The value that a table holds, exactly.
float displayed(float linear, const DisplayOptions& options);

/// An image of 1 or 3 channels as opaque RGBA, row 0 first. out [image.pixels()]. cost O(pixels)
void to_display(const Image& image, const DisplayTable& table, std::span<std::uint32_t> out);

}  // namespace luminist
