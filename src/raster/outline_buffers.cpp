#include "raster/outline_buffers.h"

#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "surface/outline_hull.h"

namespace luminist {
namespace {

struct HullVertex {
  Vec3 position;
  Vec3 direction;
  float width = 1.0F;
};

struct EdgeVertex {
  Vec3 position;
  Vec3 other;
  float width = 1.0F;
  float side = 1.0F;
  float angle = 0.0F;
};

template <class Vertex>
struct OutlineLists {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;

  /// The range that the next vertices and indices will be in.
  [[nodiscard]] MeshDraw begin() const {
    MeshDraw draw;
    draw.base_vertex = static_cast<GLint>(vertices.size());
    draw.index_offset = indices.size() * sizeof(std::uint32_t);
    return draw;
  }
  void end(MeshDraw& draw) const {
    draw.index_count = static_cast<GLsizei>(indices.size() - draw.index_offset / sizeof(std::uint32_t));
  }
};

MeshDraw append_hull(const OutlineHull& hull, OutlineLists<HullVertex>& lists) {
  MeshDraw draw = lists.begin();
  for (std::size_t v = 0; v < hull.positions.size(); ++v) {
    lists.vertices.push_back({hull.positions[v], hull.directions[v], hull.widths[v]});
  }
  for (const auto& [a, b, c] : hull.triangles) lists.indices.insert(lists.indices.end(), {a, b, c});
  lists.end(draw);
  return draw;
}

MeshDraw append_edges(const OutlineHull& hull, OutlineLists<EdgeVertex>& lists) {
  MeshDraw draw = lists.begin();
  std::uint32_t first = 0;
  for (const OutlineHull::Edge& edge : hull.edges) {
    for (const auto& [here, there] : {std::pair(edge.from, edge.to), std::pair(edge.to, edge.from)}) {
      for (const float side : {-1.0F, 1.0F}) {
        lists.vertices.push_back({hull.positions[here], hull.positions[there], hull.widths[here], side, edge.angle});
      }
    }
    lists.indices.insert(lists.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    first += 4;
  }
  lists.end(draw);
  return draw;
}

}  // namespace

Result<OutlineBuffers> OutlineBuffers::create(Device& device, const Scene& scene) {
  OutlineBuffers outlines;
  OutlineLists<HullVertex> hulls;
  OutlineLists<EdgeVertex> edges;
  std::map<std::pair<int, int>, std::pair<MeshDraw, MeshDraw>> of_mesh;  // of a mesh with a mask
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    if (object.backdrop) continue;
    const int mask = scene.materials[static_cast<std::size_t>(object.material)].line_width_texture;
    const std::pair key(object.mesh, mask);
    if (!of_mesh.contains(key)) {
      const Texture* texture = mask >= 0 ? &scene.textures[static_cast<std::size_t>(mask)] : nullptr;
      const OutlineHull hull = outline_hull(scene.meshes[static_cast<std::size_t>(object.mesh)], texture);
      of_mesh[key] = {append_hull(hull, hulls), append_edges(hull, edges)};
    }
    auto [hull, edge] = of_mesh[key];
    for (MeshDraw* draw : {&hull, &edge}) {
      draw->object = static_cast<std::uint32_t>(i);
      draw->material = static_cast<std::uint32_t>(object.material);
      draw->world_from_object = object.world_from_object;
    }
    outlines.hulls_.push_back(hull);
    outlines.edges_.push_back(edge);
  }
  const auto upload = [&device](const auto& values, const char* label) {
    return GlBuffer::create(device, BufferUse::kVertex, std::span(values), label);
  };
  LUM_TRY(outlines.hull_vertices_, upload(std::as_const(hulls.vertices), "hull vertices"));
  LUM_TRY(outlines.hull_indices_, upload(std::as_const(hulls.indices), "hull triangles"));
  LUM_TRY(outlines.edge_vertices_, upload(std::as_const(edges.vertices), "edge vertices"));
  LUM_TRY(outlines.edge_indices_, upload(std::as_const(edges.indices), "edge triangles"));
  GlVertexArray& hull_array = outlines.hull_array_ = GlVertexArray::create(device, "hulls");
  hull_array.set_vertices(0, outlines.hull_vertices_, sizeof(HullVertex));
  hull_array.set_attribute(0, 0, 3, offsetof(HullVertex, position));
  hull_array.set_attribute(1, 0, 3, offsetof(HullVertex, direction));
  hull_array.set_attribute(2, 0, 1, offsetof(HullVertex, width));
  hull_array.set_indices(outlines.hull_indices_);
  GlVertexArray& edge_array = outlines.edge_array_ = GlVertexArray::create(device, "edges");
  edge_array.set_vertices(0, outlines.edge_vertices_, sizeof(EdgeVertex));
  edge_array.set_attribute(0, 0, 3, offsetof(EdgeVertex, position));
  edge_array.set_attribute(1, 0, 3, offsetof(EdgeVertex, other));
  edge_array.set_attribute(2, 0, 1, offsetof(EdgeVertex, width));
  edge_array.set_attribute(3, 0, 1, offsetof(EdgeVertex, side));
  edge_array.set_attribute(4, 0, 1, offsetof(EdgeVertex, angle));
  edge_array.set_indices(outlines.edge_indices_);
  return outlines;
}

}  // namespace luminist
