// prep/chart_mend.cpp -- mend() of chart_map.h.
#include <algorithm>

#include "prep/chart_map.h"

namespace luminist {
namespace {

/// The points of flipped triangles and of border sides that cross.
std::vector<std::uint32_t> bad_points(const Disc& disc, const std::vector<glm::dvec2>& places) {
  std::vector<std::uint32_t> bad;
  for (const auto& t : disc.triangles) {
    const glm::dvec2 e = places[t[1]] - places[t[0]];
    const glm::dvec2 f = places[t[2]] - places[t[0]];
    if (!(e.x * f.y - e.y * f.x > 0.0)) bad.insert(bad.end(), t.begin(), t.end());
  }
  std::vector<glm::dvec2> border;
  for (const std::uint32_t point : disc.border) border.push_back(places[point]);
  for (const std::size_t side : crossing_sides(border)) {
    bad.push_back(disc.border[side]), bad.push_back(disc.border[(side + 1) % border.size()]);
  }
  std::ranges::sort(bad);
  const auto rest = std::ranges::unique(bad);
  bad.erase(rest.begin(), rest.end());
  return bad;
}

using PointNeighbours = std::vector<std::vector<std::uint32_t>>;

/// An inner neighbour is there twice, for each point alike; those along the border once.
PointNeighbours neighbours_of(const Disc& disc) {
  PointNeighbours around(disc.points.size());
  for (const auto& t : disc.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      around[t[k]].push_back(t[(k + 1) % 3]), around[t[k]].push_back(t[(k + 2) % 3]);
    }
  }
  return around;
}

void grow(std::vector<std::uint32_t>& points, const PointNeighbours& around) {
  std::vector<std::uint32_t> grown = points;
  for (const std::uint32_t p : points) grown.insert(grown.end(), around[p].begin(), around[p].end());
  std::ranges::sort(grown);
  const auto rest = std::ranges::unique(grown);
  grown.erase(rest.begin(), rest.end());
  points = std::move(grown);
}

}  // namespace

bool mend(const Disc& disc, std::vector<glm::dvec2>& places) {
  constexpr int kRounds = 8;
  constexpr int kSweeps = 12;
  const std::size_t most = std::max<std::size_t>(12, disc.points.size() / 40);  // more is no local fault
  std::vector<std::uint32_t> bad = bad_points(disc, places);
  if (bad.empty()) return true;
  if (bad.size() > most) return false;
  const PointNeighbours around = neighbours_of(disc);
  for (int round = 0; round < kRounds; ++round) {
    for (int ring = 0; ring < round / 2; ++ring) grow(bad, around);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (const std::uint32_t p : bad) {
        glm::dvec2 sum(0.0);
        for (const std::uint32_t q : around[p]) sum += places[q];
        places[p] = 0.5 * (places[p] + sum / static_cast<double>(around[p].size()));
      }
    }
    bad = bad_points(disc, places);
    if (bad.empty()) return true;
    if (bad.size() > most) return false;
  }
  return false;
}

}  // namespace luminist
