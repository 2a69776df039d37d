#pragma once
// prep/triangle_tree.h -- which point of a surface is nearest.
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "scene/mesh.h"

namespace luminist {

/// Boxes around boxes around the triangles of a mesh, which it copies. thread any, const calls are concurrent.
class TriangleTree {
 public:
  struct Nearest {
    std::uint32_t triangle = 0;
    Vec3 weights{0.0F};  ///< of the triangle's corners; sum 1
    Vec3 point{0.0F};
    float squared_distance = std::numeric_limits<float>::infinity();
  };

  /// Indices are checked by whoever made the mesh. cost O(n log n).
  explicit TriangleTree(const Mesh& mesh);

  /// The nearest of the triangles' nearest points that `accept` (bool of a Nearest) takes, at most `reach` away; of
  /// several that are equally near the first in the tree's order. cost O(log n) where few are refused.
  template <class Accept>
  [[nodiscard]] std::optional<Nearest> nearest(const Vec3& p, float reach, Accept&& accept) const {
    Nearest best;
    best.squared_distance = reach * reach;
    bool found = false;
    std::array<std::uint32_t, kDeepest> waiting;
    std::size_t count = 0;
    if (!nodes_.empty()) waiting[count++] = 0;
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      if (squared_distance(node.box, p) > best.squared_distance) continue;
      if (node.triangles == 0) {
        // The nearer child on top of the stack.
        const std::uint32_t left = node.first;
        const bool right_is_nearer = squared_distance(nodes_[left].box, p) > squared_distance(nodes_[left + 1].box, p);
        waiting[count++] = right_is_nearer ? left : left + 1;
        waiting[count++] = right_is_nearer ? left + 1 : left;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.triangles; ++i) {
        const Nearest here = nearest_on(i, p);
        const bool nearer =
            found ? here.squared_distance < best.squared_distance : here.squared_distance <= best.squared_distance;
        if (!nearer || !accept(here)) continue;
        best = here;
        found = true;
      }
    }
    return found ? std::optional(best) : std::nullopt;
  }

 private:
  static constexpr std::size_t kDeepest = 128;  ///< waiting nodes; halves of halves: 1 + log2 of the triangles

  struct Node {
    Box box;
    std::uint32_t first = 0;      ///< of order_, or the left child; the right one is the next
    std::uint32_t triangles = 0;  ///< 0: a node of two
  };

  static float squared_distance(const Box& box, const Vec3& p) {
    const Vec3 away = p - glm::clamp(p, box.lo, box.hi);
    return glm::dot(away, away);
  }
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t last, const std::vector<Vec3>& middles);
  /// On the triangle at a place of order_.
  [[nodiscard]] Nearest nearest_on(std::uint32_t place, const Vec3& p) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;          ///< triangles of the mesh
  std::vector<std::array<Vec3, 3>> corners_;  ///< [order_]
};

}  // namespace luminist
