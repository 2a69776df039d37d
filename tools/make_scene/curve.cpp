#include "make_scene/curve.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/check.h"

namespace luminist {
namespace {

constexpr int kSamples = 32;  // of the length table, per segment
constexpr int kFrames = 256;  // of a sweep

struct Frame {
  Point3 a;
  Point3 b;
};

/// Rotation-minimizing frames at equal steps of a path. source Wang et al. 2008, double reflection.
std::vector<Frame> frames_along(const Curve& path, const Point3& up) {
  std::vector<Frame> frames;
  Point3 tangent = path.tangent(0.0);
  Point3 side = up - tangent * glm::dot(up, tangent);
  if (glm::length(side) < 1e-6)
    side =
        Point3(tangent.y, tangent.z, tangent.x) - tangent * glm::dot(Point3(tangent.y, tangent.z, tangent.x), tangent);
  side = glm::normalize(side);
  Point3 place(path.at(0.0));
  frames.push_back({side, glm::cross(tangent, side)});
  for (int i = 1; i <= kFrames; ++i) {
    const double t = static_cast<double>(i) / kFrames;
    const Point3 next_place(path.at(t));
    const Point3 next_tangent = path.tangent(t);
    const Point3 v1 = next_place - place;
    const double c1 = glm::dot(v1, v1);
    const Point3 side_l = side - v1 * (2.0 / c1 * glm::dot(v1, side));
    const Point3 tangent_l = tangent - v1 * (2.0 / c1 * glm::dot(v1, tangent));
    const Point3 v2 = next_tangent - tangent_l;
    const double c2 = glm::dot(v2, v2);
    side = c2 < 1e-18 ? side_l : side_l - v2 * (2.0 / c2 * glm::dot(v2, side_l));
    side = glm::normalize(side - next_tangent * glm::dot(side, next_tangent));
    place = next_place, tangent = next_tangent;
    frames.push_back({side, glm::cross(tangent, side)});
  }
  return frames;
}

}  // namespace

Curve::Curve(std::vector<Point4> points) {
  LUM_CHECK(points.size() >= 2, "a curve joins points");
  points_.push_back(2.0 * points[0] - points[1]);
  points_.insert(points_.end(), points.begin(), points.end());
  points_.push_back(2.0 * points[points.size() - 1] - points[points.size() - 2]);
  const int segments = static_cast<int>(points.size()) - 1;
  lengths_.push_back(0.0);
  Point3 before(evaluate(0.0));
  for (int i = 1; i <= segments * kSamples; ++i) {
    const Point3 here(evaluate(static_cast<double>(i) / kSamples));
    lengths_.push_back(lengths_.back() + glm::length(here - before));
    before = here;
  }
}

Curve Curve::profile(const std::vector<Point2>& points) {
  std::vector<Point4> lifted;
  lifted.reserve(points.size());
  for (const Point2& p : points) lifted.emplace_back(p.x, p.y, 0.0, 0.0);
  return Curve(std::move(lifted));
}

Point4 Curve::evaluate(double s) const {
  const int segments = static_cast<int>(points_.size()) - 3;
  const int k = std::clamp(static_cast<int>(s), 0, segments - 1);
  const Point4* p = &points_[static_cast<std::size_t>(k)];
  double knot[4] = {0.0, 0.0, 0.0, 0.0};
  for (int i = 1; i < 4; ++i) knot[i] = knot[i - 1] + std::sqrt(glm::length(Point3(p[i]) - Point3(p[i - 1])));
  const double t = knot[1] + (knot[2] - knot[1]) * (s - k);
  const auto blend = [&](const Point4& a, const Point4& b, double ta, double tb) {
    return a * ((tb - t) / (tb - ta)) + b * ((t - ta) / (tb - ta));
  };
  const Point4 a1 = blend(p[0], p[1], knot[0], knot[1]);
  const Point4 a2 = blend(p[1], p[2], knot[1], knot[2]);
  const Point4 a3 = blend(p[2], p[3], knot[2], knot[3]);
  return blend(blend(a1, a2, knot[0], knot[2]), blend(a2, a3, knot[1], knot[3]), knot[1], knot[2]);
}

Point4 Curve::at(double t) const {
  const double wanted = std::clamp(t, 0.0, 1.0) * lengths_.back();
  const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, wanted);
  const auto i = above - lengths_.begin();
  const double low = lengths_[static_cast<std::size_t>(i - 1)];
  const double high = lengths_[static_cast<std::size_t>(i)];
  const double part = high > low ? (wanted - low) / (high - low) : 0.0;
  return evaluate((static_cast<double>(i - 1) + part) / kSamples);
}

Point3 Curve::tangent(double t) const {
  const double step = 1e-4;
  return glm::normalize(Point3(at(std::min(t + step, 1.0))) - Point3(at(std::max(t - step, 0.0))));
}

double Curve::fraction_at_point(std::size_t index) const {
  return lengths_[index * kSamples] / lengths_.back();
}

Surface revolve(const Curve& profile) {
  return [profile](double u, double v) {
    const Point4 p = profile.at(v);
    const double radius = std::max(p.x, 0.0);
    const double angle = 2.0 * kPi * u;
    return Point3(radius * std::sin(angle), p.y, radius * std::cos(angle));
  };
}

Surface sweep(const Curve& path, const Point3& up, Section section) {
  const auto frames = std::make_shared<const std::vector<Frame>>(frames_along(path, up));
  return [path, frames, section = std::move(section)](double u, double v) {
    const double place = std::clamp(v, 0.0, 1.0) * kFrames;
    const auto i = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(kFrames - 1));
    const double part = place - static_cast<double>(i);
    const Point3 a = (*frames)[i].a * (1.0 - part) + (*frames)[i + 1].a * part;
    const Point3 b = (*frames)[i].b * (1.0 - part) + (*frames)[i + 1].b * part;
    const Point4 center = path.at(v);
    const double angle = 2.0 * kPi * u;
    const Point2 out = section ? section(angle, v) : Point2(std::cos(angle), std::sin(angle));
    return Point3(center) + (a * out.x + b * out.y) * center.w;
  };
}

}  // namespace luminist
