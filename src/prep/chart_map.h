#pragma once
// prep/chart_map.h -- a disc laid flat.
#include <optional>
#include <vector>

#include "prep/chart_disc.h"

namespace luminist {

/// How a chart was flattened.
enum class ChartMethod {
  kRigid,      ///< one triangle: no distortion at all
  kAligned,    ///< turned to the strokes everywhere, from one of the next
  kArap,       ///< as rigid as possible, from one of the next (Liu et al. 2008)
  kLscm,       ///< least squares conformal, free border (Levy et al. 2002)
  kMeanValue,  ///< onto a circle, cannot flip (Floater 2003)
  kTutte,      ///< onto a circle with equal weights, cannot flip whatever the angles (Tutte 1963)
};
const char* name_of(ChartMethod method);  ///< "lscm"

/// A place in the plane for every point of a disc, at any scale; nothing where the linear system fails. thread any.
/// cost about 12 us a triangle. source CGAL, Surface_mesh_parameterization. method: any but kAligned and kArap.
std::optional<std::vector<glm::dvec2>> map_disc(const Disc& disc, ChartMethod method);

/// Places from which lengths are kept better: a few steps of turning every triangle rigidly into its place and solving
/// for the points between them. May flip what did not. places at the scale of the surface. cost about 8 us a triangle.
/// source Liu et al. 2008, section 4.
std::optional<std::vector<glm::dvec2>> as_rigid_as_possible(const Disc& disc, const std::vector<glm::dvec2>& places);

/// Places in which every triangle is turned by its angle (radians, counter-clockwise) against how it lies now, as
/// nearly as its neighbours let it: triangles grow or shrink, up to twofold, to make room, so that turns which are
/// smooth over the surface come out conformal. May flip what did not. cost as above. source the same with the turns
/// given.
std::optional<std::vector<glm::dvec2>> with_triangles_turned(const Disc& disc, const std::vector<glm::dvec2>& places,
                                                             const std::vector<double>& turns);

/// How lengths changed. A linear factor is by how much the plane is longer than the surface in some direction.
struct Distortion {
  std::size_t flipped = 0;  ///< triangles turned over, beyond what rounding of the places explains
  double area = 1.0;        ///< >= 1: mean factor (or its inverse) by which areas changed; exp(mean |log|)
  double worst_area = 1.0;  ///< the same of the worst triangle
  double angle = 1.0;       ///< >= 1: mean ratio of the linear factors of one triangle, 1 is conformal
  double worst_angle = 1.0;
  double stretch = 1.0;  ///< >= 1: root of the mean of (a^2 + b^2 + 1/a^2 + 1/b^2) / 4 of the linear factors a, b
                         ///< (those beyond 10 count as 10)
};

/// The linear factors of one triangle, the larger first.
struct LinearFactors {
  double largest = 0.0;
  double least = 0.0;  ///< < 0: flipped
};
LinearFactors factors_of(const std::array<glm::dvec3, 3>& surface, const std::array<glm::dvec2, 3>& plane);

/// Means by area of the surface. places [disc.points]; rounding: how exactly they are known (0: doubles).
Distortion distortion_of(const Disc& disc, const std::vector<glm::dvec2>& places, double rounding = 0.0);

/// The sides (i from point i to the next) of a closed polygon that cross another, in pairs. A disc without
/// flips whose border has none is laid without overlap. cost O(n log n) for sides that are short against the whole.
std::vector<std::size_t> crossing_sides(const std::vector<glm::dvec2>& polygon);

/// Moves points around few flipped triangles and crossing border sides between their neighbours until there are none.
/// false where that does not help. cost about 1 us a triangle and round.
bool mend(const Disc& disc, std::vector<glm::dvec2>& places);

}  // namespace luminist
