#pragma once
// base/disjoint_sets.h -- what belongs together, found pair by pair.
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace luminist {

/// Disjoint sets of 0 .. size - 1; the smallest member stands for its set, so that results have no hidden order.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Whether they were apart.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a != b) parent_[a > b ? a : b] = a > b ? b : a;
    return a != b;
  }
  /// Every member's set, numbered densely in order of appearance, and how many there are.
  std::pair<std::vector<std::uint32_t>, std::uint32_t> numbered() {
    std::vector<std::uint32_t> number(parent_.size());
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < number.size(); ++i) {
      const std::uint32_t root = find(i);
      number[i] = root == i ? count++ : number[root];  // a root is its set's smallest member
    }
    return {std::move(number), count};
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace luminist
