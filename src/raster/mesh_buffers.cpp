#include "raster/mesh_buffers.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "base/check.h"
#include "base/files.h"
#include "prep/stroke_mesh.h"
#include "surface/shadow_caster.h"

namespace luminist {
namespace {

/// What a vertex has besides its position. The order is that of shaders/raster/deep.vert.
struct VertexAttributes {
  Vec3 normal;
  Vec2 uv{0.0F};
  Vec4 tangent{0.0F};
  Vec2 stroke{0.0F};
};

/// Where a mesh lies in the common buffers.
struct MeshRange {
  GLint base_vertex = 0;
  std::size_t first_index = 0;
  std::size_t index_count = 0;
  Box bounds;
};

/// The vertices and triangles of all meshes, one after the other.
struct Lists {
  std::vector<Vec3> positions;
  std::vector<VertexAttributes> attributes;
  std::vector<std::uint32_t> indices;
};

void append_triangles(const Mesh& mesh, std::vector<std::uint32_t>& indices) {
  const std::size_t count = mesh.positions.size();
  for (const auto& [a, b, c] : mesh.triangles) {
    if (a >= count || b >= count || c >= count) continue;
    const Vec3 face = glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    const bool turned = glm::dot(face, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]) < 0.0F;
    indices.insert(indices.end(), {a, turned ? c : b, turned ? b : c});
  }
}

MeshRange append(const Mesh& mesh, Lists& lists) {
  LUM_CHECK(mesh.normals.size() == mesh.positions.size(), "loading fills normals");
  MeshRange range;
  range.base_vertex = static_cast<GLint>(lists.positions.size());
  range.first_index = lists.indices.size();
  lists.positions.insert(lists.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    VertexAttributes vertex{mesh.normals[i]};
    if (!mesh.uvs.empty()) vertex.uv = mesh.uvs[i];
    if (!mesh.tangents.empty()) vertex.tangent = mesh.tangents[i];
    lists.attributes.push_back(vertex);
  }
  append_triangles(mesh, lists.indices);
  range.index_count = lists.indices.size() - range.first_index;
  range.bounds = mesh.bounds();
  return range;
}

/// Whether some object shows the mesh with a normal texture and the mesh cannot say yet how the texture lies on it.
bool needs_tangents(const Scene& scene, int mesh_index) {
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(mesh_index)];
  if (!mesh.tangents.empty() || mesh.uvs.empty()) return false;
  for (const Object& object : scene.objects) {
    const Material& material = scene.materials[static_cast<std::size_t>(object.material)];
    if (object.mesh == mesh_index && material.normal_texture >= 0) return true;
  }
  return false;
}

MeshRange append_mesh(const Scene& scene, int mesh_index, bool strokes, Lists& lists) {
  const Mesh& mesh = scene.meshes[static_cast<std::size_t>(mesh_index)];
  const bool tangents = needs_tangents(scene, mesh_index);
  if (!tangents && !strokes) return append(mesh, lists);
  Mesh copy = mesh;
  if (tangents) compute_tangents(copy);
  if (!strokes) return append(copy, lists);
  const StrokeMesh made = stroke_mesh(copy, cache_folder());
  const MeshRange range = append(made.mesh, lists);
  for (std::size_t i = 0; i < made.strokes.size(); ++i) {
    lists.attributes[static_cast<std::size_t>(range.base_vertex) + i].stroke = made.strokes[i];
  }
  return range;
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Triangles as they are wound, of positions that begin at base_vertex.
MeshRange append_wound(const Triangles& triangles, GLint base_vertex, const Box& bounds, Lists& lists) {
  MeshRange range{base_vertex, lists.indices.size(), 3 * triangles.size(), bounds};
  for (const auto& t : triangles) lists.indices.insert(lists.indices.end(), t.begin(), t.end());
  return range;
}

/// A shadow mesh in the common buffers.
struct CasterRanges {
  MeshRange closed;
  MeshRange open;
  ShadowCaster caster;
};

CasterRanges append_caster(const Mesh& mesh, Lists& lists) {
  CasterRanges ranges;
  ranges.caster = shadow_caster(mesh);
  const auto base_vertex = static_cast<GLint>(lists.positions.size());
  lists.positions.insert(lists.positions.end(), ranges.caster.positions.begin(), ranges.caster.positions.end());
  lists.attributes.resize(lists.positions.size());
  Box bounds;
  for (const Vec3& position : ranges.caster.positions) bounds.extend(position);
  ranges.closed = append_wound(ranges.caster.closed, base_vertex, bounds, lists);
  ranges.open = append_wound(ranges.caster.open, base_vertex, bounds, lists);
  return ranges;
}

MeshDraw draw_of(const Scene& scene, std::size_t index, const MeshRange& range, bool leaving) {
  const Object& object = scene.objects[index];
  return {static_cast<std::uint32_t>(index),
          static_cast<std::uint32_t>(object.material),
          static_cast<GLsizei>(range.index_count),
          range.first_index * sizeof(std::uint32_t),
          range.base_vertex,
          object.world_from_object,
          leaving,
          range.bounds};
}

struct Draws {
  std::vector<MeshDraw> seen;
  std::vector<MeshDraw> blocking;
  std::vector<float> slack;  ///< [objects]
};

/// What objects show, and what blocks light in their stead.
Draws append_objects(const Scene& scene, bool strokes, Lists& lists) {
  Draws draws;
  std::map<int, MeshRange> shown;
  std::map<int, CasterRanges> casters;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const auto [range, is_new] = shown.try_emplace(object.mesh);
    if (is_new) range->second = append_mesh(scene, object.mesh, strokes, lists);
    draws.seen.push_back(draw_of(scene, i, range->second, false));
    draws.slack.push_back(0.0F);
    if (object.shadow_mesh < 0) {
      draws.blocking.push_back(draws.seen.back());
      continue;
    }
    const auto [caster, is_first] = casters.try_emplace(object.shadow_mesh);
    CasterRanges& ranges = caster->second;
    if (is_first) ranges = append_caster(scene.meshes[static_cast<std::size_t>(object.shadow_mesh)], lists);
    draws.blocking.push_back(draw_of(scene, i, ranges.closed, true));
    draws.blocking.push_back(draw_of(scene, i, ranges.open, false));
    draws.slack.back() = world_slack(ranges.caster, object.world_from_object);
  }
  std::erase_if(draws.blocking, [](const MeshDraw& draw) { return draw.index_count == 0; });
  return draws;
}

}  // namespace

