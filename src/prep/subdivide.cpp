#include "prep/subdivide.h"

#include <cmath>
#include <string>

#include "prep/half_edges.h"  // first: OpenMesh's tools need its mesh types

#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

namespace luminist {
namespace {

constexpr double kTriangleLimit = 20e6;  // that of load_scene()

Result<void> check_growth(std::size_t faces, double triangles_per_face, int levels) {
  LUM_CHECK(levels >= 0, "a number of steps");
  if (static_cast<double>(faces) * triangles_per_face * std::pow(4.0, levels) <= kTriangleLimit) return {};
  return Error{ErrorKind::kLimit, "subdividing would make more than 20 million triangles", "", "levels",
               "use fewer levels"};
}

template <std::size_t N>
Result<void> check_corners(const std::vector<std::array<std::uint32_t, N>>& faces, std::size_t positions) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const std::uint32_t corner : faces[f]) {
      if (corner < positions) continue;
      return Error{
          ErrorKind::kBadContent,
          "face " + std::to_string(f) + " names vertex " + std::to_string(corner) + " of " + std::to_string(positions),
          "", "faces", ""};
    }
  }
  return {};
}

template <class HalfEdges, template <class, class> class Scheme, std::size_t N>
Result<Mesh> subdivided(const std::vector<Vec3>& positions, const std::vector<std::array<std::uint32_t, N>>& faces,
                        int levels) {
  LUM_TRY_VOID(check_corners(faces, positions.size()));
  LUM_TRY_VOID(check_growth(faces.size(), N - 2.0, levels));
  const QuietOpenMesh quiet;
  HalfEdges half_edges;
  const auto joined = joined_positions(positions);
  const std::size_t fault =
      add_faces<HalfEdges, N>(half_edges, positions, joined, std::span<const std::array<std::uint32_t, N>>(faces));
  if (fault != kNoFault) {
    return Error{ErrorKind::kBadContent, "face " + std::to_string(fault) + " makes the surface no manifold", "",
                 "faces", "an edge joins two faces of the same winding"};
  }
  if (levels > 0 && half_edges.n_faces() > 0) {
    Scheme<HalfEdges, float> scheme;
    scheme.attach(half_edges);
    scheme(static_cast<std::size_t>(levels));
    scheme.detach();
  }
  return triangles_of(half_edges);
}

}  // namespace

Result<Mesh> subdivide(const Cage& cage, int levels) {
  return subdivided<PolygonMesh, OpenMesh::Subdivider::Uniform::CatmullClarkT>(cage.positions, cage.faces, levels);
}

Result<Mesh> subdivide_loop(const Mesh& mesh, int levels) {
  return subdivided<TriangleMesh, OpenMesh::Subdivider::Uniform::LoopT>(mesh.positions, mesh.triangles, levels);
}

}  // namespace luminist
