#pragma once
// make_scene/slab.h -- boxes with rounded edges: planks, table tops, books.
#include "make_scene/surface.h"

namespace luminist {

/// A box about the origin with half extents, edges rounded by `bevel` in so many steps. Texture coordinates are planar
/// on each face, in units of `texture_size` (scene units that a texture spans); the texture's u runs along the longest
/// extent. cost 12 (2 bevel_steps + 1)^2 triangles.
Mesh slab(const Vec3& half, float bevel, float texture_size = 1.0F, int bevel_steps = 2);

/// The same, moved; texture coordinates start at `offset`, so that no two planks show one grain.
Mesh slab_at(const Vec3& center, const Vec3& half, float bevel, float texture_size = 1.0F, const Vec2& offset = {0, 0},
             int bevel_steps = 2);

}  // namespace luminist
