#pragma once
// raster/deep_framebuffer.h -- what one camera sees, kept for shading it again and again (paper, section 6.1).
#include <cstddef>
#include <cstdint>

#include "base/files.h"
#include "base/result.h"
#include "gpu/device.h"
#include "gpu/gl_buffer.h"
#include "raster/deep_passes.h"
#include "raster/mesh_buffers.h"
#include "render/surface_buffer.h"
#include "scene/scene.h"

namespace luminist {

/// The visible surface as a list of samples, in storage buffers of one vec4 per sample (std430).
///
/// Samples 0 .. width*height-1 are the pixel centres, row 0 on top. After them come four samples for each edge pixel:
/// a pixel in which objects, normals, depths or albedos differ so much that one sample would alias. Shading runs over
/// sample_count() samples, and the colour of a pixel is that of its centre, or the mean of its four edge samples.
///
///   position  xyz world, w = uintBitsToFloat(1 + object index); w = 0: nothing is there and all is zero
///   normal    xyz unit shading normal that faces the eye, w = uintBitsToFloat(1 + material index | line << 28),
///             where line is a LINE_... of shaders/lib/surface.glsl
///   albedo    rgb diffuse reflectance = base colour * (1 - metallic), w = roughness
///   specular  rgb reflectance at normal incidence = mix(0.04 specular, base colour, metallic),
///             w = the share of it that has no colour = 0.04 specular (1 - metallic)
///   emissive  rgb radiance, w = 0
///   stroke    xy place on the unwrapped mesh, u along the strokes, in scene radii; zw how much u and v change over a
///             picture height; only where extras ask for it
///   edge_of_pixel  uint per pixel: index of its group of four samples, or kNoEdge; group e starts at sample
///                  width*height + 4 e
///
/// The centres are drawn by a pass of their own, exactly at the pixel centres, because brushes and the solver work on
/// them; four more passes of the same size, shifted by the rotated grid below, give the edge samples. Passes at full
/// size, unlike one of twice the size, filter textures alike for centres and edges, and the rotated grid gives an
/// edge of any slope five grey levels where 2 x 2 would give three.
class DeepFramebuffer {
 public:
  static constexpr std::uint32_t kNoEdge = 0xffffffffU;
  static constexpr int kEdgeSamples = 4;
  /// Memory for drawing, given back afterwards: a picture of a megapixel is drawn in one piece.
  static constexpr std::size_t kBandBytes = std::size_t{512} << 20U;
  /// Where the samples of an edge pixel lie, in pixels from its centre; x to the right, y down.
  static constexpr float kEdgeOffsets[kEdgeSamples][2] = {
      {-0.125F, -0.375F}, {0.375F, -0.125F}, {-0.375F, 0.125F}, {0.125F, 0.375F}};

  /// width, height in pixels. errors kLimit if they exceed the device's textures or storage blocks, or memory runs out;
  /// kMissing, kStyle if the shaders are damaged. cost five passes over the triangles; ten
  /// for a picture that needs more than band_bytes (about 440 bytes a pixel) to be drawn.
  static Result<DeepFramebuffer> create(Device& device, const AssetRoots& roots, const MeshBuffers& meshes,
                                        const Scene& scene, const Camera& camera, int width, int height,
                                        const DeepExtras& extras = {}, std::size_t band_bytes = kBandBytes);

  [[nodiscard]] int width() const { return surface_.width; }
  [[nodiscard]] int height() const { return surface_.height; }
  [[nodiscard]] std::size_t pixel_count() const { return surface_.pixels(); }
  [[nodiscard]] std::size_t edge_count() const { return edge_count_; }  ///< pixels with edge samples
  [[nodiscard]] std::size_t sample_count() const { return pixel_count() + kEdgeSamples * edge_count_; }
  [[nodiscard]] const Vec3& eye() const { return surface_.eye; }
  /// To homogeneous places on the picture: x to the right, y down from the upper left corner, in picture heights.
  [[nodiscard]] const Mat4& screen_from_world() const { return screen_from_world_; }
  /// Unique among what its device made; caches compare it.
  [[nodiscard]] std::uint64_t id() const { return id_; }

  [[nodiscard]] const GlBuffer& position() const { return position_; }
  [[nodiscard]] const GlBuffer& normal() const { return normal_; }
  [[nodiscard]] const GlBuffer& albedo() const { return albedo_; }
  [[nodiscard]] const GlBuffer& specular() const { return specular_; }
  [[nodiscard]] const GlBuffer& emissive() const { return emissive_; }
  [[nodiscard]] const GlBuffer& stroke() const { return stroke_; }  ///< its name is 0 where nobody asked for it
  [[nodiscard]] const GlBuffer& edge_of_pixel() const { return edge_of_pixel_; }

  /// The pixel centres, on the CPU.
  [[nodiscard]] const SurfaceBuffer& surface() const { return surface_; }

 private:
  DeepFramebuffer() = default;
  void read_surface(const Scene& scene, const Vec3& eye);

  std::uint64_t id_ = 0;
  std::size_t edge_count_ = 0;
  Mat4 screen_from_world_{1.0F};
  GlBuffer position_;
  GlBuffer normal_;
  GlBuffer albedo_;
  GlBuffer specular_;
  GlBuffer emissive_;
  GlBuffer stroke_;
  GlBuffer edge_of_pixel_;
  SurfaceBuffer surface_;
};

}  // namespace luminist
