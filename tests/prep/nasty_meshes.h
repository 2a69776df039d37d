#pragma once
// tests/prep/nasty_meshes.h -- meshes of every kind that loaders let through.
#include <ostream>
#include <string>
#include <vector>

#include "scene/mesh.h"

namespace luminist::test {

struct NamedMesh {
  std::string name;
  Mesh mesh;

  friend std::ostream& operator<<(std::ostream& out, const NamedMesh& named) { return out << named.name; }
};

/// Around the z axis, facing outwards, smooth normals.
Mesh torus_mesh(double large, double small, int around, int across);
/// Around the y axis, without lids; vertices are joined all around.
Mesh tube_mesh(double radius, double height, int around, int along);
/// A flat plate with this many square holes: a closed surface of that genus.
Mesh plate_with_holes(int holes);
/// A band with one side only.
Mesh moebius_mesh(int steps);

/// The above and a sphere, a cube with split normals, a bow tie of triangles, three pages on one spine, triangles
/// without area and there twice, hundreds of tiny pieces, a crumpled sphere, a heap of triangles at random, a triangle
/// and nothing. Deterministic.
std::vector<NamedMesh> nasty_meshes();

}  // namespace luminist::test
