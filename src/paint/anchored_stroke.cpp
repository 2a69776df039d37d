#include "paint/anchored_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace luminist {
namespace {

constexpr float kStepsPerDiameter = 8.0F;
constexpr float kFinestStep = 0.0005F;   // picture heights: half a pixel of a thousand rows
constexpr float kCoarsestStep = 0.02F;   // picture heights: forms are smaller than the largest brushes
constexpr float kFarthestReach = 50.0F;  // picture heights: points further out are no strokes, see check_stroke()
constexpr float kLeastDiameter = 1e-5F;  // what brush_qualities() takes
constexpr float kMostDiameter = 100.0F;

bool fades_by_normals(const Brush& brush) {
  return brush.gradient > 0.0F && !brush.screen_gradient;
}

/// Scene units in a unit of the object, in the mean of its axes.
float scale_of(const Mat4& world_from_object) {
  float sum = 0.0F;
  for (int axis = 0; axis < 3; ++axis) sum += glm::length(Vec3(world_from_object[axis]));
  return sum / 3.0F;
}

/// The hand's way in steps.
std::vector<StrokePoint> in_steps(const Stroke& stroke) {
  const float step = std::clamp(stroke.brush.diameter / kStepsPerDiameter, kFinestStep, kCoarsestStep);
  std::vector<StrokePoint> points;
  for (std::size_t i = 0; i + 1 < stroke.points.size(); ++i) {
    const StrokePoint& a = stroke.points[i];
    const StrokePoint& b = stroke.points[i + 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / step)));
    for (int s = 0; s < steps; ++s) {
      const float t = static_cast<float>(s) / static_cast<float>(steps);
      points.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.pressure + t * (b.pressure - a.pressure)});
    }
  }
  if (!stroke.points.empty()) points.push_back(stroke.points.back());
  return points;
}

Vec3 blend(const std::array<Vec3, 3>& corners, const Vec3& weights) {
  return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}

/// Across a triangle in the world, out of the side that is the front in the object's frame; of any length. Flattened
/// and mirrored objects have sides too.
Vec3 front_in_world(const std::array<Vec3, 3>& corners, const Mat4& place) {
  const Mat3 turn(place);
  const Vec3 across = glm::cross(turn * (corners[1] - corners[0]), turn * (corners[2] - corners[0]));
  return glm::determinant(turn) < 0.0F ? -across : across;
}

AnchoredPoint anchor(const RayHit& hit, const StrokePoint& point, float diameter, const PaintView& view) {
  const std::array<Vec3, 3> corners = view.corners(static_cast<int>(hit.object), hit.triangle);
  const Mat4& place = view.world_from(static_cast<int>(hit.object));
  const Vec3 world(place * Vec4(blend(corners, hit.weights()), 1.0F));
  const bool front = glm::dot(front_in_world(corners, place), view.eye() - world) > 0.0F;
  const Vec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const float radius = 0.5F * diameter * view.height_at(hit.distance) / scale_of(place);
  return {view.name(static_cast<int>(hit.object)),
          hit.triangle,
          hit.weights(),
          front ? normal : -normal,
          radius,
          point.pressure};
}

/// A point on its new picture.
struct SeenPoint {
  Vec2 point{0.0F};
  float diameter = 0.0F;  ///< at full pressure
  float pressure = 1.0F;
  bool behind = false;  ///< another object
  bool inside = true;   ///< of the picture, not only its dab
};

enum class Sight { kShown, kHidden, kOutside };

/// Puts one stroke on the picture of a view.
class Carrier {
 public:
  Carrier(const AnchoredStroke& stroke, const PaintView& view) : stroke_(stroke), view_(view) {}

  Result<CarriedStroke> carry() {
    if (!stroke_.follows_points()) {
      result_.pieces.push_back({stroke_.brush, stroke_.picture});
      return std::move(result_);
    }
    for (const AnchoredPoint& point : stroke_.points) {
      SeenPoint seen;
      LUM_TRY(const Sight sight, look_at(point, seen));
      if (sight == Sight::kHidden) ++result_.hidden;
      if (sight == Sight::kOutside) ++result_.outside;
      if (sight != Sight::kShown) continue;
      if (!piece_.empty() && apart(piece_.back(), seen)) finish_piece();
      piece_.push_back(seen);
    }
    if (!piece_.empty()) finish_piece();
    return std::move(result_);
  }

