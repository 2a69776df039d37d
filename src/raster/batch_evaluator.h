#pragma once
// raster/batch_evaluator.h -- a few hundred samples, many candidates, one dispatch: what a solver asks for.
#include <cstdint>
#include <span>
#include <vector>

#include "raster/deep_framebuffer.h"
#include "raster/relight.h"
#include "raster/sample_visibility.h"
#include "render/renderer.h"

namespace luminist {

class BatchEvaluator {
 public:
  /// Everything outlives it. scene: what a sun's shadows are of (shadow_light()). Rays start at `seen`, which has no
  /// lines of a style in it.
  BatchEvaluator(Device& device, Relight& relight, const DeepFramebuffer& surface, const SurfaceBuffer& seen,
                 const LightTypes& types, const RayScene& rays, const SceneFrame& scene);

  /// Renderer::evaluate(). Values that are not finite become 0. errors kLimit if one rig has more lights of a type than
  /// the device holds, or memory runs out.
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out);

  [[nodiscard]] double shades() const { return shades_; }                 ///< lights shaded at samples
  [[nodiscard]] double queries() const { return visibility_.queries(); }  ///< rays

 private:
  /// The table of the first candidates, as many as one dispatch takes; returns how many.
  Result<std::size_t> fill_table(std::span<const Candidate> candidates, const SampleSet& samples,
                                 const Softness& softness);
  /// The light whose shadows light i of the rig has.
  [[nodiscard]] ShadowLight caster(const LightRig& rig, int light) const;
  void prepare_visibility(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness);
  std::uint32_t column(const LightRig& rig, int light, const SampleSet& samples, const Softness& softness);
  Result<void> shade(const SampleSet& samples, const Softness& softness, std::span<Vec3> out);

  Device* device_;
  Relight* relight_;
  const DeepFramebuffer* surface_;
  const LightTypes* types_;
  SceneFrame scene_;
  SampleVisibility visibility_;
  CandidateTable table_;
  std::vector<ShadowLight> casters_;   ///< reused
  std::vector<const float*> columns_;  ///< of the dispatch that is being filled
  std::vector<Vec4> colors_;           ///< read back
  GrowingBuffer entry_buffer_{BufferUse::kStorage, "batch entries"};
  GrowingBuffer visibility_buffer_{BufferUse::kStorage, "batch visibility"};
  GrowingBuffer color_buffer_{BufferUse::kStorage, "batch colours"};
  double shades_ = 0.0;
};

}  // namespace luminist
