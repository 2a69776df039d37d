#include "prep/half_edges.h"

#include <cstring>

namespace luminist {
namespace {

using Place = std::array<std::uint32_t, 3>;

Place place_of(const Vec3& p) {
  const Vec3 positive_zero = p + 0.0F;  // -0 + 0 is 0
  Place bits{};
  std::memcpy(bits.data(), &positive_zero, sizeof(bits));
  return bits;
}

struct PlaceHash {
  std::size_t operator()(const Place& place) const {
    std::size_t h = 0;
    for (const std::uint32_t word : place) h = (h ^ word) * 0x9e3779b97f4a7c15ULL;
    return h ^ (h >> 32);
  }
};

}  // namespace

std::vector<std::uint32_t> joined_positions(std::span<const Vec3> positions) {
  std::unordered_map<Place, std::uint32_t, PlaceHash> first;
  std::vector<std::uint32_t> joined;
  joined.reserve(positions.size());
  for (const Vec3& p : positions) {
    joined.push_back(first.try_emplace(place_of(p), static_cast<std::uint32_t>(joined.size())).first->second);
  }
  return joined;
}

}  // namespace luminist
