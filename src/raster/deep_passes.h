#pragma once
// raster/deep_passes.h -- the drawing behind a deep framebuffer: a band of the picture, in five passes.
#include <cstddef>
#include <optional>
#include <vector>

#include "base/files.h"
#include "gpu/device.h"
#include "gpu/gl_framebuffer.h"
#include "gpu/gl_texture.h"
#include "gpu/program.h"
#include "raster/line_passes.h"
#include "raster/mesh_buffers.h"
#include "scene/scene.h"

namespace luminist {

/// What a deep framebuffer holds beyond what every style reads.
struct DeepExtras {
  bool strokes = false;
  float radius = 1.0F;  ///< of the scene's frame, which measures strokes
  std::optional<DeepLines> lines;
};

/// A picture is drawn in horizontal bands, so that the passes' textures (of all attributes, five layers) stay below a
/// budget of bytes. Rows of bands count from the bottom, as OpenGL does.
class DeepPasses {
 public:
  static constexpr int kLayers = 5;  ///< pixel centres, and DeepFramebuffer::kEdgeOffsets

  /// Uploads the textures of the scene's materials, which go with this object.
  /// errors kLimit for a picture or memory that is too large; kMissing, kStyle for damaged shaders.
  static Result<DeepPasses> create(Device& device, const AssetRoots& roots, const MeshBuffers& meshes,
                                   const Scene& scene, const Camera& camera, int width, int height,
                                   const DeepExtras& extras, std::size_t band_bytes);

  [[nodiscard]] int band_count() const { return (height_ + band_rows_ - 1) / band_rows_; }
  [[nodiscard]] int first_row(int band) const { return band * band_rows_; }
  /// Rows of one band; the last may have fewer.
  [[nodiscard]] int rows(int band) const;

  /// Fills the textures with one band, unless they hold it already.
  void draw(Device& device, int band);
  /// Binds the textures to units 0 to 7: position, normal, albedo, specular, emissive, ids, lines, strokes.
  void bind() const;
  /// Uniforms that locate a pixel of the band (shaders/raster/deep_samples.glsl).
  void set_band(Program& program, int band) const;

 private:
  DeepPasses() = default;
  Result<void> create_targets(Device& device);
  Result<void> upload_textures(Device& device);
  void draw_layer(const Device& device, int layer, int first_row);
  void draw_models(SettledDrawing& drawing, const Mat4& clip_from_world);
  /// Rows beyond a band on either side, for what looks at neighbours.
  [[nodiscard]] int margin() const { return lines_ ? kLineMargin : 0; }
  void set_material(const Material& material);

  static constexpr int kLineMargin = 26;  // as far as shaders/raster/lines.comp reaches

  const MeshBuffers* meshes_ = nullptr;
  const Scene* scene_ = nullptr;
  int width_ = 0;
  int height_ = 0;
  int band_rows_ = 0;
  int drawn_band_ = -1;
  Mat4 clip_from_world_{1.0F};
  Vec3 eye_{0.0F};
  float radius_ = 1.0F;
  bool strokes_ = false;
  std::optional<LinePasses> lines_;
  Program program_;
  std::vector<GlTexture> targets_;  ///< one per attribute
  GlTexture depth_;
  std::vector<GlFramebuffer> framebuffers_;  ///< one per layer
  std::vector<GlTexture> textures_;          ///< of the scene; a name of 0 where an image is empty
};

}  // namespace luminist
