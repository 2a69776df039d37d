#pragma once
// verdict/evidence.h -- the experiments on which a verdict rests.
#include <optional>
#include <vector>

#include "verdict/attainable.h"
#include "verdict/light_bank.h"
#include "verdict/lock_probe.h"
#include "verdict/quick_search.h"

namespace luminist {

/// A state that was tried: how near it comes to one stroke, and to everything that is wished (both on samples).
struct Trial {
  ParamState state;
  double own = 0.0;
  double total = 0.0;
};

/// One solve's outcome and what can be found out about it. The renderer, state, target and picture must outlive it.
class Evidence {
 public:
  /// errors the renderer's.
  static Result<Evidence> create(Renderer& renderer, const ParamState& state, const Target& target,
                                 const Image& picture, const Light* new_light);

  [[nodiscard]] const std::vector<StrokeRegion>& regions() const { return regions_; }
  [[nodiscard]] const Shortfall& shortfall(int region) const { return shortfalls_[static_cast<std::size_t>(region)]; }
  [[nodiscard]] const ParamState& state() const { return *state_; }
  [[nodiscard]] const SurfaceBuffer& surface() const { return renderer_->surface(); }

  /// Whether what was tried is clearly nearer to a stroke than the picture is.
  [[nodiscard]] bool helps(int region, double own) const;
  /// Whether it helps the stroke, and not at the price of more elsewhere.
  [[nodiscard]] bool helps_all(int region, const Trial& trial) const;
  /// Sampled error of the picture: of one stroke, of everything.
  [[nodiscard]] double now(int region) const { return now_[static_cast<std::size_t>(region)]; }
  [[nodiscard]] double total_now() const { return total_now_; }
  /// How far a region's samples are from the picture by chance, a mean distance; 0: they are exact.
  [[nodiscard]] double noise(int region) const { return noise_[static_cast<std::size_t>(region)]; }
  /// A region's error without what chance adds to it.
  [[nodiscard]] double quiet(int region, double error) const;

  /// What is free, for one stroke alone. thorough: with more variants.
  Result<Reached> alone(int region, const ParamState& start, bool thorough);
  /// On from some states with everything that is wished but region `left_out` (-1: nothing).
  Result<Trial> together(int region, std::vector<ParamState> starts, int left_out = -1);
  /// What each region loses, by its share, when the lights become those.
  Result<std::vector<double>> damages(const ParamState& state);
  /// The best lights for everything that is wished that a search from some states finds.
  Result<Reached> rival(std::vector<ParamState> starts);
  /// How near a state comes to one stroke, on samples.
  Result<double> own_error(int region, const ParamState& state);
  Result<std::vector<Unlocking>> unlockings(int region, std::size_t keep, LockedKind kind);
  /// A light more for one stroke: the best single one of a bank, and what it comes to with everything that is wished.
  struct Addition {
    StartLight light;
    Reached alone;
    Trial trial;
  };
  Result<std::optional<Addition>> added_light(int region);

  /// Where another light could bring epsilon, over the samples of all strokes. An estimate.
  Result<std::optional<double>> estimated_epsilon(double epsilon, std::span<const int> unmet);
  /// Made when it is first asked for; null where there is no bound.
  Result<const AttainableColors*> attainable();
  /// epsilon of the full picture.
  Result<double> epsilon(const ParamState& state) { return renderer_->error(state, *target_); }

  /// Samples of one region.
  [[nodiscard]] const SampledWish& wish(int region) const { return wishes_[static_cast<std::size_t>(region)]; }

 private:
  Evidence(Renderer& renderer, const ParamState& state, const Target& target, const Image& picture)
      : renderer_(&renderer), state_(&state), target_(&target), picture_(&picture), search_(renderer) {}

  Renderer* renderer_;
  const ParamState* state_;
  const Target* target_;
  const Image* picture_;
  const Light* new_light_ = nullptr;
  QuickSearch search_;
  std::vector<StrokeRegion> regions_;
  std::vector<Shortfall> shortfalls_;
  SampledWish everything_;
  std::vector<SampledWish> wishes_;  ///< [regions]
  std::vector<double> share_;        ///< [regions] of all weight
  std::vector<double> now_;
  std::vector<double> noise_;  ///< [regions]
  double total_now_ = 0.0;
  std::vector<Vec3> colors_;  ///< of the state on all samples
  bool bound_asked_ = false;
  std::optional<AttainableColors> attainable_;
};

}  // namespace luminist
