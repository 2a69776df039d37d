#include "verdict/quick_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "solve/box_solve.h"

namespace luminist {
namespace {

constexpr Softness kSoft{0.03F, 0.04F, 0.1F, 2};
constexpr Softness kSharp{0.0F, 0.0F, 0.0F, 4};
constexpr std::array<double, 4> kDampings{1e-3, 1e-2, 1e-1, 1.0};  // tried at once
constexpr double kLargestStep = 0.4;                               // in any unit coordinate
constexpr std::size_t kDescents = 4;                               // of a search

UnitMap map_of(const ParamState& state, const SceneFrame& frame) {
  return UnitMap::create(state.blocks(), frame);
}

std::vector<double> unit_of(const UnitMap& map, const ParamState& state) {
  std::vector<double> x = map.to_unit(state.blocks());
  for (double& coordinate : x) coordinate = std::clamp(coordinate, 0.0, 1.0);
  return x;
}

ParamState state_at(const UnitMap& map, std::span<const double> x, const ParamState& base) {
  ParamState state = base;
  map.from_unit(x, state.blocks());
  keep_constraints(state.rig);
  return state;
}

/// The light that alone changes with a degree of freedom, or all.
int part_of(const Renderer& renderer, const ParamState& state, const Dof& dof) {
  const int light = dof.block - light_block(0);
  const bool of_light = light >= 0 && light < static_cast<int>(state.rig.lights.size());
  const bool shared = of_light && state.rig.shadow_light == state.rig.lights[static_cast<std::size_t>(light)].name;
  const bool sum = renderer.style().combination(state.style) == LightCombination::kSum;
  const bool tied = of_light && tied_to(state.rig, static_cast<std::size_t>(light), dof.param).size() > 1;
  return of_light && sum && !shared && !tied ? light : Candidate::kAllLights;
}

bool is_position(const ParamState& state, const Dof& dof) {
  return state.blocks()[static_cast<std::size_t>(dof.block)]->schema()[dof.param].role == "position";
}

/// A block's colour, if all of it is free.
std::optional<int> free_color(const ParamState& state, int block) {
  const ParamBlock& params = *state.blocks()[static_cast<std::size_t>(block)];
  const std::optional<int> color = params.schema().by_role("color");
  if (!color || params.schema()[*color].type != ParamType::kColor) return std::nullopt;
  for (int c = 0; c < 3; ++c) {
    if (params.locked(params.schema()[*color].first_dof + c)) return std::nullopt;
  }
  return color;
}

/// How many times as strong the colour fits best, by least squares, within its range.
Vec3 color_factor(const ParamBlock& block, int color, std::span<const Vec3> with, std::span<const Vec3> without,
                  const SampledWish& wish, const SceneFrame& frame) {
  Vec3 factor(1.0F);
  for (int c = 0; c < 3; ++c) {
    double above = 0.0;
    double below = 0.0;
    for (std::size_t i = 0; i < with.size(); ++i) {
      const double part = static_cast<double>(with[i][c]) - without[i][c];
      above += wish.weight[i] * part * (static_cast<double>(wish.target[i][c]) - without[i][c]);
      below += wish.weight[i] * part * part;
    }
    const double now = block.get(color, c);
    if (!(below > 0.0) || !(now > 0.0)) continue;
    const auto [low, high] = block.range(color, c, frame);
    const double least = std::max(0.0, low / now);
    factor[c] = static_cast<float>(std::clamp(above / below, least, std::max(least, high / now)));
  }
  return factor;
}

}  // namespace

/// One state on its way.
struct QuickSearch::Descent {
  explicit Descent(ParamState start) : state(std::move(start)) {}

  ParamState state;
  double error = 0.0;  // at the present softness
  bool stuck = false;

  // of an iteration
  UnitMap map;
  std::vector<double> x;
  std::vector<double> step;  // of the differences
  std::vector<ParamState> stepped;
  std::vector<int> part;  // [dofs]
  std::size_t first = 0;  // of its candidates in the batch

  std::vector<double> a;  // normal equations
  std::vector<double> b;

  void plan(const Renderer& renderer, double position_step) {
    map = map_of(state, renderer.frame());
    x = unit_of(map, state);
    step.clear(), stepped.clear(), part.clear();
    for (std::size_t k = 0; k < x.size(); ++k) {
      const Dof& dof = map.list()[k];
      const double length = is_position(state, dof) ? position_step : 0.01;
      step.push_back(x[k] + length <= 1.0 ? length : -length);
      std::vector<double> moved = x;
      moved[k] += step.back();
      stepped.push_back(state_at(map, moved, state));
      part.push_back(part_of(renderer, state, dof));
    }
  }

