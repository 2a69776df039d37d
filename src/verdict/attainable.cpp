#include "verdict/attainable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "solve/box_solve.h"
#include "verdict/lock_probe.h"

namespace luminist {
namespace {

constexpr int kRounds = 30;                 // of reweighting, on some pixels
constexpr int kLastRounds = 2;              // on all
constexpr std::size_t kFirstPixels = 2048;  // how many are some
// Where the un-squared norm is rounded off, in shares of the mean error: a wide one is solved exactly, a narrow one is
// nearer to the norm.
constexpr std::array kFloors = {0.3, 0.1, 0.03};
constexpr float kNegative = -1e-3F;  // less is rounding: pictures are stored as floats and summed in another order

/// The light's colour, if all that is free of it belongs to it.
std::optional<int> only_color_free(const ParamBlock& block) {
  const std::optional<int> color = block.schema().by_role("color");
  if (!color || block.schema()[*color].type != ParamType::kColor) return std::nullopt;
  ParamBlock rest = block;
  rest.set_param_locked(*color, true);
  if (any_free(rest)) return std::nullopt;
  return color;
}

/// A free light that is known up to its colour. What follows another light changes with all that is free of that one.
bool adds_only_color(const Light& light) {
  return any_free(light.params) && only_color_free(light.params).has_value();
}

bool bound_exists(const Renderer& renderer, const ParamState& state) {
  const Style& style = renderer.style();
  if (style.combination(state.style) != LightCombination::kSum || style.metric.blur > 0.0F) return false;
  if (const auto denoise = state.style.schema().by_role("denoise"); denoise && state.style.get(*denoise) != 0.0) {
    return false;  // smoothed parts are not parts of a smoothed picture
  }
  if (any_free(state.rig.ambient) || any_free(state.style)) return false;
  for (const MaterialParams& material : state.materials) {
    if (any_free(material.params)) return false;  // the lights' parts are no parts of what it may become
  }
  const Light* shared = state.rig.shadow_light.empty() ? nullptr : state.rig.find(state.rig.shadow_light);
  return shared == nullptr || !may_change(state.rig, *shared) || adds_only_color(*shared);
}

}  // namespace

Result<std::optional<AttainableColors>> AttainableColors::create(Renderer& renderer, const ParamState& state,
                                                                 const Image& picture) {
  if (!bound_exists(renderer, state)) return std::optional<AttainableColors>();
  AttainableColors colors;
  ParamState locked = state;
  std::vector<std::size_t> scaled;
  for (std::size_t i = 0; i < locked.rig.lights.size(); ++i) {
    Light& light = locked.rig.lights[i];
    if (light.muted || !may_change(state.rig, light)) continue;
    if (adds_only_color(light)) {
      scaled.push_back(i);
    } else {
      colors.open_ = true;
    }
    light.muted = true;
  }
  LUM_TRY(colors.locked_, renderer.render(locked));
  for (std::size_t i = 0; i < picture.data.size(); ++i) {
    if (picture.data[i] - colors.locked_.data[i] < kNegative) return std::optional<AttainableColors>();
  }
  for (const std::size_t i : scaled) {
    ParamState white = locked;
    white.rig.lights[i].muted = false;
    ParamBlock& block = white.rig.lights[i].params;
    const int param = *only_color_free(block);
    const ParamSpec& spec = block.schema()[param];
    Scaled part;
    part.color = block.vec3(param);
    for (int c = 0; c < 3; ++c) {
      const bool free = !block.locked(spec.first_dof + c);
      const auto [low, high] = block.range(param, c, renderer.frame());
      part.low[c] = free ? static_cast<float>(low) : part.color[c];
      part.high[c] = free ? static_cast<float>(high) : part.color[c];
    }
    block.set_vec3(param, Vec3(1.0F));
    LUM_TRY(part.white, renderer.render(white));
    for (std::size_t k = 0; k < part.white.data.size(); ++k) part.white.data[k] -= colors.locked_.data[k];
    colors.scaled_.push_back(std::move(part));
  }
  return std::optional(std::move(colors));
}

/// T - R for given colours, what is not known added where it brings R nearer to T.
Vec3 AttainableColors::residual(const Target& target, std::size_t pixel, std::span<const Vec3> colors) const {
  Vec3 rest = target.color.rgb(pixel) - locked_.rgb(pixel);
  for (std::size_t k = 0; k < scaled_.size(); ++k) rest -= colors[k] * scaled_[k].white.rgb(pixel);
  return open_ ? glm::min(rest, 0.0F) : rest;
}

double AttainableColors::smooth_error(const Target& target, std::span<const std::uint32_t> pixels, double floor,
                                      std::span<const Vec3> colors) const {
  double error = 0.0;
  double importance = 0.0;
  for (const std::uint32_t pixel : pixels) {
    const double length = glm::length(residual(target, pixel, colors));
    error += target.importance.data[pixel] * std::hypot(length, floor);
    importance += target.importance.data[pixel];
  }
  return importance > 0.0 ? error / importance : 0.0;
}

/// One channel of the colours, moved to the least squares that are weighted for the un-squared norm.
void AttainableColors::improve(const Target& target, std::span<const std::uint32_t> pixels, double floor,
                               glm::length_t channel, std::span<const Vec3> colors, std::span<Vec3> better) const {
  const std::size_t n = scaled_.size();
  const auto part = [&](std::size_t light, std::uint32_t pixel, glm::length_t c) {
    return static_cast<double>(
        scaled_[light].white.data[3 * static_cast<std::size_t>(pixel) + static_cast<std::size_t>(c)]);
  };
  std::vector<double> a(n * n, 0.0);
  std::vector<double> b(n, 0.0);
  std::vector<double> low(n);
  std::vector<double> high(n);
  std::vector<double> step(n, 0.0);
  for (const std::uint32_t pixel : pixels) {
    const Vec3 r = residual(target, pixel, colors);
    if (open_ && r[channel] >= 0.0F) continue;  // what is not known fills it
    const double weight = target.importance.data[pixel] / std::hypot(glm::length(r), floor);
    for (std::size_t i = 0; i < n; ++i) {
      const double left = weight * part(i, pixel, channel);
      if (left == 0.0) continue;
      b[i] += left * r[channel];
      for (std::size_t j = 0; j <= i; ++j) a[i * n + j] += left * part(j, pixel, channel);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) a[j * n + i] = a[i * n + j];
    low[i] = scaled_[i].low[channel] - colors[i][channel];
    high[i] = scaled_[i].high[channel] - colors[i][channel];
  }
  solve_box(a, b, low, high, step);
  for (std::size_t i = 0; i < n; ++i) {
    better[i][channel] =
        std::clamp(colors[i][channel] + static_cast<float>(step[i]), scaled_[i].low[channel], scaled_[i].high[channel]);
  }
}

/// Moves the colours to about the least error whose norm is rounded off at a floor.
void AttainableColors::fit(const Target& target, std::span<const std::uint32_t> pixels, int rounds, double floor,
                           std::vector<Vec3>& colors) const {
  double error = smooth_error(target, pixels, floor, colors);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vec3> better = colors;
    for (glm::length_t c = 0; c < 3; ++c) improve(target, pixels, floor, c, colors, better);
    const double better_error = smooth_error(target, pixels, floor, better);
    if (!(better_error < error)) return;
    const bool settled = better_error > (1.0 - 1e-5) * error;
    colors = std::move(better);
    error = better_error;
    if (settled) return;
  }
}

