#pragma once
// prep/half_edges.h -- our meshes as OpenMesh's and back. For the sources of prep only.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include <OpenMesh/Core/IO/MeshIO.hh>  // first: OpenMesh wants it before its mesh types
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "base/check.h"
#include "scene/mesh.h"

namespace luminist {

using TriangleMesh = OpenMesh::TriMesh_ArrayKernelT<>;
using PolygonMesh = OpenMesh::PolyMesh_ArrayKernelT<>;

/// OpenMesh reports on streams of its own; they are silent while this lives.
class QuietOpenMesh {
 public:
  QuietOpenMesh() { omlog().disable(), omout().disable(), omerr().disable(); }
  ~QuietOpenMesh() { omlog().enable(), omout().enable(), omerr().enable(); }
  QuietOpenMesh(const QuietOpenMesh&) = delete;
  QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;
};

inline constexpr std::size_t kNoFault = static_cast<std::size_t>(-1);

/// For every position the index of the first at the same place (the same bits, -0 as 0).
std::vector<std::uint32_t> joined_positions(std::span<const Vec3> positions);

/// Adds vertices that faces use and the faces; corners are N or fewer (the last repeated), faces with fewer than three
/// different corners are skipped. returns the number of the first face that is no part of a manifold, or kNoFault.
template <class HalfEdges, std::size_t N>
std::size_t add_faces(HalfEdges& half_edges, std::span<const Vec3> positions, std::span<const std::uint32_t> joined,
                      std::span<const std::array<std::uint32_t, N>> faces) {
  std::unordered_map<std::uint32_t, typename HalfEdges::VertexHandle> handles;
  std::size_t fault = kNoFault;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t corner : faces[f]) {
      LUM_CHECK(corner < positions.size(), "callers check indices");
      const std::uint32_t at = joined[corner];
      if (std::find(corners.begin(), corners.end(), at) == corners.end()) corners.push_back(at);
    }
    if (corners.size() < 3) continue;
    std::vector<typename HalfEdges::VertexHandle> loop;
    for (const std::uint32_t at : corners) {
      auto [entry, is_new] = handles.try_emplace(at);
      const Vec3& p = positions[at];
      if (is_new) entry->second = half_edges.add_vertex(typename HalfEdges::Point(p.x, p.y, p.z));
      loop.push_back(entry->second);
    }
    if (!half_edges.add_face(loop).is_valid() && fault == kNoFault) fault = f;
  }
  return fault;
}

/// The live triangles with smooth normals; polygons are split into fans, vertices without a face left out.
template <class HalfEdges>
Mesh triangles_of(const HalfEdges& half_edges) {
  Mesh mesh;
  std::vector<std::uint32_t> index(half_edges.n_vertices(), 0);
  for (const auto v : half_edges.vertices()) {
    if (half_edges.is_isolated(v)) continue;
    index[static_cast<std::size_t>(v.idx())] = static_cast<std::uint32_t>(mesh.positions.size());
    const auto p = half_edges.point(v);
    mesh.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : half_edges.faces()) {
    std::vector<std::uint32_t> corners;
    for (const auto v : half_edges.fv_range(f)) corners.push_back(index[static_cast<std::size_t>(v.idx())]);
    for (std::size_t i = 2; i < corners.size(); ++i) mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }
  compute_normals(mesh, kPi);
  return mesh;
}

}  // namespace luminist