  /// Its own picture, then for each degree of freedom what it changes, before and after.
  void ask(std::vector<Candidate>& batch) {
    first = batch.size();
    batch.push_back({&state, Candidate::kAllLights});
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (part[k] != Candidate::kAllLights && (k == 0 || part[k - 1] != part[k])) batch.push_back({&state, part[k]});
      batch.push_back({&stepped[k], part[k]});
    }
  }

  void hear(std::span<const std::vector<Vec3>> colors, const SampledWish& wish) {
    std::size_t at = first;
    const std::vector<Vec3>& picture = colors[at++];
    error = wish.error(picture);
    std::vector<std::vector<Vec3>> slope(x.size());
    const std::vector<Vec3>* before = &picture;
    for (std::size_t k = 0; k < x.size(); ++k) {
      if (part[k] == Candidate::kAllLights) before = &picture;
      if (part[k] != Candidate::kAllLights && (k == 0 || part[k - 1] != part[k])) before = &colors[at++];
      slope[k] = colors[at++];
      for (std::size_t i = 0; i < picture.size(); ++i) {
        slope[k][i] = (slope[k][i] - (*before)[i]) / static_cast<float>(step[k]);
      }
    }
    equations(picture, slope, wish);
  }

  void equations(const std::vector<Vec3>& picture, const std::vector<std::vector<Vec3>>& slope,
                 const SampledWish& wish) {
    const std::size_t n = x.size();
    a.assign(n * n, 0.0);
    b.assign(n, 0.0);
    const double floor = 0.02 * error + 1e-9;
    for (std::size_t i = 0; i < picture.size(); ++i) {
      const Vec3 r = wish.target[i] - picture[i];
      const double weight = wish.weight[i] / (glm::length(r) + floor);
      for (std::size_t k = 0; k < n; ++k) {
        b[k] += weight * glm::dot(slope[k][i], r);
        for (std::size_t j = 0; j <= k; ++j) a[k * n + j] += weight * glm::dot(slope[k][i], slope[j][i]);
      }
    }
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t j = 0; j < k; ++j) a[j * n + k] = a[k * n + j];
    }
  }

  [[nodiscard]] ParamState trial(double damping) const {
    const std::size_t n = x.size();
    std::vector<double> damped = a;
    std::vector<double> low(n);
    std::vector<double> high(n);
    std::vector<double> move(n, 0.0);
    double largest = 0.0;
    for (std::size_t k = 0; k < n; ++k) largest = std::max(largest, a[k * n + k]);
    for (std::size_t k = 0; k < n; ++k) {
      damped[k * n + k] += damping * (a[k * n + k] + 1e-3 * largest);
      low[k] = std::max(-x[k], -kLargestStep);
      high[k] = std::min(1.0 - x[k], kLargestStep);
    }
    solve_box(damped, b, low, high, move);
    for (std::size_t k = 0; k < n; ++k) move[k] += x[k];
    return state_at(map, move, state);
  }
};

Result<std::vector<std::vector<Vec3>>> QuickSearch::colors(std::span<const Candidate> candidates,
                                                           const SampledWish& wish, const Softness& softness) {
  const std::size_t count = wish.samples.pixels.size();
  std::vector<Vec3> flat(candidates.size() * count);
  LUM_TRY_VOID(renderer_->evaluate(candidates, wish.samples, softness, flat));
  std::vector<std::vector<Vec3>> result;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const auto begin = flat.begin() + static_cast<std::ptrdiff_t>(k * count);
    result.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count));
  }
  return result;
}

Result<std::vector<double>> QuickSearch::measure(std::span<const ParamState> states, const SampledWish& wish) {
  std::vector<Candidate> batch;
  for (const ParamState& state : states) batch.push_back({&state, Candidate::kAllLights});
  LUM_TRY(const auto pictures, colors(batch, wish, kSharp));
  std::vector<double> errors;
  for (const auto& picture : pictures) errors.push_back(wish.error(picture));
  return errors;
}

Result<std::vector<double>> QuickSearch::settle_colors(std::vector<ParamState>& variants, std::span<const int> blocks,
                                                       const SampledWish& wish) {
  std::vector<ParamState> dark;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    dark.push_back(variants[k]);
    const std::optional<int> color = free_color(variants[k], blocks[k]);
    if (color) dark.back().blocks()[static_cast<std::size_t>(blocks[k])]->set_vec3(*color, Vec3(0.0F));
    keep_constraints(dark.back().rig);  // what has that colour is dark too
  }
  std::vector<Candidate> batch;
  for (const ParamState& state : variants) batch.push_back({&state, Candidate::kAllLights});
  for (const ParamState& state : dark) batch.push_back({&state, Candidate::kAllLights});
  LUM_TRY(const auto pictures, colors(batch, wish, kSharp));
  std::vector<double> errors;
  for (std::size_t k = 0; k < variants.size(); ++k) {
    const std::vector<Vec3>& without = pictures[variants.size() + k];
    std::vector<Vec3> picture = pictures[k];
    if (const std::optional<int> color = free_color(variants[k], blocks[k])) {
      ParamBlock& block = *variants[k].blocks()[static_cast<std::size_t>(blocks[k])];
      const Vec3 factor = color_factor(block, *color, picture, without, wish, renderer_->frame());
      block.set_vec3(*color, factor * block.vec3(*color));
      keep_constraints(variants[k].rig);
      for (std::size_t i = 0; i < picture.size(); ++i) picture[i] = without[i] + factor * (picture[i] - without[i]);
    }
    errors.push_back(wish.error(picture));
  }
  return errors;
}

