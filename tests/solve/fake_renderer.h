#pragma once
// tests/solve/fake_renderer.h -- an engine on the CPU for a scene of four spheres, a floor and a wall: everything in
// closed form, shadows too. What the solver is tested on where there is no GPU.
#include <vector>

#include "render/renderer.h"

namespace luminist {

/// How the fake's style shades.
enum class FakeStyle {
  kMatte,    ///< Lambert, LightCombination::kSum
  kToon,     ///< Lambert cut at a threshold (style parameters threshold, dark), kJoint
  kTwoTone,  ///< Lambert cut at a threshold, kSum: the colours `bright` and `shade` on either side, both unlocked
  kGlowing,  ///< as kTwoTone, but the square of `bright` counts: the picture is not linear in it
  kDotted,   ///< as kMatte, in bright dots on black; its metric blurs
  kTinted,   ///< says kSum, but a light's channels mix: its part is not linear channel by channel
};

class FakeRenderer final : public Renderer {
 public:
  FakeRenderer(int width, int height, FakeStyle style = FakeStyle::kMatte);

  [[nodiscard]] const SurfaceBuffer& surface() const override { return surface_; }
  [[nodiscard]] SceneFrame frame() const override { return {Vec3(0.0F, 0.5F, 0.0F), 1.6F}; }
  [[nodiscard]] const Style& style() const override { return style_; }
  [[nodiscard]] bool estimates() const override { return false; }
  Result<Image> render(const ParamState& state, const RenderOptions& options) override;
  using Renderer::error;
  Result<double> error(const ParamState& state, const Target& target) override;
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override;
  [[nodiscard]] const WorkCount& work() const override { return work_; }

  /// A rig without lights in this engine's style.
  [[nodiscard]] ParamState empty_state() const;
  /// A cinematic light with all of its 18 degrees of freedom unlocked.
  [[nodiscard]] Light cinematic(const std::string& name) const;
  /// Everything painted: importance 1, no strokes, the picture of `state` underneath.
  [[nodiscard]] Target target_of(const ParamState& wanted, const ParamState& before);

 private:
  struct Sphere {
    Vec3 center;
    float radius = 1.0F;
    Vec3 albedo;
  };
  struct LightValues;
  [[nodiscard]] LightValues read(const Light& light) const;
  void trace(int x, int y);
  [[nodiscard]] float visibility(const LightValues& light, std::size_t pixel, float angle) const;
  [[nodiscard]] Vec3 light_term(const LightValues& light, const ParamState& state, std::size_t pixel,
                                const Softness& softness, bool shadows) const;
  [[nodiscard]] Vec3 shade(const ParamState& state, std::span<const LightValues> lights, int which, std::size_t pixel,
                           const Softness& softness, bool shadows) const;

  std::vector<Sphere> spheres_;
  SurfaceBuffer surface_;
  LightTypes types_;
  Style style_;
  FakeStyle kind_;
  WorkCount work_;
};

/// A hidden light for tests of recovery: it shines from somewhere in front on the spheres, all 18 values at random.
Light hidden_light(const FakeRenderer& renderer, const std::string& name, std::uint64_t seed);

}  // namespace luminist
