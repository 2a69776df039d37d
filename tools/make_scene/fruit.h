#pragma once
// make_scene/fruit.h -- fruit and what it is painted with. All stand on y = 0, upright; lengths in metres.
#include <cstdint>

#include "base/image.h"
#include "make_scene/surface.h"

namespace luminist {

/// 0.078 wide, 0.068 high: a dip around the stem, five lobes below. seed changes the lean and the lobes.
Mesh apple_mesh(std::uint64_t seed);
Mesh apple_stem_mesh(std::uint64_t seed);
/// Red streaks over yellow; `blush` in [0,1] is how much of the skin is red.
Image apple_painting(int width, int height, double blush);

/// 0.076 wide, slightly flat.
Mesh orange_mesh();
Image orange_painting(int width, int height);
Image orange_pores(int width, int height);  ///< a normal map

/// 0.066 wide, 0.105 high with its stem, leaning.
Mesh pear_mesh();
Mesh pear_stem_mesh();
Image pear_painting(int width, int height);

/// A bunch of `count` berries that rest on y = 0, heaped along +X from its stem at x = 0.
Mesh grapes_mesh(int count, std::uint64_t seed);
Mesh grape_stems_mesh();
Image grape_painting(int width, int height);

}  // namespace luminist