Result<void> QuickSearch::iterate(std::vector<Descent>& descents, const SampledWish& wish, const Softness& softness,
                                  double position_step) {
  std::vector<Candidate> batch;
  for (Descent& descent : descents) {
    if (descent.stuck) continue;
    descent.plan(*renderer_, position_step);
    descent.ask(batch);
  }
  if (batch.empty()) return {};
  LUM_TRY(const auto slopes, colors(batch, wish, softness));
  std::vector<ParamState> trials;
  for (Descent& descent : descents) {
    if (descent.stuck) continue;
    descent.hear(slopes, wish);
    for (const double damping : kDampings) trials.push_back(descent.trial(damping));
  }
  batch.clear();
  for (const ParamState& trial : trials) batch.push_back({&trial, Candidate::kAllLights});
  LUM_TRY(const auto pictures, colors(batch, wish, softness));
  std::size_t at = 0;
  for (Descent& descent : descents) {
    if (descent.stuck) continue;
    const double before = descent.error;
    for (std::size_t k = 0; k < kDampings.size(); ++k, ++at) {
      const double error = wish.error(pictures[at]);
      if (error < descent.error) descent.error = error, descent.state = trials[at];
    }
    descent.stuck = descent.error > 0.995 * before;
  }
  return {};
}

Result<std::vector<Reached>> QuickSearch::descend(std::vector<ParamState> starts, const SampledWish& wish, int soft,
                                                  int sharp) {
  LUM_TRY(const std::vector<double> start_errors, measure(starts, wish));
  std::vector<Descent> descents;
  for (const ParamState& start : starts) descents.emplace_back(start);
  for (int i = 0; i < soft; ++i) LUM_TRY_VOID(iterate(descents, wish, kSoft, 0.008));
  for (Descent& descent : descents) descent.stuck = false;
  for (int i = 0; i < sharp; ++i) LUM_TRY_VOID(iterate(descents, wish, kSharp, 0.004));
  std::vector<ParamState> ends;
  for (Descent& descent : descents) ends.push_back(std::move(descent.state));
  LUM_TRY(const std::vector<double> errors, measure(ends, wish));
  std::vector<Reached> result;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const bool better = errors[k] < start_errors[k];
    result.push_back({std::move(better ? ends[k] : starts[k]), std::min(errors[k], start_errors[k])});
  }
  return result;
}

Result<Reached> QuickSearch::search(std::vector<ParamState> starts, const SampledWish& wish, int variants,
                                    double enough) {
  LUM_CHECK(!starts.empty(), "a search starts somewhere");
  const auto nearer = [](const Reached& a, const Reached& b) { return a.error < b.error; };
  Random random(wish.samples.id);
  const WishPlaces places = wish_places(wish, renderer_->surface());
  LUM_TRY(std::vector<Reached> ends, descend(starts, wish, 3, 2));
  Reached best = *std::min_element(ends.begin(), ends.end(), nearer);
  if (best.error <= enough) return best;
  std::vector<ParamState> pool;
  std::vector<int> blocks;
  const ParamState& first = best.state;
  const int count = static_cast<int>(first.blocks().size());
  for (int block = 0; block < count; ++block) {
    for (ParamState& variant : block_variants(first, block, places, renderer_->frame(), variants, random)) {
      pool.push_back(std::move(variant));
      blocks.push_back(block);
    }
  }
  if (pool.empty()) return best;
  LUM_TRY(const std::vector<double> errors, settle_colors(pool, blocks, wish));
  std::vector<std::size_t> order(pool.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return errors[a] < errors[b]; });
  order.resize(std::min(order.size(), kDescents));
  std::vector<ParamState> chosen = {best.state};
  for (const std::size_t k : order) chosen.push_back(std::move(pool[k]));
  LUM_TRY(ends, descend(std::move(chosen), wish, 5, 5));
  ends.push_back(std::move(best));
  return *std::min_element(ends.begin(), ends.end(), nearer);
}

}  // namespace luminist
