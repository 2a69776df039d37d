#pragma once
// trace/path_renderer.h -- global illumination behind the interface of all engines.
#include <memory>

#include "render/renderer.h"
#include "scene/scene.h"
#include "trace/progressive.h"

namespace luminist {

/// A path tracer. Its lights are those of the rig, the scene's emissive materials, and the rig's ambient colour as the
/// radiance of what is seen where nothing is (by everything but the eye).
///
/// render() traces a pixel's paths anew, as many as the style's parameter of the role "samples" says. error(),
/// colors_at() and evaluate() look at paths that are kept ("kept" a pixel, the first of the same), so that lights may
/// be moved for the price of shadow rays, and coloured for nothing; their noise is that of so few, but it is the same
/// whenever the parameters are; evaluate() saves paths where Softness saves shadow rays. Other parameters of the style:
/// "bounces", "seed", "caustics", "highlights" (a factor of everything but diffuse reflection), "denoise" (of render()
/// alone), "clamp" (what a path of render() may bring by way of a second surface; a solve's paths bring all). error()
/// asks fewer paths of pixels that count less, and none of those that do not count. Samples are the picture's pixels,
/// antialiased. Where a material is turned, kept paths are traced anew, so that estimates stay unbiased: a candidate
/// with materials of its own costs its paths. Softness widens shadows and barns; there are no thresholds. thread: one;
/// it works in parallel. Same parameters, same bits, for any number of threads.
class PathRenderer final : public Renderer {
 public:
  /// errors kUsage for a size that is not positive; kLimit if memory runs out. memory: what paths may take, in bytes.
  static Result<std::unique_ptr<PathRenderer>> create(Scene scene, const Camera& camera, const Style& style, int width,
                                                      int height, std::size_t memory_bytes = kMemory);
  ~PathRenderer() override;
  static constexpr std::size_t kMemory = std::size_t{600} << 20;

  void set_watch(PathWatch watch);
  /// render(), with fewer samples of pixels that count less and none of those that do not count (they are black).
  Result<Image> render_where(const ParamState& state, const Image& importance);

  [[nodiscard]] const SurfaceBuffer& surface() const override;
  [[nodiscard]] SceneFrame frame() const override;
  [[nodiscard]] const Style& style() const override;
  [[nodiscard]] bool estimates() const override { return true; }
  /// errors kStyle for a light type that the path tracer does not know; kCancelled.
  Result<Image> render(const ParamState& state, const RenderOptions& options = {}) override;
  using Renderer::error;
  Result<double> error(const ParamState& state, const Target& target) override;
  Result<void> colors_at(const ParamState& state, std::span<const int> without, std::span<const std::uint32_t> pixels,
                         std::span<Vec3> out) override;
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override;
  [[nodiscard]] const WorkCount& work() const override;

 private:
  class Impl;
  explicit PathRenderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// How many of `most` samples a pixel gets that counts for `share` of the one that counts most: in proportion to the
/// root of what it counts, which keeps the error's noise least; at least one, none where the share is 0.
int samples_for(double share, int most);

}  // namespace luminist
