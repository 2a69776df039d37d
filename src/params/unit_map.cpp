#include "params/unit_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/ext/vector_double3.hpp>

#include "base/check.h"

namespace luminist {
namespace {

using DVec3 = glm::dvec3;

const ParamSpec& spec_of(const ParamBlock& block, const Dof& dof) {
  return block.schema()[dof.param];
}

/// What 0 and 1 mean, in the units of the declaration.
ParamRange written_range(const ParamBlock& block, const Dof& dof, const SceneFrame& frame) {
  const ParamSpec& spec = spec_of(block, dof);
  if (const ParamRange* limits = block.limits(spec.first_dof + dof.component)) {
    return {spec.written(dof.component, limits->low, frame), spec.written(dof.component, limits->high, frame)};
  }
  const auto c = static_cast<std::size_t>(dof.component);
  return {spec.range_min[c], spec.range_max[c]};
}

double to_unit_number(const ParamBlock& block, const Dof& dof, const SceneFrame& frame) {
  const ParamSpec& spec = spec_of(block, dof);
  const auto [lo, hi] = written_range(block, dof, frame);
  const double value = spec.written(dof.component, block.get(dof.param, dof.component), frame);
  if (spec.scale != ParamScale::kLog) return (value - lo) / (hi - lo);
  // A number without a logarithm lies at the far end of what a float can hold.
  const double positive = std::max(value, static_cast<double>(std::numeric_limits<float>::min()));
  return std::log(positive / lo) / std::log(hi / lo);
}

double from_unit_number(const ParamBlock& block, const Dof& dof, double x, const SceneFrame& frame) {
  const ParamSpec& spec = spec_of(block, dof);
  const auto [lo, hi] = written_range(block, dof, frame);
  const double value = spec.scale == ParamScale::kLog ? lo * std::pow(hi / lo, x) : lo + x * (hi - lo);
  return spec.stored(dof.component, value, frame);
}

/// The unit sphere around a base direction: the exponential map of its tangent plane. Coordinates in radians.
class DirectionChart {
 public:
  explicit DirectionChart(const Vec3& base) : stored_(base), base_(glm::normalize(DVec3(base))) {
    Vec3 t;
    Vec3 b;
    tangent_frame(Vec3(base_), t, b);
    u_ = glm::normalize(DVec3(t) - glm::dot(DVec3(t), base_) * base_);
    v_ = glm::cross(base_, u_);
  }

  [[nodiscard]] Vec3 direction(double u, double v) const {
    const double angle = std::hypot(u, v);
    if (!(angle > 0.0) || !std::isfinite(angle)) return stored_;  // the base itself, to the bit
    return Vec3(glm::normalize(std::cos(angle) * base_ + std::sin(angle) * (u / angle * u_ + v / angle * v_)));
  }

  /// The coordinates of a direction, at most pi from the origin; the opposite of the base lies on the first axis.
  [[nodiscard]] DVec3 coordinates(const Vec3& direction) const {
    if (direction == stored_) return DVec3(0.0);
    const DVec3 d(direction);
    const double u = glm::dot(d, u_);
    const double v = glm::dot(d, v_);
    const double sine = std::hypot(u, v);
    const double angle = std::atan2(sine, glm::dot(d, base_));
    if (sine == 0.0) return {angle, 0.0, 0.0};
    return {angle * u / sine, angle * v / sine, 0.0};
  }

 private:
  Vec3 stored_;
  DVec3 base_, u_, v_;
};

/// The direction a chart can start from: the stored one, or down if it is no direction.
Vec3 usable_direction(const Vec3& stored) {
  return unit_direction(stored).value_or(Vec3(0.0F, -1.0F, 0.0F));
}

double radians_per_unit(const ParamSpec& spec) {
  return spec.range_max[0] - spec.range_min[0];
}

}  // namespace

double penalty(double x) {
  return std::max(0.0, (2.0 * x - 1.0) * (2.0 * x - 1.0) - 1.0);
}

double penalty(std::span<const double> x) {
  double sum = 0.0;
  for (const double coordinate : x) sum += penalty(coordinate);
  return sum;
}

UnitMap UnitMap::create(std::span<const ParamBlock* const> blocks, const SceneFrame& frame) {
  UnitMap map;
  map.frame_ = frame;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const ParamBlock& block = *blocks[b];
    for (int param = 0; param < block.schema().size(); ++param) {
      const ParamSpec& spec = block.schema()[param];
      for (int c = 0; c < spec.dofs(); ++c) {
        if (block.locked(spec.first_dof + c)) continue;
        map.dofs_.push_back({static_cast<int>(b), param, c});
        const bool direction = spec.type == ParamType::kDirection;
        map.chart_.push_back(direction ? usable_direction(block.vec3(param)) : Vec3(0.0F));
      }
    }
  }
  return map;
}

std::vector<double> UnitMap::to_unit(std::span<const ParamBlock* const> blocks) const {
  std::vector<double> x(dofs_.size());
  for (std::size_t i = 0; i < dofs_.size(); ++i) {
    const Dof& dof = dofs_[i];
    const ParamBlock& block = *blocks[static_cast<std::size_t>(dof.block)];
    const ParamSpec& spec = spec_of(block, dof);
    if (spec.type == ParamType::kDirection) {
      const DVec3 uv = DirectionChart(chart_[i]).coordinates(usable_direction(block.vec3(dof.param)));
      x[i] = 0.5 + uv[dof.component] / radians_per_unit(spec);
    } else {
      x[i] = to_unit_number(block, dof, frame_);
    }
  }
  return x;
}

void UnitMap::from_unit(std::span<const double> x, std::span<ParamBlock* const> blocks) const {
  LUM_CHECK(x.size() == dofs_.size(), "one coordinate for each degree of freedom");
  for (std::size_t i = 0; i < dofs_.size(); ++i) {
    const Dof& dof = dofs_[i];
    ParamBlock& block = *blocks[static_cast<std::size_t>(dof.block)];
    const ParamSpec& spec = spec_of(block, dof);
    if (spec.type != ParamType::kDirection) {
      block.set(dof.param, dof.component, from_unit_number(block, dof, x[i], frame_));
      continue;
    }
    // Both axes of a direction stand together; a locked axis keeps the base's coordinate, which is 0.
    double uv[2] = {0.0, 0.0};
    const bool pair = i + 1 < dofs_.size() && dofs_[i + 1].block == dof.block && dofs_[i + 1].param == dof.param;
    uv[dof.component] = (x[i] - 0.5) * radians_per_unit(spec);
    if (pair) uv[1] = (x[i + 1] - 0.5) * radians_per_unit(spec);
    block.set_vec3(dof.param, DirectionChart(chart_[i]).direction(uv[0], uv[1]));
    if (pair) ++i;
  }
}

}  // namespace luminist
