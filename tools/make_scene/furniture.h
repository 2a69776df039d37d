#pragma once
// make_scene/furniture.h -- turned, swept and subdivided furniture. Metres; everything stands on y = 0, its front to
// +Z.
#include "make_scene/surface.h"

namespace luminist {

/// A round table 0.74 high with a moulded edge on a turned column and three scrolled feet.
Mesh table_mesh(float radius);

/// A chair with a slatted back: legs and stiles, 0.92 high. The seat is apart.
Mesh chair_frame();
Mesh chair_seat();

/// A bookcase without its books: width x 1.9 x 0.3, `boards` boards between foot and top.
Mesh bookcase_mesh(float width, int boards);
/// Height of the upper face of board i, counted from below.
float board_height(int board, int boards);

/// An upholstered armchair from subdivided cushions, 0.86 wide; its wooden feet are apart.
Mesh armchair_mesh();
Mesh armchair_feet();

/// A cushion about the origin: a box of half extents whose faces swell by `crown`, edges as round as `softness` in
/// (0,1) says; a subdivided cage, no texture coordinates.
Mesh cushion(const Vec3& half, float crown, float softness);

}  // namespace luminist
