#pragma once
// trace/panel_view.h -- a panel as a place sees it: points of it, chosen evenly over the solid angle that it covers.
#include "base/math.h"
#include "trace/rig_light.h"

namespace luminist {

/// A panel seen from a place on its shining side. Points are chosen with the same density for every direction: what
/// arrives then varies with the surface's cosine alone, however near the panel is. Panels that look small are chosen
/// from evenly over their area instead, which is about the same and keeps its precision.
/// source: Urena, Fajardo and King 2013, An area-preserving parametrization for spherical rectangles. thread any.
class PanelView {
 public:
  PanelView(const RigLight& light, const Vec3& from);

  /// place in [0,1)^2.
  [[nodiscard]] Vec3 point(const Vec2& place) const;
  /// Density per solid angle with which point() chooses one at that squared distance, of which it is seen under that
  /// cosine with the panel's normal.
  [[nodiscard]] float pdf(float square, float cosine) const;
  /// Steradians; 0 where it was not worth knowing.
  [[nodiscard]] float solid_angle() const { return even_ ? solid_angle_ : 0.0F; }

 private:
  const RigLight* light_;
  Vec3 from_;
  Vec3 lo_{0.0F};  ///< the panel's corner of least `right` and `up`; z against the way it shines
  Vec2 hi_{0.0F};
  float lower_ = 0.0F;  ///< sines of the planes through the lower and upper side
  float upper_ = 0.0F;
  float first_angle_ = 0.0F;
  float solid_angle_ = 0.0F;
  bool even_ = false;
};

}  // namespace luminist
