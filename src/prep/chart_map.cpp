#include "prep/chart_map.h"

// OpenMesh and its adapter come before all that uses them; the kernel is the one whose points OpenMesh's vectors
// become.
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

#include <cmath>
#include <exception>

#include "base/check.h"

namespace luminist {
namespace {

namespace parameterization = CGAL::Surface_mesh_parameterization;

struct DoublePoints : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using DiscMesh = OpenMesh::TriMesh_ArrayKernelT<DoublePoints>;
using Plane = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Border = parameterization::Circular_border_arc_length_parameterizer_3<DiscMesh>;

/// The disc around the origin with an area of about one, so that no term of a system is large.
DiscMesh half_edges_of(const Disc& disc) {
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : disc.points) middle += p / static_cast<double>(disc.points.size());
  double area = 0.0;
  for (const auto& [a, b, c] : disc.triangles) {
    area += 0.5 * glm::length(glm::cross(disc.points[b] - disc.points[a], disc.points[c] - disc.points[a]));
  }
  const double scale = area > 0.0 ? 1.0 / std::sqrt(area) : 1.0;
  DiscMesh mesh;
  for (const glm::dvec3& point : disc.points) {
    const glm::dvec3 p = scale * (point - middle);
    mesh.add_vertex(OpenMesh::Vec3d(p.x, p.y, p.z));
  }
  for (const auto& t : disc.triangles) {
    mesh.add_face(mesh.vertex_handle(t[0]), mesh.vertex_handle(t[1]), mesh.vertex_handle(t[2]));
  }
  return mesh;
}

template <class Parameterizer>
std::optional<std::vector<glm::dvec2>> run(const Disc& disc, Parameterizer parameterizer) {
  DiscMesh mesh = half_edges_of(disc);
  if (mesh.n_faces() != disc.triangles.size()) return std::nullopt;
  DiscMesh::HalfedgeHandle border;
  for (const auto h : mesh.halfedges()) {
    if (mesh.is_boundary(h)) border = h;
  }
  std::vector<Plane> places(disc.points.size(), Plane(0.0, 0.0));
  std::vector<char> is_fixed(disc.points.size(), 0);
  const auto index = get(boost::vertex_index, mesh);
  const auto place_map = boost::make_iterator_property_map(places.begin(), index);
  const auto fixed_map = boost::make_iterator_property_map(is_fixed.begin(), index);
  if (parameterizer.parameterize(mesh, border, place_map, index, fixed_map) != parameterization::OK) {
    return std::nullopt;
  }
  std::vector<glm::dvec2> result;
  for (const Plane& p : places) {
    if (!std::isfinite(p.x()) || !std::isfinite(p.y())) return std::nullopt;
    result.emplace_back(p.x(), p.y());
  }
  return result;
}

}  // namespace

std::optional<std::vector<glm::dvec2>> map_disc(const Disc& disc, ChartMethod method) {
  try {
    switch (method) {
      case ChartMethod::kRigid:
      case ChartMethod::kAligned:
      case ChartMethod::kArap:
        break;
      case ChartMethod::kLscm:
        return run(disc, parameterization::LSCM_parameterizer_3<DiscMesh>());
      case ChartMethod::kMeanValue:
        return run(disc, parameterization::Mean_value_coordinates_parameterizer_3<DiscMesh, Border>());
      case ChartMethod::kTutte:
        return run(disc, parameterization::Barycentric_mapping_parameterizer_3<DiscMesh, Border>());
    }
  } catch (const std::exception&) {
    return std::nullopt;  // the library's checks throw on surfaces it cannot take
  }
  LUM_CHECK(disc.triangles.size() == 1, "what is rigid is one triangle");
  const auto& [a, b, c] = disc.triangles[0];
  const glm::dvec3 along = disc.points[b] - disc.points[a];
  const glm::dvec3 other = disc.points[c] - disc.points[a];
  const double length = glm::length(along);
  std::vector<glm::dvec2> places(3, glm::dvec2(0.0));
  places[b] = {length, 0.0};
  places[c] = {glm::dot(other, along) / length, glm::length(glm::cross(along, other)) / length};
  return places;
}

}  // namespace luminist
