#pragma once
// raster/sample_visibility.h -- what the samples of a solve see of a light, traced as rays and remembered. No GL.
#include <cstdint>
#include <list>
#include <span>
#include <unordered_map>
#include <vector>

#include "raster/shadow_light.h"
#include "rays/ray_scene.h"
#include "render/renderer.h"
#include "render/surface_buffer.h"

namespace luminist {

/// Rays follow the filter of the shadow maps (raster/shadow_light.h), so both see the same shadows. A spot's direction
/// and shape do not move its shadows; only a new position or another filter costs rays.
class SampleVisibility {
 public:
  /// rays and surface outlive it. budget_values: floats that are remembered at most; 16 MB are some thousand places of
  /// lights, which a search goes back to while it is near them.
  SampleVisibility(const RayScene& rays, const SurfaceBuffer& surface,
                   std::size_t budget_values = std::size_t{1} << 22);

  /// Traces what is not remembered of these lights, on all cores. The filter's radius is at least
  /// softness.shadow_angle; softness.shadow_rays rays for each sample, placed so that samples next to each other in the
  /// set complete each other. A set's id stands for its pixels. cost one ray query per ray.
  void prepare(std::span<const ShadowLight> lights, const SampleSet& samples, const Softness& softness);

  /// [samples.pixels.size()] share of the light that reaches each sample, before its shadow density; prepared if it was
  /// not; valid until the next trim(). Same arguments, same bits.
  std::span<const float> column(const ShadowLight& light, const SampleSet& samples, const Softness& softness);

  /// Forgets what was used longest ago, down to the budget.
  void trim();

  [[nodiscard]] double queries() const { return queries_; }  ///< rays traced since it was made

 private:
  /// Everything that a column depends on; equal keys, equal columns.
  struct Key {
    std::uint64_t samples = 0;
    ShadowLight light;
    int rays = 0;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  struct Column {
    Key key;
    std::vector<float> lit;
  };
  static Key key_of(const ShadowLight& light, const SampleSet& samples, const Softness& softness);
  /// The column's place in the list, at its front; made, with nothing in it, if there was none.
  Column& touch(const Key& key);
  void prepare_discs(std::size_t samples, int rays);
  /// Fills lit; returns the rays traced.
  std::size_t trace(Column& column, const SampleSet& samples) const;

  const RayScene* rays_;
  const SurfaceBuffer* surface_;
  std::size_t budget_;
  std::size_t held_ = 0;       ///< floats in columns_
  std::list<Column> columns_;  ///< most recently used first
  std::unordered_map<Key, std::list<Column>::iterator, KeyHash> index_;
  std::vector<Vec2> discs_;  ///< sample_disc() of discs_rays_ rays a sample
  int discs_rays_ = 0;
  double queries_ = 0.0;
};

/// Ray j of sample i, n rays a sample, in the unit disc: an R2 sequence (Roberts 2018), so that any run of neighbouring
/// samples covers the disc evenly.
Vec2 sample_disc(std::uint32_t sample, int ray, int rays);

}  // namespace luminist
