#pragma once
// render/views.h -- several pictures of one rig as one: in several styles, or from several cameras.
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/renderer.h"

namespace luminist {

/// One of the pictures: an engine, what is wanted of its picture, and the values and locks of its style. Views of one
/// style share its parameters; those of the first one count.
struct View {
  Renderer* renderer = nullptr;
  Target target;
  ParamBlock style;
  double weight = 1.0;                         ///< > 0, of its error among the others'
  std::vector<MaterialParams> materials = {};  ///< of the scene, with their locks; those of the first view count
  std::optional<double> frame = std::nullopt;  ///< at which a rig's keys are looked up; empty: without keys
};

/// An engine whose picture is the pictures of all views, one above the other, as their metrics compare them. So
/// whatever searches on a Renderer searches on several views at once: the lights are shared, and each style has its own
/// parameters, named "<style>_<parameter>". What has keys is, in each view, what they say at its frame; a search that
/// should not turn it in vain finds it locked.
///
/// The error of target() is the weighted mean of the views' epsilons, each over its own importance. Memory: one picture
/// a view. The views' engines outlive it. thread: theirs.
class Views final : public Renderer {
 public:
  /// errors kUsage: pictures of different widths or scenes of different frames; kStyle: names that collide. There is at
  /// least one view.
  static Result<std::unique_ptr<Views>> create(std::vector<View> views);

  [[nodiscard]] int count() const { return static_cast<int>(views_.size()); }
  /// What all views together want.
  [[nodiscard]] const Target& target() const { return target_; }
  /// A rig with the parameters of all styles, and the materials, which the views share as they share the lights.
  [[nodiscard]] ParamState joint(const LightRig& rig) const;
  /// What one view sees of it.
  [[nodiscard]] ParamState state_of(const ParamState& joint, int view) const;
  /// The epsilon of one view, without penalty. errors the engine's. cost a picture of that view.
  Result<double> error_of(const ParamState& joint, int view);

  [[nodiscard]] const SurfaceBuffer& surface() const override { return surface_; }
  [[nodiscard]] SceneFrame frame() const override { return views_.front().renderer->frame(); }
  [[nodiscard]] const Style& style() const override { return style_; }
  [[nodiscard]] bool estimates() const override;
  Result<Image> render(const ParamState& joint, const RenderOptions& options) override;
  Result<double> error(const ParamState& joint, const Target& target) override;
  Result<double> error(const ParamState& joint, const Target& target, std::span<const int> moving) override;
  Result<void> colors_at(const ParamState& joint, std::span<const int> without, std::span<const std::uint32_t> pixels,
                         std::span<Vec3> out) override;
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override;
  [[nodiscard]] const WorkCount& work() const override;

 private:
  /// The pixels of one view among others, and where they stand there.
  struct Share {
    SampleSet samples;
    std::vector<std::size_t> place;
  };
  explicit Views(std::vector<View> views) : views_(std::move(views)) {}
  Result<Image> pictures(const ParamState& joint, const RenderOptions& options, bool compared);
  Result<void> join_styles();
  void join_surfaces();
  void join_targets();
  [[nodiscard]] std::vector<Share> shares(std::span<const std::uint32_t> pixels, std::uint64_t id) const;

  std::vector<View> views_;
  std::vector<int> first_param_;            ///< [views] of its style among the parameters of all
  std::vector<std::size_t> first_pixel_;    ///< [views + 1]
  std::vector<const ParamBlock*> sources_;  ///< the styles, each once, in the order of their parameters
  Style style_;
  SurfaceBuffer surface_;
  Target target_;
  std::map<std::uint64_t, std::vector<Share>> split_;  ///< by the id of the samples
  mutable WorkCount work_;
};

}  // namespace luminist
