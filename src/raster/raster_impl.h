#pragma once
// raster/raster_impl.h -- what a RasterRenderer is made of, for its own two files.
#include <optional>
#include <vector>

#include "raster/batch_evaluator.h"
#include "raster/deep_framebuffer.h"
#include "raster/mesh_buffers.h"
#include "raster/metric_pass.h"
#include "raster/outline_buffers.h"
#include "raster/raster_renderer.h"
#include "raster/relight.h"
#include "raster/shadow_maps.h"
#include "rays/ray_scene.h"

namespace luminist {

class RasterRenderer::Impl {
 public:
  Impl(Device& device, const LightTypes& types, const Style& style, SceneFrame frame, MeshBuffers meshes)
      : device_(&device), types_(&types), style_(style), frame_(frame), meshes_(std::move(meshes)) {}

  Result<void> prepare(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width, int height);
  Result<void> look_from(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width, int height);
  Result<void> change_style(const Style& style, const AssetRoots& roots);
  /// The picture of the state in picture_. errors as render().
  Result<void> draw(const ParamState& state, const RenderOptions& options);
  Result<Image> read_picture() const;
  Result<double> error(const ParamState& state, const Target& target, std::optional<std::span<const int>> moving);
  Result<void> colors_at(const ParamState& state, std::span<const int> without, std::span<const std::uint32_t> pixels,
                         std::span<Vec3> out);
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out);

  void ask(std::function<bool()> go_on) { go_on_ = std::move(go_on); }
  [[nodiscard]] const SurfaceBuffer& surface() const { return ruled_ ? ruled_->surface : deep_->surface(); }
  [[nodiscard]] const SceneFrame& frame() const { return frame_; }
  [[nodiscard]] const Style& style() const { return style_; }
  [[nodiscard]] const WorkCount& work() const { return work_; }

 private:
  /// What one dispatch shades: lights (places in the rig, lit ones), with emission and ambient or without.
  struct Layer {
    std::vector<int> lights;
    bool whole = true;
  };
  /// What a style with lines needs, to draw them again with another width.
  struct Ruled {
    SurfaceBuffer surface;  ///< without lines: brushes and rays do not see them
    Scene scene;            ///< without meshes
    Camera camera;
    AssetRoots roots;
    OutlineBuffers outlines;
    std::optional<LineSpec> drawn;  ///< empty: none yet
  };
  /// What the camera sees, and the buffers of its size.
  Result<void> draw_deep(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width, int height);
  Result<void> prepare_lines(const Scene& scene, const Camera& camera, const AssetRoots& roots);
  /// The deep framebuffer gets the lines that these values of the style ask for.
  Result<void> follow_lines(const ParamBlock& style);
  Result<void> allocate_colors();
  /// errors kCancelled where go_on_ says false.
  Result<void> may_go_on() const;
  Result<void> update_shadows(const ParamState& state);
  Result<void> shade(const ParamState& state, const RenderOptions& options);
  /// The moving lights over the kept sum of the others.
  Result<void> shade_moving(const ParamState& state, std::span<const int> moving);
  Result<void> keep_still(const ParamState& state, const Layer& still);
  /// All that a layer's colours depend on.
  [[nodiscard]] std::vector<std::byte> key_of(const ParamState& state, const Layer& layer) const;
  Result<void> run(const ParamState& state, const Layer& layer, bool shadows, const GlBuffer* below,
                   const GlBuffer& colors);
  Result<void> finish(const ParamState& state, bool shadows);
  Result<void> resolve(const GlBuffer& colors);

  Device* device_;
  const LightTypes* types_;
  Style style_;
  SceneFrame frame_;
  MeshBuffers meshes_;
  std::optional<DeepFramebuffer> deep_;
  std::optional<Ruled> ruled_;  ///< of a style with lines
  std::optional<ShadowMaps> maps_;
  std::optional<Relight> relight_;
  std::optional<CandidateTable> table_;
  std::optional<RayScene> rays_;
  std::optional<BatchEvaluator> batch_;
  std::optional<MetricPass> metric_;
  Program resolve_program_;
  GlBuffer colors_;   ///< vec4 [samples]
  GlBuffer picture_;  ///< vec4 [pixels]
  GlBuffer still_;    ///< vec4 [samples], what the lights add that do not move; empty until it is needed
  std::vector<std::byte> still_key_;
  std::vector<std::byte> picture_key_;  ///< of what picture_ shows, with shadows; empty if that is unknown
  GlBuffer bad_;                        ///< uint, pixels that were not finite
  WorkCount work_;
  std::function<bool()> go_on_;  ///< empty: whatever is asked for is done, and in one go
};

}  // namespace luminist
