#pragma once
// make_scene/curve.h -- smooth curves through points, and the surfaces that revolve or travel along them.
#include <vector>

#include "make_scene/surface.h"

namespace luminist {

/// A centripetal Catmull-Rom spline through points (x, y, z, w), walked by arc length in xyz; w is carried along (the
/// radius of a tube). Neighbouring points differ. source Yuksel et al. 2011, "On the parameterization of Catmull-Rom
/// curves".
class Curve {
 public:
  explicit Curve(std::vector<Point4> points);
  /// A profile for revolve(): points (radius, height).
  static Curve profile(const std::vector<Point2>& points);

  [[nodiscard]] Point4 at(double t) const;       ///< t in [0,1], a fraction of the length
  [[nodiscard]] Point3 tangent(double t) const;  ///< unit
  [[nodiscard]] double length() const { return lengths_.back(); }
  /// The fraction of the length at a control point.
  [[nodiscard]] double fraction_at_point(std::size_t index) const;

 private:
  [[nodiscard]] Point4 evaluate(double s) const;  // s counts control points

  std::vector<Point4> points_;   // with one phantom point before and one after
  std::vector<double> lengths_;  // length up to every sample, kSamples per segment
};

/// The profile (radius x, height y) about the Y axis; u is the angle from +Z towards +X, v runs along the profile.
/// Faces outward where the profile climbs.
Surface revolve(const Curve& profile);

/// Cross section of a sweep, around the origin: x along the frame's first axis; angle in radians, t along the path.
using Section = std::function<Point2(double angle, double t)>;

/// A tube along a path whose w is the radius. The frame turns as little as it can; its first axis starts nearest to
/// `up`. u goes around, v along. cost O(log) a point after a table of frames.
Surface sweep(const Curve& path, const Point3& up = {0.0, 1.0, 0.0}, Section section = {});

}  // namespace luminist
