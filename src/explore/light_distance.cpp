#include "explore/light_distance.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "explore/assignment.h"
#include "explore/locks.h"

namespace luminist {
namespace {

constexpr int kCells = 256;
constexpr int kShadowRays = 2;
constexpr double kNever = 1e9;  // cost of a pair of lights of two types

double distance(const SampleCells& cells, const CellField& a, const CellField& b) {
  double sum = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += cells.weight[c] * glm::distance(a[c], b[c]);
  return sum;
}

}  // namespace

std::vector<std::size_t> light_pairs(const LightRig& a, const LightRig& b, const SceneFrame& frame, const Vec3& focus) {
  LUM_CHECK(a.lights.size() == b.lights.size(), "both rigs have the same lights");
  std::vector<std::size_t> pairs(a.lights.size());
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i] = i;
    if (is_free(a.lights[i])) free.push_back(i);
  }
  std::vector<double> costs;
  for (const std::size_t i : free) {
    for (const std::size_t j : free) {
      const bool alike = a.lights[i].type == b.lights[j].type;
      const double length = alike ? walk_length(light_walk(a.lights[i], b.lights[j], frame, focus)) : 0.0;
      costs.push_back(alike ? length * length : kNever);
    }
  }
  const std::vector<int> chosen = least_cost_assignment(costs, static_cast<int>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) pairs[free[k]] = free[static_cast<std::size_t>(chosen[k])];
  return pairs;
}

LightDistance::LightDistance(Renderer& renderer, const Target& target)
    : renderer_(&renderer), cells_(CellSampler(renderer.surface(), target).cut(kCells, 1, 1)) {
  double sum = 0.0;
  for (std::size_t c = 0; c < cells_.position.size(); ++c) {
    focus_ += static_cast<float>(cells_.weight[c]) * cells_.position[c];
    sum += cells_.weight[c];
  }
  focus_ = sum > 0.0 ? focus_ / static_cast<float>(sum) : renderer.frame().center;
}

/// The light's part of the picture, step by step.
Result<LightDistance::Pair> LightDistance::walk(const ParamState& from, std::size_t light, const Light& to) {
  const std::vector<WalkStep> steps = light_walk(from.rig.lights[light], to, renderer_->frame(), focus_);
  const bool alone = renderer_->style().lights == LightCombination::kSum;
  std::vector<ParamState> states(steps.size() + 2, from);
  states.back().rig.lights[light].muted = true;
  for (std::size_t k = 0; k < steps.size(); ++k) states[k + 1].rig.lights[light].params = steps[k].light.params;
  std::vector<Candidate> candidates;
  for (const ParamState& state : states) {
    candidates.push_back({&state, alone ? static_cast<int>(light) : Candidate::kAllLights});
  }
  if (alone) candidates.pop_back();  // nothing is left of a muted light
  const std::size_t samples = cells_.samples.pixels.size();
  std::vector<Vec3> colors(candidates.size() * samples);
  LUM_TRY_VOID(renderer_->evaluate(candidates, cells_.samples, {.shadow_rays = kShadowRays}, colors));
  std::vector<CellField> fields;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    fields.push_back(cells_.average(std::span(colors).subspan(k * samples, samples)));
  }
  if (alone) fields.emplace_back(fields.front().size(), Vec3(0.0F));
  const CellField& dark = fields.back();
  Pair pair;
  pair.strength = 0.5 * (distance(cells_, fields.front(), dark) + distance(cells_, fields[steps.size()], dark));
  for (std::size_t k = 0; k < steps.size() && pair.strength > 0.0; ++k) {
    const double shown = std::min(1.0, distance(cells_, fields[k], fields[k + 1]) / pair.strength);
    pair.squared += shown * steps[k].difference * steps[k].difference;
  }
  return pair;
}

Result<double> LightDistance::between(const ParamState& a, const ParamState& b) {
  const std::vector<std::size_t> pairs = light_pairs(a.rig, b.rig, renderer_->frame(), focus_);
  double sum = 0.0;
  double weight = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!is_free(a.rig.lights[i])) continue;
    LUM_TRY(const Pair there, walk(a, i, b.rig.lights[pairs[i]]));
    LUM_TRY(const Pair back, walk(b, pairs[i], a.rig.lights[i]));
    const double strength = 0.5 * (there.strength + back.strength);
    sum += strength * 0.5 * (there.squared + back.squared);
    weight += strength;
  }
  return weight > 0.0 ? std::sqrt(sum / weight) : 0.0;
}

}  // namespace luminist
