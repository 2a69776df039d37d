#pragma once
// paint/anchored_stroke.h -- a stroke on the surface instead of the picture, to be carried to another frame or view.
#include <cstdint>
#include <string>
#include <vector>

#include "paint/brush.h"
#include "paint/paint_view.h"
#include "paint/stroke.h"

namespace luminist {

/// A dab on the mesh of an object; it moves, turns and grows with it.
struct AnchoredPoint {
  std::string object;          ///< name
  std::uint32_t triangle = 0;  ///< of its mesh
  Vec3 weights{0.0F};          ///< of the triangle's corners; sum 1
  Vec3 normal{0.0F};           ///< of the triangle, unit, on the side that was painted; in the object's frame
  float radius = 0.0F;         ///< of the brush at full pressure, in the object's units
  float pressure = 1.0F;       ///< as in StrokePoint
};

/// The way of the hand over the surface, close points apart by an eighth of the brush at most, because what is straight
/// on one picture is not on another.
struct AnchoredStroke {
  Brush brush;                        ///< "@" has become the name of the object
  std::vector<AnchoredPoint> points;  ///< of a bucket those that its gradient may start at
  std::vector<StrokePoint> picture;   ///< as they were painted
  int off_surface = 0;                ///< points that were left out: nothing is there to be painted

  /// Whether the paint follows its points; a bucket's do no more than start its gradient.
  [[nodiscard]] bool follows_points() const;
};

/// A stroke of a view, on the surface that its points show. One that is clipped lies on its object, also where
/// another stands before it: there the clip has cut it.
/// errors kBadContent: an unknown clip object (nearest name), "@" over none.
Result<AnchoredStroke> anchored(const Stroke& stroke, const PaintView& view);

/// A stroke on another picture, in pieces.
struct CarriedStroke {
  std::vector<Stroke> pieces;  ///< none: it is left out
  int shown = 0;               ///< points that are carried
  int covered = 0;             ///< of them behind another object, where the clip cuts them
  int hidden = 0;              ///< points left out: behind something, or on the side that faces away
  int outside = 0;             ///< points left out: neither they nor their dabs are on the picture
};

/// The same dabs seen in another view, of the scene at another time maybe. A clipped stroke is hidden by its own object
/// alone, what else stands before it is cut by the clip; but a piece none of whose points is seen is left out. A stroke
/// is parted where neighbours are apart by more than the brush's radius: torn, or the points between are left out; what
/// is narrower a brush covers anyway. The pieces share one peak, that of the first; a screen gradient runs out along
/// each. Diameters are as large on the surface as they were; the largest is the brush's and the rest is pressure.
/// Buckets fill their object as before.
/// errors kBadContent for an object or a triangle that is not in the scene.
Result<CarriedStroke> carried(const AnchoredStroke& stroke, const PaintView& view);

}  // namespace luminist
