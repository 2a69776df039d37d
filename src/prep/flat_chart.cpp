#include "prep/flat_chart.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace luminist {
namespace {

/// What became of a region: a chart, or what its halves should go by.
struct Attempt {
  std::optional<FlatChart> chart;
  std::vector<glm::dvec2> features;
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

class Flattener {
 public:
  Flattener(const WeldedMesh& surface, const SurfaceSides& sides, const StrokeField& field,
            const FlatteningLimits& limits)
      : surface_(&surface), sides_(&sides), field_(&field), limits_(limits) {}

  [[nodiscard]] Attempt attempt(const Region& region, bool may_divide_for_strokes) const {
    auto disc = disc_of(*surface_, *sides_, region);
    if (!disc) return {};
    FlatChart chart;
    chart.region = region, chart.disc = *std::move(disc);
    for (const std::uint32_t f : region) chart.area += sides_->areas[f];
    if (!lay(chart)) return {};
    std::vector<glm::dvec2> features = turn_to_strokes(chart);
    const double piece = sides_->piece_areas[sides_->piece[region.front()]];
    const bool is_small = region.size() < 2 || chart.area < limits_.smallest * piece;
    if (may_divide_for_strokes && !is_small && chart.coherence < limits_.coherence) return {{}, std::move(features)};
    return {std::move(chart), {}};
  }

 private:
  enum class Fate { kGood, kStretched, kTorn };

  /// Fills places, method and distortion. false where no method does well.
  bool lay(FlatChart& chart) const {
    // A large chart that tears is seldom good on a circle, and its halves are cheaper to try.
    constexpr std::size_t kMostOnCircle = 1000;
    if (chart.disc.triangles.size() == 1) return place(chart, ChartMethod::kRigid) != Fate::kTorn;
    for (const ChartMethod method : {ChartMethod::kLscm, ChartMethod::kMeanValue, ChartMethod::kTutte}) {
      if (method != ChartMethod::kLscm && chart.region.size() > kMostOnCircle) return false;
      if (place(chart, method) != Fate::kTorn) return relax(chart) == Fate::kGood;
    }
    return false;
  }

  Fate place(FlatChart& chart, ChartMethod method) const {
    auto places = map_disc(chart.disc, method);
    return places ? take(chart, *std::move(places), method) : Fate::kTorn;
  }

  /// Lengths kept better, where that leaves the chart whole.
  Fate relax(FlatChart& chart) const {
    constexpr double kGoodAlready = 1.003;  // lengths are off by a few percent
    if (chart.distortion.stretch > kGoodAlready) {
      auto places = as_rigid_as_possible(chart.disc, chart.places);
      FlatChart relaxed;
      relaxed.disc = std::move(chart.disc), relaxed.area = chart.area;
      const bool is_better = places && take(relaxed, *std::move(places), ChartMethod::kArap) != Fate::kTorn &&
                             relaxed.distortion.stretch < chart.distortion.stretch;
      chart.disc = std::move(relaxed.disc);
      if (is_better) {
        chart.places = std::move(relaxed.places);
        chart.method = relaxed.method, chart.distortion = relaxed.distortion;
      }
    }
    return chart.distortion.stretch <= limits_.stretch ? Fate::kGood : Fate::kStretched;
  }

  /// Scales the places to the area of the surface and judges them.
  Fate take(FlatChart& chart, std::vector<glm::dvec2> places, ChartMethod method) const {
    double area = 0.0;
    for (const auto& [a, b, c] : chart.disc.triangles) {
      area += 0.5 * cross(places[b] - places[a], places[c] - places[a]);
    }
    if (!(std::abs(area) > 0.0)) return Fate::kTorn;
    const double scale = std::sqrt(chart.area / std::abs(area));
    // Solutions may come as mirror images.
    for (glm::dvec2& p : places) p *= glm::dvec2(scale, area < 0.0 ? -scale : scale);
    if (!mend(chart.disc, places)) return Fate::kTorn;
    chart.places = std::move(places), chart.method = method;
    chart.distortion = distortion_of(chart.disc, chart.places);
    return Fate::kGood;
  }

