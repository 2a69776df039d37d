#pragma once
// scene/triple_index.h -- numbers distinct triples of 32-bit words in the order they come: corners of an OBJ face,
// or the bits of a position.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/math.h"

namespace luminist {

/// Open addressing with linear probing, at most half full. cost O(1) for each triple.
class TripleIndex {
 public:
  using Triple = std::array<std::uint32_t, 3>;

  explicit TripleIndex(std::size_t expected = 0) { slots_.assign(std::bit_ceil(2 * expected + 16), kFree); }

  /// The number of the triple: size() - 1 after the call if it is new.
  std::uint32_t add(const Triple& triple) {
    if (2 * (triples_.size() + 1) > slots_.size()) grow();
    std::uint32_t& slot = slots_[find_slot(triple)];
    if (slot == kFree) {
      slot = static_cast<std::uint32_t>(triples_.size());
      triples_.push_back(triple);
    }
    return slot;
  }
  [[nodiscard]] std::size_t size() const { return triples_.size(); }

 private:
  static constexpr std::uint32_t kFree = 0xffffffffU;

  [[nodiscard]] std::size_t find_slot(const Triple& triple) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t word : triple) hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL, hash ^= hash >> 29U;
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash & mask;
    while (slots_[slot] != kFree && triples_[slots_[slot]] != triple) slot = (slot + 1) & mask;
    return slot;
  }
  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < triples_.size(); ++i) slots_[find_slot(triples_[i])] = static_cast<std::uint32_t>(i);
  }

  std::vector<Triple> triples_;
  std::vector<std::uint32_t> slots_;
};

/// The bits of a position; both zeros are one.
inline TripleIndex::Triple position_bits(const Vec3& p) {
  const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x == 0.0F ? 0.0F : x); };
  return {bits(p.x), bits(p.y), bits(p.z)};
}

}  // namespace luminist
