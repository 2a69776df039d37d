#pragma once
// verdict/attainable.h -- what no setting of the free parameters can do: a certified lower bound on the error.
#include <optional>
#include <vector>

#include "base/result.h"
#include "render/renderer.h"

namespace luminist {

/// The colours that each pixel can take, as far as the promises of the style tell them.
///
/// The picture is what is locked, plus one part a light that is free in anything. A light of which only the colour is
/// free adds its colour, within its range, times a part that is known. Any other free light adds something that is not
/// known and not negative. So no pixel gets darker than the locked lights, the ambient and emission leave it, and none
/// changes where no free light reaches.
///
/// What is assumed: the style keeps LightCombination::kSum, and lights add (tried on this picture: a free light whose
/// part is negative anywhere disproves it); parameters are in their ranges, which a solver may leave at a penalty.
/// Pictures are the renderer's own, antialiased, so that the bound is one on the epsilon that a solve reports.
class AttainableColors {
 public:
  /// Nothing where there is no bound: a style that joins its lights or blurs its metric, a free parameter of the style
  /// or of the ambient, a free light whose shadow others share. picture: of this state.
  /// errors the renderer's. cost a picture, and one for each light of which only the colour is free.
  static Result<std::optional<AttainableColors>> create(Renderer& renderer, const ParamState& state,
                                                        const Image& picture);

  /// At most the mean over some pixels, weighted by importance, of |T - R| for any setting of the free parameters.
  /// An empty list is the whole picture: a lower bound on epsilon. method: weak duality; the multipliers come from
  /// reweighted least squares, and any multipliers give a bound. cost O(pixels lights^2).
  [[nodiscard]] double least_error(const Target& target, std::span<const std::uint32_t> pixels) const;

 private:
  struct Scaled {
    Image white;  ///< the part for the colour (1, 1, 1)
    Vec3 low{0.0F};
    Vec3 high{0.0F};
    Vec3 color{0.0F};  ///< now
  };
  void fit(const Target& target, std::span<const std::uint32_t> pixels, int rounds, double floor,
           std::vector<Vec3>& colors) const;
  [[nodiscard]] double bound(const Target& target, std::span<const std::uint32_t> pixels, std::span<const Vec3> colors,
                             double floor) const;
  [[nodiscard]] double smooth_error(const Target& target, std::span<const std::uint32_t> pixels, double floor,
                                    std::span<const Vec3> colors) const;
  void improve(const Target& target, std::span<const std::uint32_t> pixels, double floor, glm::length_t channel,
               std::span<const Vec3> colors, std::span<Vec3> better) const;
  [[nodiscard]] Vec3 residual(const Target& target, std::size_t pixel, std::span<const Vec3> colors) const;

  Image locked_;
  std::vector<Scaled> scaled_;
  bool open_ = false;  ///< some light adds what is not known
};

}  // namespace luminist
