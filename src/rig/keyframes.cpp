#include "rig/keyframes.h"

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "params/param_text.h"
#include "rig/light_rig.h"

namespace luminist {
namespace {

using Values = std::array<double, 3>;

bool steps(const ParamSpec& spec) {
  return spec.type == ParamType::kInt || spec.type == ParamType::kBool || spec.type == ParamType::kChoice;
}

/// Slope at key i such that the curve is smooth and, between two keys, monotone. source Steffen 1990, equation 11.
double slope_at(const std::vector<Key>& keys, std::size_t i, std::size_t component) {
  if (i == 0 || i + 1 == keys.size()) return 0.0;
  const double before = keys[i].frame - keys[i - 1].frame;
  const double after = keys[i + 1].frame - keys[i].frame;
  const double left = (keys[i].value[component] - keys[i - 1].value[component]) / before;
  const double right = (keys[i + 1].value[component] - keys[i].value[component]) / after;
  if (left * right <= 0.0) return 0.0;
  const double parabola = (left * after + right * before) / (before + after);
  const double least = std::min({std::abs(left), std::abs(right), 0.5 * std::abs(parabola)});
  return std::copysign(2.0 * least, left);
}

Values smooth_between(const std::vector<Key>& keys, std::size_t i, double t) {
  const double step = keys[i + 1].frame - keys[i].frame;
  const double t2 = t * t;
  const double t3 = t2 * t;
  Values value{};
  for (std::size_t c = 0; c < 3; ++c) {
    value[c] = (2.0 * t3 - 3.0 * t2 + 1.0) * keys[i].value[c] + step * (t3 - 2.0 * t2 + t) * slope_at(keys, i, c) +
               (3.0 * t2 - 2.0 * t3) * keys[i + 1].value[c] + step * (t3 - t2) * slope_at(keys, i + 1, c);
  }
  return value;
}

Values mixed(const Values& a, const Values& b, double t) {
  Values value{};
  for (std::size_t c = 0; c < 3; ++c) value[c] = (1.0 - t) * a[c] + t * b[c];
  return value;
}

/// Along the great circle; around any axis between opposite directions.
Values turned(const Values& from, const Values& to, double t) {
  glm::dvec3 a(from[0], from[1], from[2]);
  glm::dvec3 b(to[0], to[1], to[2]);
  if (!(glm::length(a) > 0.0) || !(glm::length(b) > 0.0)) return from;  // no direction to turn
  a = glm::normalize(a), b = glm::normalize(b);
  const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
  constexpr double kTiny = 1e-9;
  glm::dvec3 across = b - glm::dot(a, b) * a;
  if (glm::length(across) < kTiny) {
    if (angle < 1.0) return t < 1.0 ? from : to;
    Vec3 x, y;
    tangent_frame(Vec3(a), x, y);
    across = x;
  }
  const glm::dvec3 v = std::cos(t * angle) * a + std::sin(t * angle) * glm::normalize(across);
  return {v.x, v.y, v.z};
}

double ease(double t) {
  return t * t * (3.0 - 2.0 * t);
}

Values value_at(const KeyTrack& track, const ParamSpec& spec, double frame) {
  const std::vector<Key>& keys = track.keys;
  const auto after =
      std::upper_bound(keys.begin(), keys.end(), frame, [](double f, const Key& key) { return f < key.frame; });
  if (after == keys.begin()) return keys.front().value;
  const auto i = static_cast<std::size_t>(after - keys.begin()) - 1;
  const Key& key = keys[i];
  if (after == keys.end() || frame == key.frame || key.interpolation == KeyInterpolation::kStep || steps(spec)) {
    return key.value;
  }
  const double t = (frame - key.frame) / (after->frame - key.frame);
  const bool smooth = key.interpolation == KeyInterpolation::kSmooth;
  if (spec.type == ParamType::kDirection) return turned(key.value, after->value, smooth ? ease(t) : t);
  return smooth ? smooth_between(keys, i, t) : mixed(key.value, after->value, t);
}

/// Sets what a track is of; what is stored is a float, so a key's value comes back to the bit.
void apply(const Values& value, const KeyTrack& track, ParamBlock& block, int param) {
  if (track.component >= 0) return block.set(param, track.component, value[0]);
  for (int c = 0; c < block.schema()[param].components(); ++c) {
    block.set(param, c, value[static_cast<std::size_t>(c)]);
  }
}

}  // namespace

std::span<const std::string> key_interpolation_words() {
  static const std::array<std::string, 3> words{"step", "linear", "smooth"};
  return words;
}

bool keys_by_component(const ParamSpec& spec) {
  return spec.components() > 1 && spec.type != ParamType::kDirection;
}

ParamBlock* keyed_block(LightRig& rig, const std::string& light) {
  if (light.empty()) return &rig.ambient;
  Light* found = rig.find(light);
  return found != nullptr ? &found->params : nullptr;
}

std::string track_name(const LightRig& rig, const KeyTrack& track) {
  const Light* light = rig.find(track.light);
  if (light == nullptr && !track.light.empty()) return "";
  const ParamSchema& schema = light != nullptr ? light->params.schema() : rig.ambient.schema();
  const auto param = schema.find(track.param);
  if (!param || track.component >= schema[*param].components()) return "";
  return track.component < 0 ? track.param : dof_name(schema[*param], track.component);
}

void pose(LightRig& rig, double frame) {
  if (rig.keys.empty()) return;
  for (const KeyTrack& track : rig.keys) {
    ParamBlock* block = keyed_block(rig, track.light);
    const auto param = block != nullptr ? block->schema().find(track.param) : std::nullopt;
    if (param) apply(value_at(track, block->schema()[*param], frame), track, *block, *param);
  }
  keep_constraints(rig);
}

std::vector<double> key_frames(const LightRig& rig, const std::string& light) {
  std::vector<double> frames;
  for (const KeyTrack& track : rig.keys) {
    if (light != "*" && track.light != light) continue;
    for (const Key& key : track.keys) frames.push_back(key.frame);
  }
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

}  // namespace luminist
