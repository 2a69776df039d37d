#pragma once
// raster/raster_renderer.h -- the engine on a graphics device: deep framebuffer, shadow maps, relighting (paper, 6.1).
#include <functional>
#include <memory>

#include "base/files.h"
#include "gpu/device.h"
#include "render/renderer.h"
#include "rig/light_type.h"
#include "scene/scene.h"

namespace luminist {

class RasterRenderer final : public Renderer {
 public:
  /// One camera of one scene in one style. device and types outlive it; the scene is not needed afterwards.
  /// width, height in pixels. errors kUsage for a size that is not positive; kLimit, kGl of the device; kStyle at the
  /// author's file and line. cost a few passes over the triangles, and compiling the style.
  static Result<std::unique_ptr<RasterRenderer>> create(Device& device, const Scene& scene, const Camera& camera,
                                                        const LightTypes& types, const Style& style,
                                                        const AssetRoots& roots, int width, int height);
  ~RasterRenderer() override;

  /// Looks at the scene that it was made of from another camera, in another size; what was prepared of the scene and
  /// the style stays. errors those of create(); the renderer is of no use after one. cost a few passes over the
  /// triangles.
  Result<void> look_from(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width, int height);

  /// Draws in another style, or a new version of it, from now on; states must have its parameters. What was prepared of
  /// the scene stays. errors those of create(), and kUsage for a style that needs the scene prepared otherwise
  /// (strokes, lines): nothing has changed then. cost compiling the style.
  Result<void> change_style(const Style& style, const AssetRoots& roots);

  /// Until it is given an empty one, pictures, errors, colours and batches end with kCancelled where go_on says false:
  /// it is asked before each, between the shadows and the light, and between parts of a large picture.
  void ask(std::function<bool()> go_on);

  [[nodiscard]] const SurfaceBuffer& surface() const override;
  [[nodiscard]] SceneFrame frame() const override;
  [[nodiscard]] const Style& style() const override;
  [[nodiscard]] bool estimates() const override { return false; }
  Result<Image> render(const ParamState& state, const RenderOptions& options = {}) override;
  Result<double> error(const ParamState& state, const Target& target) override;
  /// Keeps the sum of the lights that do not move, if the style sums its lights. memory 16 bytes a sample.
  Result<double> error(const ParamState& state, const Target& target, std::span<const int> moving) override;
  Result<void> colors_at(const ParamState& state, std::span<const int> without, std::span<const std::uint32_t> pixels,
                         std::span<Vec3> out) override;
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override;
  [[nodiscard]] const WorkCount& work() const override;

 private:
  class Impl;
  explicit RasterRenderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace luminist
