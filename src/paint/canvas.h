#pragma once
// paint/canvas.h -- the picture that is painted on, and the target and importance that come of it.
#include <functional>

#include "paint/stroke.h"
#include "render/surface_buffer.h"
#include "render/target.h"

namespace luminist {

/// The pair that the shadow brush and eraser copy from (paper, section 4.2).
struct ShadowPair {
  Image free_lights_off;  ///< the scene with all modifiable lights turned off
  Image shadows_off;      ///< all lights on, no shadows
};

/// Paint on one picture between two accepted solves.
class Canvas {
 public:
  using ShadowSource = std::function<Result<ShadowPair>()>;  ///< called at most once, when a stroke needs it

  /// surface must outlive the canvas; picture has its size.
  Canvas(const SurfaceBuffer& surface, Image picture, ShadowSource shadow_source);

  /// Composites one stroke: within it coverage is the maximum of its dabs, composited once.
  /// errors kBadContent for an unknown clip object (nearest name), an unreadable copy source, points that are not
  /// finite; the canvas is unchanged then. cost O(pixels under the stroke x dabs).
  Result<void> apply(const Stroke& stroke, const std::string& folder);

  /// Importance of what is not painted: I = (1 - delta) nu + delta I_p; painted pixels are 1 (section 4.2).
  void set_importance(float nu, float delta);

  [[nodiscard]] const Target& target() const { return target_; }
  [[nodiscard]] bool painted() const;  ///< any pixel touched since the last rebase

  /// A solve was accepted: its picture is what is painted on next, and the importance map becomes the previous one.
  void rebase(Image picture);

 private:
  const SurfaceBuffer* surface_;
  ShadowSource shadow_source_;
  Target target_;
};

}  // namespace luminist
