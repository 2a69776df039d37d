#pragma once
// verdict/watched_renderer.h -- an engine that somebody may take away: experiments end where they are.
#include <functional>
#include <utility>

#include "render/renderer.h"

namespace luminist {

/// Passes everything on, after asking whether to go on; if not, the answer is kCancelled. The engine must outlive it.
class WatchedRenderer final : public Renderer {
 public:
  /// go_on may be empty.
  WatchedRenderer(Renderer& engine, std::function<bool()> go_on) : engine_(&engine), go_on_(std::move(go_on)) {}

  [[nodiscard]] const SurfaceBuffer& surface() const override { return engine_->surface(); }
  [[nodiscard]] SceneFrame frame() const override { return engine_->frame(); }
  [[nodiscard]] const Style& style() const override { return engine_->style(); }
  [[nodiscard]] bool estimates() const override { return engine_->estimates(); }
  [[nodiscard]] const WorkCount& work() const override { return engine_->work(); }
  Result<Image> render(const ParamState& state, const RenderOptions& options = {}) override {
    if (!goes_on()) return cancelled();
    return engine_->render(state, options);
  }
  using Renderer::error;
  Result<double> error(const ParamState& state, const Target& target) override {
    if (!goes_on()) return cancelled();
    return engine_->error(state, target);
  }
  Result<void> colors_at(const ParamState& state, std::span<const int> without, std::span<const std::uint32_t> pixels,
                         std::span<Vec3> out) override {
    if (!goes_on()) return cancelled();
    return engine_->colors_at(state, without, pixels, out);
  }
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override {
    if (!goes_on()) return cancelled();
    return engine_->evaluate(candidates, samples, softness, out);
  }

 private:
  [[nodiscard]] bool goes_on() const { return !go_on_ || go_on_(); }
  static Error cancelled() { return {ErrorKind::kCancelled, "the verdict was cancelled", "", "", ""}; }

  Renderer* engine_;
  std::function<bool()> go_on_;
};

}  // namespace luminist
