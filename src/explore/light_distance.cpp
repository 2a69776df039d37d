#include "explore/light_distance.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "explore/assignment.h"
#include "explore/light_removal.h"
#include "explore/locks.h"

namespace luminist {
namespace {

constexpr int kDistanceCells = 400;
constexpr int kShadowRays = 2;
constexpr double kNever = 1e9;  // cost of a pair of lights of two types

double mean_length(const CellField& part) {
  double sum = 0.0;
  for (const Vec3& value : part) sum += glm::length(value);
  return part.empty() ? 0.0 : sum / static_cast<double>(part.size());
}

double mean_distance(const CellField& a, const CellField& b) {
  double sum = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c) sum += glm::distance(a[c], b[c]);
  return a.empty() ? 0.0 : sum / static_cast<double>(a.size());
}

}  // namespace

double look_distance(const LightLook& a, const LightLook& b) {
  LUM_CHECK(a.part.size() == b.part.size(), "both were seen by one eye");
  const double both = a.strength + b.strength;
  const double shown = both > 0.0 ? mean_distance(a.part, b.part) / both : 0.0;
  return std::hypot(place_difference(a.place, b.place), shown);
}

double look_distance(const std::vector<LightLook>& a, const std::vector<LightLook>& b) {
  LUM_CHECK(a.size() == b.size(), "both have the same lights");
  std::vector<double> costs;
  for (const LightLook& one : a) {
    for (const LightLook& other : b) {
      const double apart = look_distance(one, other);
      costs.push_back(one.type == other.type ? apart * apart : kNever);
    }
  }
  const std::vector<int> pairs = least_cost_assignment(costs, static_cast<int>(a.size()));
  double sum = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto j = static_cast<std::size_t>(pairs[i]);
    LUM_CHECK(a[i].type == b[j].type, "both have as many lights of each type");
    const double weight = a[i].strength + b[j].strength;
    sum += weight * costs[i * a.size() + j];
    weights += weight;
  }
  return weights > 0.0 ? std::sqrt(sum / weights) : 0.0;
}

LightEye::LightEye(Renderer& renderer, const Vec3& focus) : renderer_(&renderer), focus_(focus) {
  const SurfaceBuffer& surface = renderer.surface();
  const Target everywhere = kept_picture(Image(surface.width, surface.height, 3));
  cells_ = CellSampler(surface, everywhere).cut(kDistanceCells, 1, 1);
}

Result<std::vector<LightLook>> LightEye::look(const ParamState& state) {
  // In a style that sums its lights a part is evaluated alone; in others it is what muting the light takes away.
  const bool sums = renderer_->style().combination(state.style) == LightCombination::kSum;
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < state.rig.lights.size(); ++i) {
    if (is_free(state.rig.lights[i])) free.push_back(i);
  }
  std::vector<ParamState> muted(sums ? 0 : free.size(), state);
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < free.size(); ++k) {
    if (!sums) muted[k].rig.lights[free[k]].muted = true;
    candidates.push_back(sums ? Candidate{&state, static_cast<int>(free[k])} : Candidate{&muted[k]});
  }
  if (!sums) candidates.push_back({&state});
  const std::size_t samples = cells_.samples.pixels.size();
  std::vector<Vec3> colors(candidates.size() * samples);
  LUM_TRY_VOID(renderer_->evaluate(candidates, cells_.samples, {.shadow_rays = kShadowRays}, colors));
  const auto field = [&](std::size_t k) { return cells_.average(std::span(colors).subspan(k * samples, samples)); };
  std::vector<LightLook> looks;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const Light& light = state.rig.lights[free[k]];
    LightLook look{light.type, light_place(light, focus_), field(k), 0.0};
    if (!sums) {
      const CellField all = field(free.size());
      for (std::size_t c = 0; c < all.size(); ++c) look.part[c] = all[c] - look.part[c];
    }
    look.strength = mean_length(look.part);
    looks.push_back(std::move(look));
  }
  return looks;
}

}  // namespace luminist
