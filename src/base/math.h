#pragma once
// base/math.h -- vectors (GLM), boxes and the frame that makes lengths relative to the scene.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace luminist {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat3 = glm::mat3;
using Mat4 = glm::mat4;

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr float kPiF = static_cast<float>(kPi);

/// Axis-aligned box in world space; empty until the first extend().
struct Box {
  Vec3 lo{std::numeric_limits<float>::infinity()};
  Vec3 hi{-std::numeric_limits<float>::infinity()};

  [[nodiscard]] bool empty() const { return !(lo.x <= hi.x); }
  void extend(const Vec3& p) { lo = glm::min(lo, p), hi = glm::max(hi, p); }
  [[nodiscard]] Vec3 center() const { return 0.5F * (lo + hi); }
  /// Of its eight corners; index 0 to 7.
  [[nodiscard]] Vec3 corner(int index) const {
    return Vec3((index & 1) != 0 ? hi.x : lo.x, (index & 2) != 0 ? hi.y : lo.y, (index & 4) != 0 ? hi.z : lo.z);
  }
  [[nodiscard]] float radius() const { return empty() ? 0.0F : 0.5F * glm::length(hi - lo); }
};

/// Where the scene is and how large: parameters whose scale is "scene" are measured against it.
struct SceneFrame {
  Vec3 center{0.0F};
  float radius = 1.0F;  ///< half the diagonal of the bounds, > 0
};

/// v at length 1; `otherwise` where it has next to no length, or too much.
inline Vec3 unit_or(const Vec3& v, const Vec3& otherwise) {
  const float length = glm::length(v);
  return length > 1e-6F && std::isfinite(length) ? v / length : otherwise;
}

/// The mean of the three channels.
inline float brightness(const Vec3& color) {
  return (color.x + color.y + color.z) / 3.0F;
}

/// The largest of the three components.
inline float largest(const Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

inline bool is_finite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Two unit vectors that complete n (unit) to a right-handed frame; continuous except at n = -z (Duff et al. 2017).
inline void tangent_frame(const Vec3& n, Vec3& t, Vec3& b) {
  const float sign = std::copysign(1.0F, n.z);
  const float a = -1.0F / (sign + n.z);
  const float c = n.x * n.y * a;
  t = Vec3(1.0F + sign * n.x * n.x * a, sign * c, -sign * n.x);
  b = Vec3(c, sign + n.y * n.y * a, -n.y);
}

}  // namespace luminist
