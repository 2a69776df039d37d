#pragma once
// paint/gradient.h -- how paint fades away from where a stroke started (paper, section 4.1).
#include <cstddef>
#include <optional>
#include <vector>

#include "base/math.h"
#include "paint/stroke.h"
#include "render/surface_buffer.h"

namespace luminist {

/// What a gradient fades away from: n_peak.
struct Peak {
  PeakKind kind = PeakKind::kDiffuse;
  Vec3 direction{0.0F};  ///< unit
};

/// Which objects a stroke may touch: [object id], empty for all.
using ObjectMask = std::vector<bool>;

/// Whether a stroke takes the peak of the one before it, if there is one.
bool repeats_peak(const Brush& brush);

/// (1 - gamma) + gamma f, with one of three f in [0,1]:
///   diffuse peak    max(0, n . n_peak), n_peak the normal where the stroke starts: a directional light from n_peak.
///   specular peak   max(0, r . n_peak), r the view vector mirrored about the normal and n_peak the r where the stroke
///                   starts. The paper only says what n_peak becomes; its n . n_peak would then be largest somewhere
///                   beside the start, so r takes the place of n: the paint is strongest at the start and fades as a
///                   highlight does when the mirrored view turns away from the light.
///   screen          1 at the first point falling to 0 at the last, by the projection on the line between them.
class Gradient {
 public:
  /// errors kBadContent if n_peak is wanted and the stroke meets no surface that it may touch.
  static Result<Gradient> create(const Stroke& stroke, const SurfaceBuffer& surface, const ObjectMask& mask,
                                 const std::optional<Peak>& last_peak);

  [[nodiscard]] float factor(const SurfaceBuffer& surface, int x, int y) const;
  [[nodiscard]] bool on_screen() const { return screen_; }
  [[nodiscard]] const std::optional<Peak>& peak() const { return peak_; }  ///< none without a gradient by normals

 private:
  Gradient() = default;
  float gamma_ = 0.0F;
  bool screen_ = false;
  std::optional<Peak> peak_;
  Vec2 start_{0.0F};  ///< pixels
  Vec2 drag_{0.0F};   ///< start to end, divided by its squared length
};

}  // namespace luminist