Mat3 normal_matrix(const Mat3& linear) {
  const Mat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                       glm::cross(linear[0], linear[1]));
  return glm::determinant(linear) < 0.0F ? -cofactors : cofactors;
}

Result<MeshBuffers> MeshBuffers::create(Device& device, const Scene& scene, bool strokes) {
  Lists lists;
  MeshBuffers meshes;
  Draws draws = append_objects(scene, strokes, lists);
  meshes.draws_ = std::move(draws.seen);
  meshes.shadow_draws_ = std::move(draws.blocking);
  if (lists.positions.size() > std::numeric_limits<GLint>::max()) {
    return Error{ErrorKind::kLimit, "the scene has too many vertices for the graphics device", "", "", ""};
  }

  meshes.bounds_ = scene.bounds(true);
  meshes.shadow_bounds_ = scene.shadow_bounds();
  const Box seen = scene.bounds();
  meshes.shadow_frame_ = {seen.center(), std::max(seen.radius(), 1e-6F)};

  const auto vertex_buffer = [&device](const auto& values, const char* label) {
    return GlBuffer::create(device, BufferUse::kVertex, std::span(values), label);
  };
  LUM_TRY(meshes.positions_, vertex_buffer(std::as_const(lists.positions), "vertex positions"));
  LUM_TRY(meshes.attributes_, vertex_buffer(std::as_const(lists.attributes), "vertex attributes"));
  LUM_TRY(meshes.indices_, vertex_buffer(std::as_const(lists.indices), "triangles"));

  LUM_TRY(meshes.shadow_slack_,
          GlBuffer::create(device, BufferUse::kStorage, std::span(std::as_const(draws.slack)), "shadow meshes"));

  meshes.positions_only_ = GlVertexArray::create(device, "positions");
  meshes.full_ = GlVertexArray::create(device, "vertices");
  for (GlVertexArray* array : {&meshes.positions_only_, &meshes.full_}) {
    array->set_vertices(0, meshes.positions_, sizeof(Vec3));
    array->set_attribute(0, 0, 3, 0);
    array->set_indices(meshes.indices_);
  }
  meshes.full_.set_vertices(1, meshes.attributes_, sizeof(VertexAttributes));
  meshes.full_.set_attribute(1, 1, 3, offsetof(VertexAttributes, normal));
  meshes.full_.set_attribute(2, 1, 2, offsetof(VertexAttributes, uv));
  meshes.full_.set_attribute(3, 1, 4, offsetof(VertexAttributes, tangent));
  meshes.full_.set_attribute(4, 1, 2, offsetof(VertexAttributes, stroke));
  return meshes;
}

void draw_mesh(SettledDrawing& drawing, const MeshDraw& mesh) {
  drawing.triangles(mesh.index_count, mesh.index_offset, mesh.base_vertex);
}

}  // namespace luminist
