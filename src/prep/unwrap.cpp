#include "prep/unwrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "prep/chart_packing.h"
#include "prep/flat_chart.h"

namespace luminist {
namespace {

/// In [0,1), the same on every machine (splitmix64, Steele et al. 2014).
double random_of(std::uint64_t seed) {
  seed = (seed + 1) * 0x9e3779b97f4a7c15ULL;
  seed = (seed ^ (seed >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  seed = (seed ^ (seed >> 27U)) * 0x94d049bb133111ebULL;
  return static_cast<double>((seed ^ (seed >> 31U)) >> 11U) * 0x1p-53;
}

/// Two points of one place, one for each set of the mesh's attributes there.
using Vertices = std::unordered_map<std::uint64_t, std::uint32_t>;

class Assembly {
 public:
  Assembly(const Mesh& mesh, const WeldedMesh& surface) : mesh_(&mesh), surface_(&surface) {
    result_.mesh.triangles.resize(surface.triangles.size());
    result_.chart_of_triangle.resize(surface.triangles.size());
  }

  /// offset: of the chart's lower left corner; packing places chart `number`.
  void add(const FlatChart& flat, std::size_t number, const glm::dvec2& offset, const ChartPacking& packing) {
    glm::dvec2 lo(std::numeric_limits<double>::infinity());
    for (const glm::dvec2& p : flat.places) lo = glm::min(lo, p);
    Vertices vertices;
    for (std::size_t i = 0; i < flat.region.size(); ++i) {
      const std::uint32_t f = flat.region[i];
      result_.chart_of_triangle[f] = static_cast<std::uint32_t>(number);
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t point = flat.disc.triangles[i][k];
        const std::uint32_t vertex = surface_->corners[f][k];
        const auto next = static_cast<std::uint32_t>(result_.mesh.positions.size());
        const auto [entry, is_new] = vertices.try_emplace(std::uint64_t{point} << 32U | vertex, next);
        if (is_new) add_vertex(vertex, flat.places[point] - lo + offset, packing.place(number, flat.places[point]));
        result_.mesh.triangles[f][k] = entry->second;
      }
    }
    Chart chart{flat.region, flat.method, flat.distortion, flat.area, flat.coherence};
    chart.distortion = as_stored(flat);
    result_.charts.push_back(std::move(chart));
  }

  Unwrapped take() && { return std::move(result_); }

 private:
  void add_vertex(std::uint32_t vertex, const glm::dvec2& strokes, const glm::dvec2& atlas) {
    result_.mesh.append_vertex(*mesh_, vertex);
    result_.strokes.emplace_back(strokes);
    result_.atlas.emplace_back(atlas);
  }

  /// The chart's distortion with the places that were stored.
  [[nodiscard]] Distortion as_stored(const FlatChart& flat) const {
    std::vector<glm::dvec2> places(flat.places.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < flat.region.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 at(result_.strokes[result_.mesh.triangles[flat.region[i]][k]]);
        places[flat.disc.triangles[i][k]] = at;
        largest = std::max({largest, at.x, at.y});
      }
    }
    return distortion_of(flat.disc, places, largest * std::numeric_limits<float>::epsilon());
  }

  const Mesh* mesh_;
  const WeldedMesh* surface_;
  Unwrapped result_;
};

UnwrapTotals totals_of(const std::vector<Chart>& charts) {
  UnwrapTotals totals;
  double all = 0.0, area = 0.0, angle = 0.0, stretch = 0.0, coherence = 0.0;
  for (const Chart& chart : charts) {
    const Distortion& d = chart.distortion;
    totals.flipped += d.flipped;
    totals.worst_area = std::max(totals.worst_area, d.worst_area);
    totals.worst_angle = std::max(totals.worst_angle, d.worst_angle);
    all += chart.area, area += chart.area * std::log(d.area), angle += chart.area * d.angle;
    stretch += chart.area * d.stretch * d.stretch, coherence += chart.area * chart.coherence;
  }
  if (!(all > 0.0)) return totals;
  totals.area = std::exp(area / all), totals.angle = angle / all;
  totals.stretch = std::sqrt(stretch / all), totals.coherence = coherence / all;
  return totals;
}

double border_length(const FlatChart& flat) {
  double sum = 0.0;
  const auto& border = flat.disc.border;
  for (std::size_t i = 0; i < border.size(); ++i) {
    sum += glm::length(flat.disc.points[border[(i + 1) % border.size()]] - flat.disc.points[border[i]]);
  }
  return sum;
}

}  // namespace

Unwrapped unwrap(const Mesh& mesh, const UnwrapOptions& options) {
  const WeldedMesh surface = repair(mesh).surface;
  if (surface.triangles.empty()) return {};
  const SurfaceSides sides = sides_of(surface);
  const StrokeField field = stroke_field(surface, sides);
  constexpr double kBumps = 0.015;  // of a surface's size
  const SurfaceSides smooth = smoothed(sides, kBumps);
  const std::vector<FlatChart> flats =
      flatten(surface, sides, smooth, field, charts_of(smooth, options.charts), {.stretch = options.stretch});
  std::vector<std::vector<glm::dvec2>> borders;
  std::vector<double> areas;
  double total = 0.0, seams = 0.0;
  for (const FlatChart& flat : flats) {
    borders.emplace_back();
    for (const std::uint32_t point : flat.disc.border) borders.back().push_back(flat.places[point]);
    areas.push_back(flat.area), total += flat.area, seams += border_length(flat);
  }
  const ChartPacking packing = pack(borders, areas);
  Assembly assembly(mesh, surface);
  for (std::size_t i = 0; i < flats.size(); ++i) {
    const glm::dvec2 random(random_of(options.seed * 0x10001U + 2 * i), random_of(options.seed * 0x10001U + 2 * i + 1));
    assembly.add(flats[i], i, std::sqrt(total) * random, packing);
  }
  Unwrapped result = std::move(assembly).take();
  result.totals = totals_of(result.charts);
  result.totals.utilization = packing.utilization;
  result.totals.seams = total > 0.0 ? seams / std::sqrt(total) : 0.0;
  return result;
}

}  // namespace luminist