 private:
  Result<Sight> look_at(const AnchoredPoint& point, SeenPoint& seen) const {
    LUM_TRY(const int object, view_.object(point.object));
    if (point.triangle >= view_.triangles(object)) {
      return Error{ErrorKind::kBadContent, fmt::format("\"{}\" has no triangle {}", point.object, point.triangle), "",
                   "", "the mesh is not the one that was painted"};
    }
    const Mat4& place = view_.world_from(object);
    const std::array<Vec3, 3> corners = view_.corners(object, point.triangle);
    const Vec3 world(place * Vec4(blend(corners, point.weights), 1.0F));
    const std::optional<PicturePlace> where = view_.place_of(world);
    if (!where) return Sight::kOutside;
    seen.point = where->point;
    seen.diameter = std::clamp(2.0F * point.radius * scale_of(place) / where->height, kLeastDiameter, kMostDiameter);
    seen.pressure = point.pressure;
    // A dab ends at its diameter from the middle.
    const float reach = std::min(seen.diameter, kFarthestReach);
    const Vec2 beside = glm::max(Vec2(0.0F), glm::max(-seen.point, seen.point - Vec2(view_.aspect(), 1.0F)));
    if (std::max(beside.x, beside.y) > reach) return Sight::kOutside;
    if (turned_away(point.normal, corners, place, world)) return Sight::kHidden;
    const bool behind = view_.hidden(world);
    const bool clipped = !stroke_.brush.clip.empty();
    if (clipped ? behind && view_.hidden(world, object) : behind) return Sight::kHidden;
    seen.behind = behind;
    seen.inside = beside == Vec2(0.0F);
    return Sight::kShown;
  }

  /// Whether the painted side looks away from the eye.
  [[nodiscard]] bool turned_away(const Vec3& normal, const std::array<Vec3, 3>& corners, const Mat4& place,
                                 const Vec3& world) const {
    const bool front = glm::dot(normal, glm::cross(corners[1] - corners[0], corners[2] - corners[0])) > 0.0F;
    const float towards = glm::dot(front_in_world(corners, place), view_.eye() - world);
    return !(front ? towards > 0.0F : towards < 0.0F);
  }

  static bool apart(const SeenPoint& a, const SeenPoint& b) {
    constexpr float kStretch = kStepsPerDiameter / 2.0F;  // of a step, up to the radius
    return glm::distance(a.point, b.point) > std::max(0.5F * std::max(a.diameter, b.diameter), kStretch * kFinestStep);
  }

  void finish_piece() {
    const std::vector<SeenPoint> piece = std::exchange(piece_, {});
    const auto count = static_cast<int>(piece.size());
    if (!std::any_of(piece.begin(), piece.end(), [](const SeenPoint& p) { return p.inside && !p.behind; })) {
      result_.hidden += count;
      return;
    }
    result_.shown += count;
    for (const SeenPoint& p : piece) result_.covered += p.behind ? 1 : 0;
    const bool first = result_.pieces.empty();
    if (stroke_.brush.bucket && !first) return;  // one fills the object
    Stroke stroke{stroke_.brush, {}};
    if (!stroke.brush.bucket) {
      stroke.brush.diameter = 0.0F;
      for (const SeenPoint& p : piece) stroke.brush.diameter = std::max(stroke.brush.diameter, p.diameter);
    }
    if (!first && fades_by_normals(stroke.brush)) stroke.brush.repeat_peak = true;
    for (const SeenPoint& p : piece) {
      const float share = stroke_.brush.bucket ? 1.0F : p.diameter / stroke.brush.diameter;
      stroke.points.push_back({p.point.x, p.point.y, p.pressure * share});
    }
    result_.pieces.push_back(std::move(stroke));
  }

  const AnchoredStroke& stroke_;
  const PaintView& view_;
  std::vector<SeenPoint> piece_;
  CarriedStroke result_;
};

}  // namespace

bool AnchoredStroke::follows_points() const {
  return !brush.bucket || fades_by_normals(brush);
}

Result<AnchoredStroke> anchored(const Stroke& stroke, const PaintView& view) {
  AnchoredStroke result;
  result.brush = stroke.brush;
  result.picture = stroke.points;
  int only = SurfaceRays::kAnyObject;
  if (stroke.brush.clip == "@") {
    const RayHit under = stroke.points.empty() ? RayHit() : view.at(stroke.points.front());
    if (!under.hit()) {
      return Error{ErrorKind::kBadContent, "there is no object under the first point", "", "clip",
                   "start the stroke on an object"};
    }
    only = static_cast<int>(under.object);
    result.brush.clip = view.name(only);
  } else if (!stroke.brush.clip.empty()) {
    LUM_TRY(only, view.object(stroke.brush.clip));
  }
  if (!result.follows_points()) return result;
  for (const StrokePoint& point : in_steps(stroke)) {
    if (const RayHit hit = view.at(point, only); hit.hit()) {
      result.points.push_back(anchor(hit, point, stroke.brush.diameter, view));
    } else {
      ++result.off_surface;
    }
  }
  return result;
}

Result<CarriedStroke> carried(const AnchoredStroke& stroke, const PaintView& view) {
  return Carrier(stroke, view).carry();
}

}  // namespace luminist
