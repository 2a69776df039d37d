#pragma once
// verdict/light_bank.h -- what more lights could do: a fit of what is missing over lights from many sides. An estimate.
#include <span>
#include <vector>

#include "base/result.h"
#include "render/renderer.h"
#include "solve/start_light.h"
#include "verdict/stroke_region.h"

namespace luminist {

/// A place that wants light.
struct BankFocus {
  Vec3 position{0.0F};
  Vec3 normal{0.0F};    ///< mean; need not be unit
  float extent = 0.0F;  ///< radius of what is to be lit, world
};

/// The focus of one region of a wish, at what lacks light. colors: the picture on the samples.
BankFocus focus_of(const SampledWish& wish, int region, std::span<const Vec3> colors, const SurfaceBuffer& surface);

/// Lights of one type around some places, one at a time on top of a state, on the samples of a wish.
///
/// For styles that sum their lights a light's part is exact, shadows and all; for others it is what the light changes,
/// and sums are a guess.
class LightBank {
 public:
  /// prototype: a light of the type that would be added, as it is made. errors the renderer's.
  /// cost one batch of some 40 candidates for each focus.
  static Result<LightBank> create(Renderer& renderer, const ParamState& state, const SampledWish& wish,
                                  std::span<const BankFocus> foci, const Light& prototype);

  /// colors of the samples with the best non-negative amounts of all lights of the bank added, by un-squared norm.
  [[nodiscard]] std::vector<Vec3> fitted() const;

  struct Pick {
    StartLight light;   ///< with the intensity that fits best
    double gain = 0.0;  ///< of the error, weighted as asked
  };
  /// The single light that lowers the error most. weight [samples] replaces the wish's.
  [[nodiscard]] Pick best(std::span<const double> weight) const;

  /// The picture without the bank on the samples.
  [[nodiscard]] const std::vector<Vec3>& colors() const { return colors_; }

 private:
  explicit LightBank(const SampledWish& wish) : wish_(&wish) {}
  [[nodiscard]] Vec3 amount(std::size_t light, std::span<const double> weight) const;

  const SampledWish* wish_;
  std::vector<StartLight> lights_;
  std::vector<std::vector<Vec3>> parts_;  ///< [lights] each [samples], for the intensity (1, 1, 1)
  std::vector<Vec3> colors_;
};

/// The rig with a bank's light added at its end, named `name`; what its type leaves unlocked is free.
ParamState with_light(const ParamState& state, const Light& prototype, const StartLight& start,
                      const std::string& name);

}  // namespace luminist
