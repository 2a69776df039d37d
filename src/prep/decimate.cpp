#include "prep/decimate.h"

#include "prep/half_edges.h"  // first: OpenMesh's tools need its mesh types

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cmath>

namespace luminist {

Mesh decimate(const Mesh& mesh, std::size_t triangle_budget) {
  using Decimater = OpenMesh::Decimater::DecimaterT<TriangleMesh>;
  const QuietOpenMesh quiet;
  TriangleMesh half_edges;
  const auto joined = joined_positions(mesh.positions);
  // Faces that are no part of a manifold stay out: a proxy without them is a proxy still.
  (void)add_faces<TriangleMesh, 3>(half_edges, mesh.positions, joined,
                                   std::span<const std::array<std::uint32_t, 3>>(mesh.triangles));
  if (half_edges.n_faces() > triangle_budget) {
    half_edges.request_face_normals();
    half_edges.update_face_normals();
    Decimater decimater(half_edges);
    OpenMesh::Decimater::ModQuadricT<TriangleMesh>::Handle quadric;
    OpenMesh::Decimater::ModNormalFlippingT<TriangleMesh>::Handle flipping;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    decimater.add(flipping);
    decimater.module(flipping).set_max_normal_deviation(75.0F);
    decimater.initialize();
    decimater.decimate_to_faces(0, triangle_budget);
    half_edges.garbage_collection();
  }
  return triangles_of(half_edges);
}

Mesh decimate_to(const Mesh& mesh, double share) {
  LUM_CHECK(share > 0.0 && share <= 1.0, "a share of the triangles");
  constexpr double kLeastTriangles = 4.0;
  const double budget = std::max(std::round(share * static_cast<double>(mesh.triangles.size())), kLeastTriangles);
  return decimate(mesh, static_cast<std::size_t>(budget));
}

}  // namespace luminist
