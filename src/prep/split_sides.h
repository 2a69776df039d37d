#pragma once
// prep/split_sides.h -- more vertices on the same surface.
#include "scene/mesh.h"

namespace luminist {

/// Splits triangles until no side is longer than `longest` or there are `most_triangles`; sides at one place are split
/// alike, so no cracks open. New vertices lie in the middle of sides, behind the old ones, and have the mean of what
/// their ends have. cost O(result).
void split_long_sides(Mesh& mesh, float longest, std::size_t most_triangles);

}  // namespace luminist
