#include "scene/polygon.h"

#include <cstddef>
#include <numeric>

namespace luminist {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using DVec2 = glm::dvec2;

double turn(const DVec2& a, const DVec2& b, const DVec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Newell's area vector: twice the area along the mean normal, also for bent and concave polygons.
glm::dvec3 area_vector(std::span<const Vec3> corners) {
  glm::dvec3 sum(0.0);
  const glm::dvec3 origin(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[(i + 1) % corners.size()]) - origin);
  }
  return sum;
}

/// Projected along the largest axis of the area vector, so that the polygon turns counter-clockwise.
std::vector<DVec2> flattened(std::span<const Vec3> corners) {
  const glm::dvec3 n = area_vector(corners);
  const glm::dvec3 a = glm::abs(n);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : (a.y >= a.z ? 1 : 2);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<DVec2> points;
  for (const Vec3& p : corners) points.push_back(n[axis] >= 0.0 ? DVec2(p[u], p[v]) : DVec2(p[v], p[u]));
  return points;
}

bool is_ear(const std::vector<DVec2>& points, const std::vector<std::uint32_t>& ring, std::size_t at) {
  const std::size_t n = ring.size();
  const DVec2 &a = points[ring[(at + n - 1) % n]], &b = points[ring[at]], &c = points[ring[(at + 1) % n]];
  if (turn(a, b, c) <= 0.0) return false;
  for (std::size_t k = 2; k + 1 < n; ++k) {
    const DVec2& p = points[ring[(at + k) % n]];
    if (p == a || p == b || p == c) continue;
    if (turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0) return false;
  }
  return true;
}

std::vector<Triangle> clip_ears(std::span<const Vec3> corners) {
  const std::vector<DVec2> points = flattened(corners);
  std::vector<std::uint32_t> ring(corners.size());
  std::iota(ring.begin(), ring.end(), 0U);
  std::vector<Triangle> triangles;
  std::size_t at = 0, tried = 0;
  while (ring.size() > 2) {
    at %= ring.size();
    // A ring without an ear (it crosses itself) is cut anyway: the count of triangles stays n - 2.
    if (!is_ear(points, ring, at) && tried++ < ring.size()) {
      ++at;
      continue;
    }
    const std::size_t n = ring.size();
    triangles.push_back({ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
    tried = 0;
  }
  return triangles;
}

std::vector<Triangle> cut_quad(std::span<const Vec3> c) {
  const std::vector<DVec2> p = flattened(c);
  const bool inner_02 = turn(p[0], p[1], p[2]) > 0.0 && turn(p[0], p[2], p[3]) > 0.0;
  const bool inner_13 = turn(p[0], p[1], p[3]) > 0.0 && turn(p[1], p[2], p[3]) > 0.0;
  const bool shorter_02 = glm::distance(c[0], c[2]) <= glm::distance(c[1], c[3]);
  if (inner_02 == inner_13 ? shorter_02 : inner_02) return {{0, 1, 2}, {0, 2, 3}};
  return {{0, 1, 3}, {1, 2, 3}};
}

}  // namespace

std::vector<Triangle> triangulate(std::span<const Vec3> corners) {
  constexpr std::size_t kMostEars = 1024;
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {{0, 1, 2}};
  if (corners.size() == 4) return cut_quad(corners);
  if (corners.size() <= kMostEars) return clip_ears(corners);
  std::vector<Triangle> fan;
  for (std::uint32_t i = 2; i < corners.size(); ++i) fan.push_back({0, i - 1, i});
  return fan;
}

}  // namespace luminist
