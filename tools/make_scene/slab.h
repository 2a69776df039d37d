#pragma once
// make_scene/slab.h -- boxes with rounded edges: planks, table tops, books.
#include "make_scene/surface.h"

namespace luminist {

/// A box about the origin with half extents, edges rounded by `bevel`. Texture coordinates are planar on each face, in
/// units of `texture_size` (scene units that a texture spans); the texture's u runs along the longest extent. cost
/// about 300 triangles.
Mesh slab(const Vec3& half, float bevel, float texture_size = 1.0F);

/// The same, moved; texture coordinates start at `offset`, so that no two planks show one grain.
Mesh slab_at(const Vec3& center, const Vec3& half, float bevel, float texture_size = 1.0F, const Vec2& offset = {0, 0});

}  // namespace luminist
