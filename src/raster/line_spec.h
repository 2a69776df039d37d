#pragma once
// raster/line_spec.h -- which lines a style draws and how wide: its parameters, found by their roles.
#include "params/param_block.h"
#include "style/style.h"

namespace luminist {

/// A style's manifest gives parameters these roles; what turns geometry is no degree of freedom (`quality`), and what
/// is not declared is off:
///   line_width  float: picture heights, or scene radii if line_unit (a choice) is its second word; at the depth of the
///     scene's centre
///   line_distance  float, exponent: lines get thinner with the distance from the eye
///   line_inner  float, width of creases, intersections and borders as a share
///   line_silhouette, line_crease, line_intersection, line_border  bool
///   line_crease_angle  float, radians: creases are sharper
struct LineSpec {
  float width = 0.0F;
  bool in_scene_radii = false;
  float distance = 0.0F;
  float inner = 1.0F;
  bool silhouette = false;
  bool crease = false;
  bool intersection = false;
  bool border = false;
  float crease_angle = 0.7F;

  bool operator==(const LineSpec&) const = default;
  [[nodiscard]] bool any() const { return width > 0.0F && (silhouette || crease || marked()); }
  [[nodiscard]] bool marked() const { return inner > 0.0F && (intersection || border); }  ///< lines between objects
};

/// Of these values of a style's parameters.
LineSpec line_spec(const ParamBlock& style);

}  // namespace luminist
