#include "prep/flat_chart.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <optional>
#include <queue>
#include <utility>

namespace luminist {
namespace {

/// What became of a region: a chart, or what its halves should go by.
struct Attempt {
  std::optional<FlatChart> chart;
  std::vector<glm::dvec2> features;
};

using Features = std::vector<std::complex<double>>;

std::vector<glm::dvec2> as_vectors(const Features& features) {
  std::vector<glm::dvec2> vectors;
  for (const std::complex<double>& feature : features) vectors.emplace_back(feature.real(), feature.imag());
  return vectors;
}

/// The triangles beside each one of a disc.
std::vector<std::vector<std::uint32_t>> beside_each(const Disc& disc) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first;
  std::vector<std::vector<std::uint32_t>> neighbours(disc.triangles.size());
  for (std::uint32_t f = 0; f < disc.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(disc.triangles[f][k], disc.triangles[f][(k + 1) % 3]);
      const auto [other, is_new] = first.try_emplace({a, b}, f);
      if (is_new) continue;
      neighbours[f].push_back(other->second), neighbours[other->second].push_back(f);
    }
  }
  return neighbours;
}

/// Angles (radians) of doubled directions, of which each lies beside its neighbours': a direction has two angles, and
/// the choice spreads where neighbours agree best, so that it breaks, if it must, where they do not.
std::vector<double> angles_of(const Disc& disc, const Features& features) {
  struct Step {
    double agreement;
    std::uint32_t from, to;
    bool operator<(const Step& other) const { return agreement < other.agreement; }
  };
  const auto neighbours = beside_each(disc);
  std::vector<std::optional<double>> angles(features.size());
  const auto start = std::ranges::max_element(features, {}, [](const auto& z) { return z.real(); });
  std::priority_queue<Step> steps;
  const auto visit = [&](std::uint32_t f, double angle) {
    angles[f] = angle;
    for (const std::uint32_t next : neighbours[f]) {
      steps.push({(features[f] * std::conj(features[next])).real(), f, next});
    }
  };
  visit(static_cast<std::uint32_t>(start - features.begin()), 0.5 * std::arg(*start));
  while (!steps.empty()) {
    const Step step = steps.top();
    steps.pop();
    if (angles[step.to]) continue;
    const std::complex<double>& feature = features[step.to];
    double angle = *angles[step.from];
    if (feature != 0.0) {
      const double own = 0.5 * std::arg(feature);
      angle = own + kPi * std::round((angle - own) / kPi);
    }
    visit(step.to, angle);
  }
  std::vector<double> result;
  for (const std::optional<double>& angle : angles) result.push_back(angle.value_or(0.0));
  return result;
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
    turn_to_strokes(chart);
    align(chart);
    const Features features = features_of(chart);
    const double piece = sides_->piece_areas[sides_->piece[region.front()]];
    const bool is_small = region.size() < 2 || chart.area < limits_.smallest * piece;
    if (may_divide_for_strokes && !is_small && chart.coherence < limits_.coherence) return {{}, as_vectors(features)};
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

  /// The field's directions on the chart, doubled, their length the confidence.
  [[nodiscard]] Features features_of(const FlatChart& chart) const {
    Features features;
    for (std::size_t i = 0; i < chart.region.size(); ++i) {
      const glm::dvec3 direction = direction_on(*field_, *surface_, *sides_, chart.region[i]);
      const double confidence = glm::length(direction);
      const std::complex<double> flat = in_plane(chart, i, direction);
      const double length = std::abs(flat);
      features.push_back(length > 0.0 ? confidence * flat * flat / (length * length) : std::complex<double>(0.0));
    }
    return features;
  }

  /// Turns the chart so that the mean direction is +x, and says how much directions agree.
  void turn_to_strokes(FlatChart& chart) const {
    const Features features = features_of(chart);
    std::complex<double> sum = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < features.size(); ++i) {
      sum += sides_->areas[chart.region[i]] * features[i];
      most += sides_->areas[chart.region[i]] * std::abs(features[i]);
    }
    chart.coherence = most > 0.0 ? std::min(std::abs(sum) / most, 1.0) : 1.0;
    const double angle = -0.5 * std::arg(sum);
    const glm::dvec2 turn(std::cos(angle), std::sin(angle));
    for (glm::dvec2& p : chart.places) p = {p.x * turn.x - p.y * turn.y, p.x * turn.y + p.y * turn.x};
  }

  /// Turns its triangles to the strokes one by one, as far as that leaves the chart whole.
  void align(FlatChart& chart) const {
    constexpr double kParallel = 0.97;  // directions are off by ten degrees
    if (chart.coherence > kParallel) return;
    const std::vector<double> angles = angles_of(chart.disc, features_of(chart));
    for (const double share : {1.0, 0.5}) {
      std::vector<double> turns;
      for (const double angle : angles) turns.push_back(-share * angle);
      auto places = with_triangles_turned(chart.disc, chart.places, turns);
      if (!places) return;
      FlatChart aligned;
      aligned.region = chart.region, aligned.disc = chart.disc, aligned.area = chart.area;
      if (take(aligned, *std::move(places), ChartMethod::kAligned) == Fate::kTorn) continue;
      turn_to_strokes(aligned);
      if (aligned.coherence <= chart.coherence || !is_even(aligned.distortion, chart.distortion)) continue;
      chart = std::move(aligned);
      return;
    }
  }

  /// Whether lengths changed little enough by an alignment. Mending may leave slivers, on which strokes would streak.
  [[nodiscard]] bool is_even(const Distortion& aligned, const Distortion& before) const {
    constexpr double kWorst = 8.0;
    return aligned.stretch <= limits_.aligned_stretch && aligned.worst_area <= std::max(kWorst, before.worst_area) &&
           aligned.worst_angle <= std::max(kWorst, before.worst_angle);
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
