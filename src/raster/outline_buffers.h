#pragma once
// raster/outline_buffers.h -- the hulls of a scene's meshes in graphics memory, for the silhouettes of outlines.
#include <vector>

#include "gpu/device.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_vertex_array.h"
#include "raster/mesh_buffers.h"
#include "scene/scene.h"

namespace luminist {

class OutlineBuffers {
 public:
  /// Of every object; backdrops have no outline. errors kLimit. cost outline_hull() of every mesh.
  static Result<OutlineBuffers> create(Device& device, const Scene& scene);

  /// Triangles of the hulls. Inputs 0: position vec3, 1: direction vec3, 2: width float.
  [[nodiscard]] const std::vector<MeshDraw>& hulls() const { return hulls_; }
  void bind_hulls() const { hull_array_.bind(); }
  /// Two triangles for each edge that bends. Inputs 0: position vec3, 1: other end vec3, 2: width float, 3: side float
  /// (-1 or 1, across the way to the other end), 4: angle float.
  [[nodiscard]] const std::vector<MeshDraw>& edges() const { return edges_; }
  void bind_edges() const { edge_array_.bind(); }

 private:
  OutlineBuffers() = default;
  GlBuffer hull_vertices_;
  GlBuffer hull_indices_;
  GlVertexArray hull_array_;
  GlBuffer edge_vertices_;
  GlBuffer edge_indices_;
  GlVertexArray edge_array_;
  std::vector<MeshDraw> hulls_;
  std::vector<MeshDraw> edges_;
};

}  // namespace luminist