double AttainableColors::least_error(const Target& target, std::span<const std::uint32_t> pixels) const {
  std::vector<std::uint32_t> all;
  if (pixels.empty()) {
    all.resize(target.color.pixels());
    std::iota(all.begin(), all.end(), 0U);
    pixels = all;
  }
  std::vector<Vec3> start;
  for (const Scaled& part : scaled_) start.push_back(glm::clamp(part.color, part.low, part.high));
  const double plain = bound(target, pixels, start, 0.0);
  if (scaled_.empty()) return plain;
  std::vector<std::uint32_t> some;
  const std::size_t stride = pixels.size() / kFirstPixels + 1;
  for (std::size_t i = stride / 2; i < pixels.size(); i += stride) some.push_back(pixels[i]);
  const double scale = smooth_error(target, some, 0.0, start);
  std::vector<Vec3> colors = start;
  std::vector<Vec3> best = start;
  double best_bound = -1.0;
  double best_floor = 0.0;
  for (const double floor : kFloors) {
    fit(target, some, kRounds, floor * scale, colors);
    const double found = bound(target, some, colors, floor * scale);
    if (found > best_bound) best_bound = found, best = colors, best_floor = floor * scale;
  }
  if (stride > 1) fit(target, pixels, kLastRounds, best_floor, best);
  return std::max(plain, bound(target, pixels, best, best_floor));
}

/// For any y_i with |y_i| <= I_i, and y_i <= 0 where something unknown adds: sum I |T - R| >= sum y (T - R). The right
/// side is linear in the colours, so its least value lies in a corner of their box. At the least error the y of the
/// rounded norm make it flat, but for where colours stop at their range.
double AttainableColors::bound(const Target& target, std::span<const std::uint32_t> pixels,
                               std::span<const Vec3> colors, double floor) const {
  double sum = 0.0;
  double importance = 0.0;
  std::vector<glm::dvec3> slope(scaled_.size(), glm::dvec3(0.0));
  for (const std::uint32_t pixel : pixels) {
    const double weight = target.importance.data[pixel];
    importance += weight;
    const glm::dvec3 r(residual(target, pixel, colors));
    const double length = std::hypot(glm::length(r), floor);
    if (!(length > 0.0)) continue;
    const glm::dvec3 y = weight / length * r;
    sum += glm::dot(y, glm::dvec3(target.color.rgb(pixel) - locked_.rgb(pixel)));
    for (std::size_t k = 0; k < scaled_.size(); ++k) slope[k] += y * glm::dvec3(scaled_[k].white.rgb(pixel));
  }
  for (std::size_t k = 0; k < scaled_.size(); ++k) {
    for (glm::length_t c = 0; c < 3; ++c) {
      sum -= slope[k][c] * static_cast<double>(slope[k][c] > 0.0 ? scaled_[k].high[c] : scaled_[k].low[c]);
    }
  }
  return importance > 0.0 ? std::max(0.0, sum / importance) : 0.0;
}

}  // namespace luminist
