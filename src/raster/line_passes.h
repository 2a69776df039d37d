#pragma once
// raster/line_passes.h -- lines in a deep framebuffer: silhouettes and creases as geometry, others found on the
// picture.
#include "base/files.h"
#include "gpu/device.h"
#include "gpu/gl_texture.h"
#include "gpu/program.h"
#include "gpu/settled_drawing.h"
#include "raster/line_spec.h"
#include "raster/outline_buffers.h"
#include "scene/scene.h"

namespace luminist {

/// What a deep framebuffer needs to draw lines. Buffers outlive it.
struct DeepLines {
  const OutlineBuffers* outlines = nullptr;
  LineSpec spec;
  SceneFrame frame;
};

/// A hull is drawn after the model with only the triangles that face away (and the strips along open borders), so that
/// it shows around the model and nowhere on it. Creases are the mesh's own sharp edges, as ribbons that face the eye:
/// what is found on the picture flickers where an edge is rounded or seen from the side. A pass over the samples marks
/// intersections and material borders, half of the width to each side, measured between samples of all layers: a
/// quarter of a pixel is seen. Objects that nearly touch count as meeting, because no hull fits between them.
class LinePasses {
 public:
  /// The textures have rows of one band. errors kLimit; kMissing, kStyle for damaged shaders.
  static Result<LinePasses> create(Device& device, const AssetRoots& roots, const DeepLines& lines, const Scene& scene,
                                   const Camera& camera, int width, int height, int band_rows, int layers);

  /// How far lines may reach from the model that is at most that deep in the picture, world.
  [[nodiscard]] float reach(float depth) const;
  /// Draws silhouettes and creases over what the bound framebuffer holds, with the depth test as it is set.
  void draw(SettledDrawing& drawing, const Mat4& clip_from_world);
  /// Marks the other lines of a band whose samples are bound (DeepPasses::bind()), which `set_band` locates.
  void mark(Device& device, std::size_t pixels);
  [[nodiscard]] Program& marking() { return mark_program_; }
  void bind(GLuint unit) const { kinds_.bind(unit); }

 private:
  LinePasses() = default;
  void draw_silhouettes(SettledDrawing& drawing, const Mat4& clip_from_world);
  void draw_creases(SettledDrawing& drawing, const Mat4& clip_from_world);
  void set_width(Program& program, float width) const;
  void set_object(Program& program, const MeshDraw& draw) const;
  /// World width of a silhouette at the scene's centre.
  [[nodiscard]] float width_at_centre() const;

  DeepLines lines_;
  const Scene* scene_ = nullptr;
  Vec3 eye_{0.0F};
  float reference_depth_ = 1.0F;  ///< of the scene's centre
  float pixel_angle_ = 0.0F;      ///< width of a pixel at distance 1
  int height_ = 0;
  Program silhouette_program_;
  Program crease_program_;
  Program mark_program_;
  GlTexture kinds_;  ///< LINE_... per sample, without silhouettes
};

}  // namespace luminist
