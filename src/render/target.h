#pragma once
// render/target.h -- what the artist wants to see, and how much each pixel counts.
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "base/result.h"

namespace luminist {

/// All of one size. Pixels that are not finite count as importance 0 (see sanitize()).
struct Target {
  Image color;                        ///< T: 3 channels, linear RGB
  Image before;                       ///< the picture under the paint, 3 channels
  Image importance;                   ///< I: 1 channel, >= 0
  std::vector<std::uint32_t> stroke;  ///< [pixels] 1 + index of the last stroke that touched it; 0: unpainted
};

struct SanitizeReport {
  std::size_t masked = 0;  ///< pixels with a NaN, an infinity or a negative importance
  int first_x = -1;
  int first_y = -1;
};

/// Masks pixels that cannot be compared: colour becomes that of `before` (0 if that is not finite either), importance
/// 0.
SanitizeReport sanitize(Target& target);
/// The same for one pixel. returns whether it was masked.
bool sanitize_pixel(Target& target, std::size_t pixel);

}  // namespace luminist
