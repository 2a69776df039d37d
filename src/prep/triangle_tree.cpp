#include "prep/triangle_tree.h"

#include <algorithm>
#include <numeric>

namespace luminist {
namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles

/// Weights of a point's nearest point on a triangle. source Ericson, Real-Time Collision Detection (2005), 5.1.5.
Vec3 nearest_weights(const std::array<Vec3, 3>& t, const Vec3& p) {
  const Vec3 ab = t[1] - t[0];
  const Vec3 ac = t[2] - t[0];
  const float d1 = glm::dot(ab, p - t[0]);
  const float d2 = glm::dot(ac, p - t[0]);
  if (d1 <= 0.0F && d2 <= 0.0F) return {1, 0, 0};
  const float d3 = glm::dot(ab, p - t[1]);
  const float d4 = glm::dot(ac, p - t[1]);
  if (d3 >= 0.0F && d4 <= d3) return {0, 1, 0};
  const float c = d1 * d4 - d3 * d2;
  if (c <= 0.0F && d1 >= 0.0F && d3 <= 0.0F) {
    const float v = d1 / (d1 - d3);
    return {1.0F - v, v, 0};
  }
  const float d5 = glm::dot(ab, p - t[2]);
  const float d6 = glm::dot(ac, p - t[2]);
  if (d6 >= 0.0F && d5 <= d6) return {0, 0, 1};
  const float b = d5 * d2 - d1 * d6;
  if (b <= 0.0F && d2 >= 0.0F && d6 <= 0.0F) {
    const float w = d2 / (d2 - d6);
    return {1.0F - w, 0, w};
  }
  const float a = d3 * d6 - d5 * d4;
  if (a <= 0.0F && d4 - d3 >= 0.0F && d5 - d6 >= 0.0F) {
    const float w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1.0F - w, w};
  }
  return Vec3(a, b, c) / (a + b + c);
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) {
  if (mesh.triangles.empty()) return;
  std::vector<Vec3> middles;
  for (const auto& t : mesh.triangles) {
    middles.push_back((mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0F);
  }
  order_.resize(mesh.triangles.size());
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(order_.size()), middles);
  for (const std::uint32_t triangle : order_) {
    const auto& t = mesh.triangles[triangle];
    corners_.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  }
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    for (std::uint32_t k = node.first; k < node.first + node.triangles; ++k) {
      for (const Vec3& corner : corners_[k]) node.box.extend(corner);
    }
    if (node.triangles > 0) continue;
    for (const std::uint32_t child : {node.first, node.first + 1}) {
      node.box.extend(nodes_[child].box.lo), node.box.extend(nodes_[child].box.hi);
    }
  }
}

void TriangleTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t last,
                         const std::vector<Vec3>& middles) {
  if (last - first <= kLeaf) {
    nodes_[node].first = first, nodes_[node].triangles = last - first;
    return;
  }
  Box box;
  for (std::uint32_t i = first; i < last; ++i) box.extend(middles[order_[i]]);
  const Vec3 size = box.hi - box.lo;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
  const std::uint32_t half = first + (last - first) / 2;
  const auto at = [this](std::uint32_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [&](std::uint32_t a, std::uint32_t b) {
    return middles[a][axis] != middles[b][axis] ? middles[a][axis] < middles[b][axis] : a < b;
  });
  const auto left = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node].first = left;
  build(left, first, half, middles);
  build(left + 1, half, last, middles);
}

TriangleTree::Nearest TriangleTree::nearest_on(std::uint32_t place, const Vec3& p) const {
  const std::array<Vec3, 3>& t = corners_[place];
  Nearest nearest;
  nearest.triangle = order_[place];
  nearest.weights = nearest_weights(t, p);
  // A triangle without area has no inside to divide by.
  if (!is_finite(nearest.weights)) nearest.weights = {1, 0, 0};
  nearest.point = nearest.weights.x * t[0] + nearest.weights.y * t[1] + nearest.weights.z * t[2];
  nearest.squared_distance = glm::dot(p - nearest.point, p - nearest.point);
  return nearest;
}

}  // namespace luminist
