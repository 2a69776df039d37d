#pragma once
// paint/importance.h -- how much each pixel counts: implied by two controls, or painted (paper, section 4.2).
#include <cstddef>

#include "base/image.h"

namespace luminist {

/// I = 1 where painted, else (1 - delta) nu + delta I_p; importance paint lies over that and wins wherever it is,
/// whenever it was put there, so that nu and delta stay adjustable below it.
struct ImportanceMap {
  float nu = 0.1F;
  float delta = 0.5F;
  Image previous;  ///< I_p, 1 channel; empty until a solve is accepted, which means nu everywhere
  Image paint;     ///< 2 channels: value x weight, weight; empty if there is none

  [[nodiscard]] float implied(std::size_t pixel, bool painted) const;
  [[nodiscard]] float at(std::size_t pixel, bool painted) const;
  /// What importance paint makes of what counts below it.
  [[nodiscard]] float over(std::size_t pixel, float below) const;
};

/// Puts paint down on importance paint (value x weight, weight). amount in [0,1].
void put_importance(Image& paint, std::size_t pixel, float value, float amount);
/// Takes it away; what was there before, below, comes back. below: the same planes, or null for none.
void erase_importance(Image& paint, std::size_t pixel, float amount, const Image* below);

}  // namespace luminist
