#include "prep/chart_disc.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>

namespace luminist {
namespace {

/// A region by its own numbers: sides 3 i + k of its triangle i.
struct Patch {
  std::vector<std::uint32_t> across;  ///< [sides] the neighbour's side where they are joined, or SurfaceSides::kNone
  std::vector<double> lengths;        ///< [sides] of a cut there
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< of points
  std::uint32_t points = 0;

  [[nodiscard]] std::uint32_t from(std::uint32_t side) const { return triangles[side / 3][side % 3]; }
  [[nodiscard]] std::uint32_t to(std::uint32_t side) const { return triangles[side / 3][(side % 3 + 1) % 3]; }

  /// Corners are one point where their triangles are joined around it.
  void join_corners() {
    DisjointSets corners(across.size());
    for (std::uint32_t s = 0; s < across.size(); ++s) {
      if (across[s] == SurfaceSides::kNone) continue;
      const auto after = [](std::uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; };
      corners.join(s, after(across[s])), corners.join(after(s), across[s]);
    }
    const auto [number, count] = corners.numbered();
    points = count;
    for (std::uint32_t s = 0; s < across.size(); ++s) triangles[s / 3][s % 3] = number[s];
  }

  [[nodiscard]] bool has_border() const { return std::ranges::count(across, SurfaceSides::kNone) > 0; }
  [[nodiscard]] long characteristic() const {
    const long open = std::ranges::count(across, SurfaceSides::kNone);
    const long edges = (static_cast<long>(across.size()) + open) / 2;
    return static_cast<long>(points) - edges + static_cast<long>(triangles.size());
  }
};

Patch patch_of(const SurfaceSides& sides, const Region& region) {
  Patch patch;
  std::unordered_map<std::uint32_t, std::uint32_t> local;
  local.reserve(region.size());
  for (std::uint32_t i = 0; i < region.size(); ++i) local[region[i]] = i;
  for (const std::uint32_t f : region) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = sides.across[3 * f + k];
      const auto at = other == SurfaceSides::kNone ? local.end() : local.find(other / 3);
      patch.across.push_back(at == local.end() ? SurfaceSides::kNone : 3 * at->second + other % 3);
      const double turn = sides.turns[3 * f + k];
      patch.lengths.push_back(sides.lengths[3 * f + k] / (1.0 + 3.0 * std::abs(turn) * (turn < 0.0 ? 1.5 : 1.0)));
    }
  }
  patch.triangles.resize(region.size());
  patch.join_corners();
  return patch;
}

/// Shortest ways from every point to the border.
struct Ways {
  std::vector<double> length;        ///< [points]
  std::vector<std::uint32_t> first;  ///< [points] the side that the way takes first; SurfaceSides::kNone on the border
};

Ways ways_to_border(const Patch& patch) {
  std::vector<std::vector<std::uint32_t>> around(patch.points);  // sides at a point, whichever end
  Ways ways{std::vector<double>(patch.points, std::numeric_limits<double>::infinity()),
            std::vector<std::uint32_t>(patch.points, SurfaceSides::kNone)};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto start_at = [&](std::uint32_t point) {
    if (ways.length[point] > 0.0) ways.length[point] = 0.0, queue.emplace(0.0, point);
  };
  for (std::uint32_t s = 0; s < patch.across.size(); ++s) {
    if (patch.across[s] == SurfaceSides::kNone) {
      start_at(patch.from(s)), start_at(patch.to(s));
    } else if (s < patch.across[s]) {
      around[patch.from(s)].push_back(s), around[patch.to(s)].push_back(s);
    }
  }
  while (!queue.empty()) {
    const auto [length, point] = queue.top();
    queue.pop();
    if (length > ways.length[point]) continue;
    for (const std::uint32_t s : around[point]) {
      const std::uint32_t next = patch.from(s) == point ? patch.to(s) : patch.from(s);
      const double there = length + patch.lengths[s];
      if (there < ways.length[next]) ways.length[next] = there, ways.first[next] = s, queue.emplace(there, next);
    }
  }
  return ways;
}

/// Opens the sides of a system of arcs: those that neither the ways nor a tree over the triangles needs, the shortest
/// loops first, with the ways from both their ends.
void cut(Patch& patch) {
  const Ways ways = ways_to_border(patch);
  std::vector<char> on_way(patch.across.size(), 0);
  for (const std::uint32_t s : ways.first) {
    if (s != SurfaceSides::kNone) on_way[s] = 1;
  }
  std::vector<std::pair<double, std::uint32_t>> rest;
  for (std::uint32_t s = 0; s < patch.across.size(); ++s) {
    if (patch.across[s] == SurfaceSides::kNone || s > patch.across[s] || on_way[s] != 0) continue;
    rest.emplace_back(-(ways.length[patch.from(s)] + patch.lengths[s] + ways.length[patch.to(s)]), s);
  }
  std::ranges::sort(rest);
  DisjointSets tree(patch.triangles.size());
  std::vector<std::uint32_t> opened;
  for (const auto& [length, s] : rest) {
    if (!tree.join(s / 3, patch.across[s] / 3)) opened.push_back(s);
  }
  std::vector<char> is_open(patch.across.size(), 0);
  for (const std::uint32_t s : opened) {
    is_open[s] = 1;
    for (std::uint32_t point : {patch.from(s), patch.to(s)}) {
      for (std::uint32_t way = ways.first[point]; way != SurfaceSides::kNone && is_open[way] == 0;
           way = ways.first[point]) {
        is_open[way] = 1;
        point = patch.from(way) == point ? patch.to(way) : patch.from(way);
      }
    }
  }
  for (std::uint32_t s = 0; s < is_open.size(); ++s) {
    if (is_open[s] != 0) patch.across[patch.across[s]] = SurfaceSides::kNone, patch.across[s] = SurfaceSides::kNone;
  }
  patch.join_corners();
}

/// The border in order, or nothing where it is not one loop through every point at most once.
std::vector<std::uint32_t> border_of(const Patch& patch) {
  std::vector<std::uint32_t> next(patch.points, SurfaceSides::kNone);
  std::uint32_t start = SurfaceSides::kNone;
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < patch.across.size(); ++s) {
    if (patch.across[s] != SurfaceSides::kNone) continue;
    if (next[patch.from(s)] != SurfaceSides::kNone) return {};
    next[patch.from(s)] = patch.to(s);
    start = start == SurfaceSides::kNone ? patch.from(s) : start;
    ++count;
  }
  std::vector<std::uint32_t> border;
  for (std::uint32_t at = start; at != SurfaceSides::kNone && border.size() < count; at = next[at]) {
    if (!border.empty() && at == start) break;
    border.push_back(at);
  }
  return border.size() == count ? border : std::vector<std::uint32_t>{};
}

}  // namespace

std::optional<Disc> disc_of(const WeldedMesh& surface, const SurfaceSides& sides, const Region& region) {
  Patch patch = patch_of(sides, region);
  if (!patch.has_border()) return std::nullopt;
  if (patch.characteristic() != 1) cut(patch);
  Disc disc;
  disc.border = border_of(patch);
  if (patch.characteristic() != 1 || disc.border.empty()) return std::nullopt;
  disc.points.resize(patch.points);
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      disc.points[patch.triangles[i][k]] = glm::dvec3(surface.positions[surface.triangles[region[i]][k]]);
    }
  }
  disc.triangles = std::move(patch.triangles);
  return disc;
}

}  // namespace luminist
