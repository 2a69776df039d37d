#pragma once
// prep/stroke_mesh.h -- a mesh with places for strokes, made once and kept in a file.
#include <filesystem>
#include <vector>

#include "scene/mesh.h"

namespace luminist {

/// What a picture needs of an unwrapped mesh.
struct StrokeMesh {
  Mesh mesh;                  ///< the repaired surface, vertices split where charts meet
  std::vector<Vec2> strokes;  ///< [vertices] as of Unwrapped
};

/// unwrap() of the mesh, or what it made of the same mesh before: files in `cache` are named by content. An empty cache
/// keeps nothing; one that cannot be read or written is done without. Damaged files are made anew.
/// cost reading the file, or that of unwrap().
StrokeMesh stroke_mesh(const Mesh& mesh, const std::filesystem::path& cache);

}  // namespace luminist
