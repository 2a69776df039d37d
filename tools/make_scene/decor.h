#pragma once
// make_scene/decor.h -- what makes a room lived in: a mirror, books, a plant, pictures, a rug. Metres.
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "make_scene/surface.h"

namespace luminist {

/// An oval on z = 0 that faces +Z, half extents (a, b), and its moulded frame.
Mesh mirror_glass(double a, double b);
Mesh mirror_frame(double a, double b);

/// Books of one of `colors` bindings on a board: along x in [-half, half], spines at z = 0, standing on y = 0; some
/// lean.
Mesh books_on_board(float half, float height, int color, int colors, std::uint64_t seed);

/// A pot on y = 0 and the leaves of a rubber plant about it.
Mesh pot_mesh();
Mesh leaves_mesh(int leaves, std::uint64_t seed);
Mesh plant_stems(int leaves, std::uint64_t seed);
Image leaf_painting(int width, int height);

/// A landscape in the manner of a small oil, and a bound-weave rug.
Image landscape_painting(int width, int height);
Image rug_painting(int width, int height);
Mesh rug_mesh(float half_x, float half_z);

}  // namespace luminist
