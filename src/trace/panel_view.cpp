#include "trace/panel_view.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

constexpr float kSmall = 0.02F;  // steradians: below, its angles differ from those of a plane by what floats lose

/// Of a plane through the origin and a side of a rectangle at height z, in the rectangle's own axes.
float slope(float side, float z) {
  return side / std::sqrt(z * z + side * side);
}

float angle(float a, float b) {
  return std::acos(std::clamp(-a * b, -1.0F, 1.0F));
}

}  // namespace

PanelView::PanelView(const RigLight& light, const Vec3& from) : light_(&light), from_(from) {
  const Vec3 way = light.position - from;
  const float half = light.half_side;
  const Vec2 middle(glm::dot(way, light.right), glm::dot(way, light.up));
  lo_ = Vec3(middle - half, -std::abs(glm::dot(way, light.axis)));
  hi_ = middle + half;
  const float most = light.panel_area() / std::max(lo_.z * lo_.z, 1e-30F);  // steradians, if it were straight ahead
  if (!(lo_.z < 0.0F) || most < kSmall) return;
  const float a = -slope(lo_.y, lo_.z);
  const float b = slope(hi_.x, lo_.z);
  const float c = slope(hi_.y, lo_.z);
  const float d = -slope(lo_.x, lo_.z);
  lower_ = a;
  upper_ = c;
  first_angle_ = 2.0F * kPiF - angle(c, d) - angle(d, a);
  solid_angle_ = angle(a, b) + angle(b, c) - first_angle_;
  even_ = solid_angle_ > kSmall;
}

Vec3 PanelView::point(const Vec2& place) const {
  if (!even_) return light_->panel_point(place);
  constexpr float kEdge = 1e-6F;
  const float at = place.x * solid_angle_ + first_angle_;
  const float f = (std::cos(at) * lower_ - upper_) / std::sin(at);
  const float cosine = std::clamp(std::copysign(1.0F, f) / std::sqrt(f * f + lower_ * lower_), -1.0F, 1.0F);
  const float x =
      std::clamp(-cosine * lo_.z / std::sqrt(std::max(1.0F - cosine * cosine, kEdge * kEdge)), lo_.x, hi_.x);
  const float square = x * x + lo_.z * lo_.z;
  const float from = lo_.y / std::sqrt(square + lo_.y * lo_.y);
  const float to = hi_.y / std::sqrt(square + hi_.y * hi_.y);
  const float h = from + place.y * (to - from);
  const float y = std::clamp(h * std::sqrt(square / std::max(1.0F - h * h, kEdge)), lo_.y, hi_.y);
  return from_ + x * light_->right + y * light_->up - std::abs(lo_.z) * light_->axis;
}

float PanelView::pdf(float square, float cosine) const {
  return even_ ? 1.0F / solid_angle_ : square / (cosine * light_->panel_area());
}

}  // namespace luminist
