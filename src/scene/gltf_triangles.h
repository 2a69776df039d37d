#pragma once
// scene/gltf_triangles.h -- what a primitive's corners mean, and meshes made of several.
#include <array>
#include <cstdint>
#include <vector>

#include "scene/mesh.h"

namespace luminist {

/// The triangles of a strip, a fan or a list of corners. mode: glTF's number for it.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const std::vector<std::uint32_t>& corners, int mode);

/// Positions, normals and triangles of a mesh behind those of another: all that blocks light.
void append(const Mesh& mesh, Mesh& to);

}  // namespace luminist
