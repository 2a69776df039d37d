#include "params/param_block.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <glm/ext/vector_double3.hpp>

#include "base/check.h"

namespace luminist {
namespace {

constexpr std::size_t kNumberSize = 4;  ///< every stored number is a float or a 32-bit integer

bool stored_as_float(ParamType type) {
  return type != ParamType::kInt && type != ParamType::kBool && type != ParamType::kChoice;
}

std::int32_t rounded(double value) {
  if (std::isnan(value)) return 0;
  constexpr double kLo = std::numeric_limits<std::int32_t>::min();
  constexpr double kHi = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::clamp(std::round(value), kLo, kHi));
}

/// A double as the nearest float; beyond the largest float an infinity, as IEEE 754 rounds.
float narrowed(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (std::abs(value) > kLargest) {
    return std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(value > 0.0 ? 1.0 : -1.0));
  }
  return static_cast<float>(value);
}

}  // namespace

std::optional<Vec3> unit_direction(const Vec3& vector) {
  const glm::dvec3 exact(vector);
  const double length = glm::length(exact);
  if (!std::isfinite(length) || length < 1e-30) return std::nullopt;
  // Normalized floats are off by a few roundings, 6e-8 each.
  if (std::abs(length - 1.0) < 1e-6) return vector;
  return Vec3(exact / length);
}

ParamBlock::ParamBlock(std::shared_ptr<const ParamSchema> schema, const SceneFrame& frame)
    : schema_(std::move(schema)) {
  LUM_CHECK(schema_ != nullptr, "a block has a schema");
  bytes_.resize(schema_->byte_size());
  locked_.resize(static_cast<std::size_t>(schema_->dofs()));
  following_.resize(locked_.size());
  for (int param = 0; param < schema_->size(); ++param) {
    const ParamSpec& spec = (*schema_)[param];
    for (int c = 0; c < spec.components(); ++c) {
      set(param, c, spec.stored(c, spec.default_value[static_cast<std::size_t>(c)], frame));
    }
    set_param_locked(param, !spec.solve);
  }
}

bool ParamBlock::at_default(int param, const SceneFrame& frame) const {
  const ParamSpec& spec = schema()[param];
  for (int i = 0; i < spec.components(); ++i) {
    const double wanted = spec.stored(i, spec.default_value[static_cast<std::size_t>(i)], frame);
    if (static_cast<float>(wanted) != static_cast<float>(get(param, i))) return false;
  }
  return true;
}

double ParamBlock::get(int param, int component) const {
  const ParamSpec& spec = schema()[param];
  LUM_CHECK(component >= 0 && component < spec.components(), "the component exists");
  const std::byte* place = bytes_.data() + spec.offset + kNumberSize * static_cast<std::size_t>(component);
  if (stored_as_float(spec.type)) {
    float value = 0.0F;
    std::memcpy(&value, place, sizeof value);
    return static_cast<double>(value);
  }
  std::int32_t value = 0;
  std::memcpy(&value, place, sizeof value);
  return static_cast<double>(value);
}

void ParamBlock::set(int param, int component, double value) {
  const ParamSpec& spec = schema()[param];
  LUM_CHECK(component >= 0 && component < spec.components(), "the component exists");
  std::byte* place = bytes_.data() + spec.offset + kNumberSize * static_cast<std::size_t>(component);
  if (stored_as_float(spec.type)) {
    const float number = narrowed(value);
    std::memcpy(place, &number, sizeof number);
    return;
  }
  std::int32_t number = rounded(value);
  if (spec.type == ParamType::kBool) number = number != 0 ? 1 : 0;
  if (spec.type == ParamType::kChoice) {
    LUM_CHECK(number >= 0 && static_cast<std::size_t>(number) < spec.choices.size(), "a choice's index exists");
  }
  std::memcpy(place, &number, sizeof number);
}

Vec2 ParamBlock::vec2(int param) const {
  return {static_cast<float>(get(param, 0)), static_cast<float>(get(param, 1))};
}

Vec3 ParamBlock::vec3(int param) const {
  return {static_cast<float>(get(param, 0)), static_cast<float>(get(param, 1)), static_cast<float>(get(param, 2))};
}

void ParamBlock::set_vec3(int param, const Vec3& value) {
  for (int c = 0; c < 3; ++c) set(param, c, static_cast<double>(value[c]));
}

int ParamBlock::locks() const {
  return static_cast<int>(std::ranges::count(locked_, true));
}

void ParamBlock::set_param_locked(int param, bool locked) {
  if (param < 0) {
    locked_.assign(locked_.size(), locked);
    return;
  }
  const ParamSpec& spec = schema()[param];
  for (int i = 0; i < spec.dofs(); ++i) set_locked(spec.first_dof + i, locked);
}

void ParamBlock::set_param_following(int param, bool following) {
  if (param < 0) {
    following_.assign(following_.size(), following);
    return;
  }
  const ParamSpec& spec = schema()[param];
  for (int i = 0; i < spec.dofs(); ++i) following_[static_cast<std::size_t>(spec.first_dof + i)] = following;
}

ParamRange ParamBlock::range(int param, int component, const SceneFrame& frame) const {
  const ParamSpec& spec = schema()[param];
  const ParamRange* held = component < spec.dofs() ? limits(spec.first_dof + component) : nullptr;
  if (held != nullptr) return *held;
  const auto c = static_cast<std::size_t>(component);
  return {spec.stored(component, spec.range_min[c], frame), spec.stored(component, spec.range_max[c], frame)};
}

void ParamBlock::set_limits(int dof, const ParamRange& limits) {
  for (auto& [limited, range] : limits_) {
    if (limited == dof) return void(range = limits);
  }
  limits_.emplace_back(dof, limits);
}

const ParamRange* ParamBlock::limits(int dof) const {
  for (const auto& [limited, range] : limits_) {
    if (limited == dof) return &range;
  }
  return nullptr;
}

bool ParamBlock::same_values(const ParamBlock& other) const {
  return schema_ == other.schema_ && bytes_ == other.bytes_;
}

}  // namespace luminist
