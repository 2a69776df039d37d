#pragma once
// raster/mesh_buffers.h -- a scene's triangles in graphics memory, shared by whatever draws them.
#include <cstdint>
#include <vector>

#include "base/math.h"
#include "gpu/device.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_vertex_array.h"
#include "gpu/settled_drawing.h"
#include "scene/scene.h"

namespace luminist {

/// One object of the scene, or what blocks light in its stead, as a range of the index buffer.
struct MeshDraw {
  std::uint32_t object = 0;    ///< index into Scene::objects
  std::uint32_t material = 0;  ///< index into Scene::materials
  GLsizei index_count = 0;
  std::size_t index_offset = 0;  ///< bytes
  GLint base_vertex = 0;
  Mat4 world_from_object{1.0F};
  bool leaving = false;  ///< of a shadow mesh: blocks light only where it leaves, at triangles whose back it meets
  Box bounds{};          ///< of what the buffers hold of it, before world_from_object
};

/// Draws it with the array that is bound.
void draw_mesh(SettledDrawing& drawing, const MeshDraw& mesh);

/// How normals turn with an object: the inverse transpose up to a positive factor, and still right for an object that
/// is flattened to a plane.
Mat3 normal_matrix(const Mat3& linear);

/// Every mesh that is seen once, however many objects show it, and every shadow mesh. Triangles are stored so that they
/// wind counter-clockwise around their vertex normals, whichever way the file had them; triangles with an index out of
/// range are left out.
class MeshBuffers {
 public:
  /// strokes: meshes are unwrapped. errors kLimit if graphics memory runs out. cost O(vertices + triangles), once per
  /// scene; with strokes that of stroke_mesh().
  static Result<MeshBuffers> create(Device& device, const Scene& scene, bool strokes = false);

  [[nodiscard]] const std::vector<MeshDraw>& draws() const { return draws_; }  ///< [objects]
  /// What blocks light: the same, but of shadow meshes for objects that have one (surface/shadow_caster.h), up to two
  /// each.
  [[nodiscard]] const std::vector<MeshDraw>& shadow_draws() const { return shadow_draws_; }
  [[nodiscard]] const Box& bounds() const { return bounds_; }                ///< world, with backdrops; of what is seen
  [[nodiscard]] const Box& shadow_bounds() const { return shadow_bounds_; }  ///< of what blocks light
  /// The sphere around it without backdrops.
  [[nodiscard]] const SceneFrame& shadow_frame() const { return shadow_frame_; }
  /// float [objects]: world_slack() of the mesh that blocks light in the object's stead, 0 if its own does.
  [[nodiscard]] const GlBuffer& shadow_slack() const { return shadow_slack_; }

  /// Inputs 0: position vec3, 1: normal vec3, 2: uv vec2, 3: tangent vec4 (zero without tangents),
  /// 4: stroke vec2, the mesh's units (zero without strokes).
  void bind_full() const { full_.bind(); }
  /// Input 0: position vec3, tightly packed.
  void bind_positions() const { positions_only_.bind(); }

 private:
  MeshBuffers() = default;
  GlBuffer positions_;
  GlBuffer attributes_;
  GlBuffer indices_;
  GlVertexArray full_;
  GlVertexArray positions_only_;
  GlBuffer shadow_slack_;
  std::vector<MeshDraw> draws_;
  std::vector<MeshDraw> shadow_draws_;
  Box bounds_;
  Box shadow_bounds_;
  SceneFrame shadow_frame_;
};

}  // namespace luminist
