#include "bench/perturbation.h"

#include <algorithm>
#include <limits>

#include "bench/bench_scene.h"
#include "solve/objective.h"

namespace luminist {
namespace {

constexpr double kWork = 0.5;                     // of what taking a light away changes
constexpr double kPerturbationStep = 1.0 / 64.0;  // of the way to the end of [0,1]
constexpr int kBisections = 4;

/// How far x[dof] can go towards `end` before epsilon exceeds `limit`: doubled steps, then bisection.
Result<double> last_useful(Objective& objective, std::vector<double> x, std::size_t dof, double end, double limit) {
  const double home = x[dof];
  const auto useful = [&](double share) -> Result<bool> {
    x[dof] = home + share * (end - home);
    LUM_TRY(const double epsilon, objective.evaluate(x));
    return epsilon <= limit;
  };
  double good = 0.0;
  double bad = kPerturbationStep;
  for (; bad <= 1.0; bad *= 2.0) {
    LUM_TRY(const bool still, useful(bad));
    if (!still) break;
    good = bad;
  }
  if (good == 1.0) return end;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (good + bad);
    LUM_TRY(const bool still, useful(middle));
    (still ? good : bad) = middle;
  }
  return home + good * (end - home);
}

/// What turning a number of each light may change; infinite where the light would not be missed, so that all of its
/// ranges are useful.
Result<std::vector<double>> limits(Renderer& renderer, const ParamState& original, const Target& target) {
  std::vector<double> result;
  for (std::size_t i = 0; i < original.rig.lights.size(); ++i) {
    ParamState without = original;
    without.rig.lights[i].muted = true;
    LUM_TRY(const double loss, renderer.error(without, target));
    result.push_back(loss > 0.0 ? kWork * loss : std::numeric_limits<double>::infinity());
  }
  return result;
}

}  // namespace

void unlock_roles(Light& light, std::span<const std::string_view> roles) {
  const ParamSchema& schema = light.params.schema();
  for (int param = 0; param < schema.size(); ++param) {
    const bool named = std::find(roles.begin(), roles.end(), schema[param].role) != roles.end();
    if (named && !schema[param].quality) light.params.set_param_locked(param, false);
  }
}

Result<std::vector<UnitRange>> useful_ranges(Renderer& renderer, const ParamState& original) {
  LUM_TRY(const Image picture, renderer.render(original));
  const Target target = whole_picture(picture, picture);
  LUM_TRY(const std::vector<double> limit, limits(renderer, original, target));
  Objective objective(renderer, original, target);
  const std::vector<double> home = objective.unit(original);
  std::vector<UnitRange> ranges(home.size());
  for (std::size_t k = 0; k < home.size(); ++k) {
    const int light = objective.map().list()[k].block - light_block(0);
    if (light < 0 || light >= static_cast<int>(limit.size())) continue;
    const double most = limit[static_cast<std::size_t>(light)];
    LUM_TRY(ranges[k].low, last_useful(objective, home, k, std::min(0.0, home[k]), most));
    LUM_TRY(ranges[k].high, last_useful(objective, home, k, std::max(1.0, home[k]), most));
  }
  return ranges;
}

ParamState perturbed(const ParamState& original, const SceneFrame& frame, std::span<const UnitRange> ranges,
                     const PerturbReach& reach, Random& random) {
  ParamState result = original;
  const std::vector<const ParamBlock*> readable = original.blocks();
  const UnitMap map = UnitMap::create(readable, frame);
  std::vector<double> x = map.to_unit(readable);
  LUM_CHECK(ranges.size() == x.size(), "one range for each degree of freedom");
  for (std::size_t k = 0; k < x.size(); ++k) {
    const UnitRange& range = ranges[k];
    const double step = (range.high - range.low) * random.uniform(reach.least, reach.most);
    const bool up = random.uniform() < 0.5;
    const bool fits = up ? x[k] + step <= range.high : x[k] - step >= range.low;
    x[k] += up == fits ? step : -step;
  }
  const std::vector<ParamBlock*> writable = result.blocks();
  map.from_unit(x, writable);
  return result;
}

}  // namespace luminist