  /// Turns the chart and returns the field's directions on it, doubled, by their confidence, before the turn.
  std::vector<glm::dvec2> turn_to_strokes(FlatChart& chart) const {
    std::vector<glm::dvec2> features;
    std::complex<double> sum = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < chart.region.size(); ++i) {
      const std::uint32_t f = chart.region[i];
      const glm::dvec3 direction = direction_on(*field_, *surface_, *sides_, f);
      const double confidence = glm::length(direction);
      std::complex<double> flat = in_plane(chart, i, direction);
      const double length = std::abs(flat);
      flat = length > 0.0 ? confidence * flat * flat / (length * length) : std::complex<double>(0.0);
      features.emplace_back(flat.real(), flat.imag());
      sum += sides_->areas[f] * flat, most += sides_->areas[f] * std::abs(flat);
    }
    chart.coherence = most > 0.0 ? std::min(std::abs(sum) / most, 1.0) : 1.0;
    const double angle = -0.5 * std::arg(sum);
    const glm::dvec2 turn(std::cos(angle), std::sin(angle));
    for (glm::dvec2& p : chart.places) p = {p.x * turn.x - p.y * turn.y, p.x * turn.y + p.y * turn.x};
    return features;
  }

  /// A tangent vector of a triangle as the map carries it.
  static std::complex<double> in_plane(const FlatChart& chart, std::size_t i, const glm::dvec3& tangent) {
    const auto& [a, b, c] = chart.disc.triangles[i];
    const glm::dvec3 e = chart.disc.points[b] - chart.disc.points[a];
    const glm::dvec3 f = chart.disc.points[c] - chart.disc.points[a];
    // tangent = x e + y f, by their products with e and f.
    const double ee = glm::dot(e, e), ef = glm::dot(e, f), ff = glm::dot(f, f);
    const double et = glm::dot(e, tangent), ft = glm::dot(f, tangent);
    const double determinant = ee * ff - ef * ef;
    if (!(determinant > 0.0)) return 0.0;
    const double x = (et * ff - ft * ef) / determinant;
    const double y = (ft * ee - et * ef) / determinant;
    const glm::dvec2 flat = x * (chart.places[b] - chart.places[a]) + y * (chart.places[c] - chart.places[a]);
    return {flat.x, flat.y};
  }

  const WeldedMesh* surface_;
  const SurfaceSides* sides_;
  const StrokeField* field_;
  FlatteningLimits limits_;
};

}  // namespace

std::vector<FlatChart> flatten(const WeldedMesh& surface, const SurfaceSides& sides, const SurfaceSides& smooth,
                               const StrokeField& field, std::vector<Region> regions, const FlatteningLimits& limits) {
  const Flattener flattener(surface, sides, field, limits);
  std::vector<FlatChart> charts;
  // How often strokes may still divide a region: those that disagree in parts of parts are noise.
  std::vector<int> may_divide(regions.size(), 2);
  while (!regions.empty()) {
    std::vector<Attempt> attempts(regions.size());
    std::vector<std::array<Region, 2>> halves(regions.size());
    tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t i) {
      attempts[i] = flattener.attempt(regions[i], may_divide[i] > 0);
      if (!attempts[i].chart) halves[i] = halves_of(smooth, regions[i], attempts[i].features);
    });
    std::vector<Region> rest;
    std::vector<int> rest_may_divide;
    for (std::size_t i = 0; i < regions.size(); ++i) {
      if (attempts[i].chart) {
        charts.push_back(*std::move(attempts[i].chart));
        continue;
      }
      for (Region& half : halves[i]) {
        rest.push_back(std::move(half));
        rest_may_divide.push_back(may_divide[i] - (attempts[i].features.empty() ? 0 : 1));
      }
    }
    regions = std::move(rest), may_divide = std::move(rest_may_divide);
  }
  std::ranges::sort(charts, {}, [](const FlatChart& chart) { return chart.region.front(); });
  return charts;
}

}  // namespace luminist
