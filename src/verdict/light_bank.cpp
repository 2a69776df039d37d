#include "verdict/light_bank.h"

#include <algorithm>
#include <cmath>

#include "solve/box_solve.h"

namespace luminist {
namespace {

constexpr int kSides = 48;             // of the sphere around a place, most of which it faces away from
constexpr float kLeastFacing = 0.08F;  // cosine
constexpr int kReweightings = 6;
constexpr float kMost = 1e3F;  // amounts have no range: estimates are not to depend on a light's

/// Side i of n, evenly over the sphere (Fibonacci).
Vec3 side(int i, int n) {
  const double z = 1.0 - (2.0 * i + 1.0) / n;
  const double ring = std::sqrt(1.0 - z * z);
  const double angle = i * kPi * (3.0 - std::sqrt(5.0));
  return {static_cast<float>(ring * std::cos(angle)), static_cast<float>(z),
          static_cast<float>(ring * std::sin(angle))};
}

StartLight light_from(const Vec3& way, const BankFocus& focus, const SceneFrame& frame) {
  StartLight light;
  const float distance = 2.0F * frame.radius;
  light.hot_spot = focus.position;
  light.direction = -way;
  light.position = focus.position + distance * way;
  light.intensity = Vec3(1.0F);
  light.half_angle = std::atan(std::max(focus.extent, 0.02F * frame.radius) / distance);
  light.frame = frame;
  return light;
}

}  // namespace

BankFocus focus_of(const SampledWish& wish, int region, std::span<const Vec3> colors, const SurfaceBuffer& surface) {
  BankFocus focus;
  double sum = 0.0;
  std::vector<std::pair<std::uint32_t, double>> says;
  for (std::size_t i = 0; i < wish.region.size(); ++i) {
    if (wish.region[i] != region) continue;
    const Vec3 lack = glm::max(wish.target[i] - colors[i], 0.0F);
    const double say = wish.weight[i] * (static_cast<double>(lack.x) + lack.y + lack.z + 1e-6);
    says.emplace_back(wish.samples.pixels[i], say);
    sum += say;
  }
  if (!(sum > 0.0)) return focus;
  for (const auto& [pixel, say] : says) {
    focus.position += static_cast<float>(say / sum) * surface.position[pixel];
    focus.normal += static_cast<float>(say / sum) * surface.normal[pixel];
  }
  double square = 0.0;
  for (const auto& [pixel, say] : says) {
    const Vec3 offset = surface.position[pixel] - focus.position;
    square += say / sum * glm::dot(offset, offset);
  }
  focus.extent = 1.5F * static_cast<float>(std::sqrt(square));
  return focus;
}

ParamState with_light(const ParamState& state, const Light& prototype, const StartLight& start,
                      const std::string& name) {
  ParamState next = state;
  Light light = prototype;
  light.name = next.rig.unused_name(name);
  light.muted = false;
  light.params.clear_limits();  // what holds of the other is nothing to this one
  light.params.set_param_following(-1, false);
  apply_start_light(start, light);
  next.rig.lights.push_back(std::move(light));
  return next;
}

Result<LightBank> LightBank::create(Renderer& renderer, const ParamState& state, const SampledWish& wish,
                                    std::span<const BankFocus> foci, const Light& prototype) {
  LightBank bank(wish);
  std::vector<ParamState> states = {state};
  for (const BankFocus& focus : foci) {
    const bool flat = glm::length(focus.normal) > 0.5F;  // else it looks everywhere
    for (int i = 0; i < kSides; ++i) {
      const Vec3 way = side(i, kSides);
      if (flat && glm::dot(way, glm::normalize(focus.normal)) < kLeastFacing) continue;
      bank.lights_.push_back(light_from(way, focus, renderer.frame()));
      states.push_back(with_light(state, prototype, bank.lights_.back(), "light"));
      Light& light = states.back().rig.lights.back();
      if (const auto color = light.params.schema().by_role("color")) light.params.set_vec3(*color, Vec3(1.0F));
    }
  }
  const bool sum = renderer.style().combination(state.style) == LightCombination::kSum;
  const int added = static_cast<int>(state.rig.lights.size());
  std::vector<Candidate> batch = {{&states[0], Candidate::kAllLights}};
  for (std::size_t k = 1; k < states.size(); ++k) batch.push_back({&states[k], sum ? added : Candidate::kAllLights});
  const std::size_t count = wish.samples.pixels.size();
  std::vector<Vec3> out(batch.size() * count);
  LUM_TRY_VOID(renderer.evaluate({batch.data(), 1}, wish.samples, {}, {out.data(), count}));
  if (batch.size() > 1) {
    const std::span<Vec3> rest(out.begin() + static_cast<std::ptrdiff_t>(count), out.end());
    LUM_TRY_VOID(renderer.evaluate(std::span(batch).subspan(1), wish.samples, {}, rest));
  }
  for (std::size_t k = 0; k < batch.size(); ++k) {
    const auto begin = out.begin() + static_cast<std::ptrdiff_t>(k * count);
    std::vector<Vec3> part(begin, begin + static_cast<std::ptrdiff_t>(count));
    if (k == 0) {
      bank.colors_ = std::move(part);
      continue;
    }
    if (!sum) std::transform(part.begin(), part.end(), bank.colors_.begin(), part.begin(), std::minus<>());
    bank.parts_.push_back(std::move(part));
  }
  return bank;
}

std::vector<Vec3> LightBank::fitted() const {
  const std::size_t n = parts_.size();
  std::vector<Vec3> colors = colors_;
  std::vector<Vec3> amounts(n, Vec3(0.0F));
  for (int round = 0; n > 0 && round < kReweightings; ++round) {
    const double floor = 0.02 * wish_->error(colors) + 1e-9;
    for (glm::length_t c = 0; c < 3; ++c) {
      std::vector<double> a(n * n, 0.0);
      std::vector<double> b(n, 0.0);
      std::vector<double> x(n);
      for (std::size_t i = 0; i < colors.size(); ++i) {
        const double weight = wish_->weight[i] / (glm::distance(wish_->target[i], colors[i]) + floor);
        const double lack = static_cast<double>(wish_->target[i][c]) - colors_[i][c];
        for (std::size_t k = 0; k < n; ++k) {
          const double left = weight * parts_[k][i][c];
          if (left == 0.0) continue;
          b[k] += left * lack;
          for (std::size_t j = 0; j < n; ++j) a[k * n + j] += left * parts_[j][i][c];
        }
      }
      double trace = 0.0;
      for (std::size_t k = 0; k < n; ++k) trace += a[k * n + k];
      for (std::size_t k = 0; k < n; ++k) a[k * n + k] += 1e-6 * trace, x[k] = amounts[k][c];
      solve_box(a, b, std::vector<double>(n, 0.0), std::vector<double>(n, kMost), x);
      for (std::size_t k = 0; k < n; ++k) amounts[k][c] = static_cast<float>(x[k]);
    }
    std::vector<Vec3> next = colors_;
    for (std::size_t k = 0; k < n; ++k) {
      for (std::size_t i = 0; i < next.size(); ++i) next[i] += amounts[k] * parts_[k][i];
    }
    if (!(wish_->error(next) < wish_->error(colors))) break;
    colors = std::move(next);
  }
  return colors;
}

/// The intensity of one light that fits what is missing best, by least squares.
Vec3 LightBank::amount(std::size_t light, std::span<const double> weight) const {
  glm::dvec3 above(0.0);
  glm::dvec3 below(0.0);
  for (std::size_t i = 0; i < colors_.size(); ++i) {
    const glm::dvec3 part(parts_[light][i]);
    above += weight[i] * part * glm::dvec3(wish_->target[i] - colors_[i]);
    below += weight[i] * part * part;
  }
  Vec3 amount(0.0F);
  for (glm::length_t c = 0; c < 3; ++c) {
    if (below[c] > 0.0) amount[c] = static_cast<float>(std::max(0.0, above[c] / below[c]));
  }
  return amount;
}

LightBank::Pick LightBank::best(std::span<const double> weight) const {
  Pick pick;
  for (std::size_t k = 0; k < lights_.size(); ++k) {
    const Vec3 intensity = amount(k, weight);
    double gain = 0.0;
    for (std::size_t i = 0; i < colors_.size(); ++i) {
      const Vec3 lack = wish_->target[i] - colors_[i];
      gain += weight[i] * (glm::length(lack) - glm::length(lack - intensity * parts_[k][i]));
    }
    if (gain <= pick.gain) continue;
    pick = {lights_[k], gain};
    pick.light.intensity = intensity;
  }
  return pick;
}

}  // namespace luminist
