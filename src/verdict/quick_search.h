#pragma once
// verdict/quick_search.h -- how near to a wish the free parameters come, found out in milliseconds on a few samples.
#include <span>
#include <vector>

#include "base/result.h"
#include "render/renderer.h"
#include "solve/random.h"
#include "verdict/stroke_region.h"

namespace luminist {

/// A state and how far its colours on a wish's samples are from the wish.
struct Reached {
  ParamState state;  ///< its locks say what may change
  double error = 0.0;
};

/// Descends from many states at once: Levenberg and Marquardt's steps within the ranges, slopes by finite differences,
/// every round of all states in two batches. An estimate from above: what it reaches can be reached, what it misses may
/// lie elsewhere. Deterministic. The renderer must outlive it. thread: the renderer's.
class QuickSearch {
 public:
  explicit QuickSearch(Renderer& renderer) : renderer_(&renderer) {}

  /// The error of states on the real picture. cost one batch.
  Result<std::vector<double>> measure(std::span<const ParamState> states, const SampledWish& wish);

  /// Variants of one block each, whose colour (role "color") is turned to what fits the wish best where it is free: the
  /// samples are taken to be linear in it. returns their errors, as far as that holds. cost one batch.
  Result<std::vector<double>> settle_colors(std::vector<ParamState>& variants, std::span<const int> blocks,
                                            const SampledWish& wish);

  /// Goes on from each state: `soft` iterations with widened edges, then `sharp` ones. result [starts.size()], none
  /// worse than its start. errors the renderer's.
  Result<std::vector<Reached>> descend(std::vector<ParamState> starts, const SampledWish& wish, int soft, int sharp);

  /// The best of the starts and of `variants` of the first for each block with something free, after descents from the
  /// best few of them. Ends early at `enough`. errors the renderer's. cost some hundreds of candidates on the samples.
  Result<Reached> search(std::vector<ParamState> starts, const SampledWish& wish, int variants, double enough);

 private:
  struct Descent;
  Result<void> iterate(std::vector<Descent>& descents, const SampledWish& wish, const Softness& softness,
                       double position_step);
  Result<std::vector<std::vector<Vec3>>> colors(std::span<const Candidate> candidates, const SampledWish& wish,
                                                const Softness& softness);

  Renderer* renderer_;
};

/// Where variants of a light look and from where they shine.
struct WishPlaces {
  std::vector<Vec3> position;
  std::vector<Vec3> normal;
};
WishPlaces wish_places(const SampledWish& wish, const SurfaceBuffer& surface);

/// `count` variants of what is free in one block: anywhere in its range, or near where it is. A light that may turn
/// looks at one of the places; one that may also move stands somewhere in front of it; a free colour is bright, because
/// a light that is off shows no difference. Deterministic by the random numbers.
std::vector<ParamState> block_variants(const ParamState& state, int block, const WishPlaces& places,
                                       const SceneFrame& frame, int count, Random& random);

}  // namespace luminist
