#include "solve/start_light.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace luminist {
namespace {

constexpr double kWorstCondition = 1e3;  // of the normal matrix: directions seen 30 times less than the best one
constexpr float kLeastFacing = 0.05F;    // mean cosine below which the light would come from behind

/// Sums over the lightened pixels.
struct Sums {
  std::array<Eigen::Matrix3d, 3> normal_matrix{Eigen::Matrix3d::Zero(), Eigen::Matrix3d::Zero(),
                                               Eigen::Matrix3d::Zero()};
  std::array<Eigen::Vector3d, 3> right_side{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  glm::dvec3 position{0.0};
  glm::dvec3 normal{0.0};
  glm::dvec3 added{0.0};   // c - b
  glm::dvec3 albedo{0.0};  // k
  Box box;
  double count = 0.0;

  void add(const Vec3& p, const Vec3& n, const Vec3& k, const Vec3& c) {
    const Eigen::Vector3d normal_i(n.x, n.y, n.z);
    for (int channel = 0; channel < 3; ++channel) {
      const auto j = static_cast<std::size_t>(channel);
      const double reflectance = k[channel];
      normal_matrix[j] += reflectance * reflectance * normal_i * normal_i.transpose();
      right_side[j] += reflectance * static_cast<double>(c[channel]) * normal_i;
    }
    position += glm::dvec3(p);
    normal += glm::dvec3(n);
    added += glm::dvec3(c);
    albedo += glm::dvec3(k);
    box.extend(p);
    count += 1.0;
  }
};

/// Intensity times direction towards the light; nothing where the equations do not say.
std::optional<Eigen::Vector3d> solve_channel(const Eigen::Matrix3d& matrix, const Eigen::Vector3d& right_side) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrix);
  const Eigen::Vector3d& values = eigen.eigenvalues();
  if (!(values(2) > 0.0) || values(2) > kWorstCondition * values(0)) return std::nullopt;
  const Eigen::Vector3d projected = eigen.eigenvectors().transpose() * right_side;
  return eigen.eigenvectors() * projected.cwiseQuotient(values);
}

Vec3 unit_or(const glm::dvec3& v, const Vec3& fallback) {
  const double length = glm::length(v);
  return length > 1e-12 ? Vec3(v / length) : fallback;
}

/// Direction towards the light and intensity by least squares; false if a channel that was lightened has no answer.
bool least_squares(const Sums& sums, Vec3& to_light, Vec3& intensity) {
  glm::dvec3 mean_direction(0.0);
  intensity = Vec3(0.0F);
  for (int channel = 0; channel < 3; ++channel) {
    const auto j = static_cast<std::size_t>(channel);
    if (!(sums.added[channel] > 0.0)) continue;  // clamped to zero
    const std::optional<Eigen::Vector3d> light = solve_channel(sums.normal_matrix[j], sums.right_side[j]);
    if (!light) return false;
    intensity[channel] = static_cast<float>(light->norm());
    mean_direction += glm::dvec3((*light)(0), (*light)(1), (*light)(2));  // unit direction times intensity
  }
  if (!(glm::length(mean_direction) > 0.0)) return false;
  to_light = Vec3(glm::normalize(mean_direction));
  const auto facing = static_cast<float>(glm::dot(sums.normal / sums.count, glm::dvec3(to_light)));
  return facing > kLeastFacing;
}

/// The least half angle at `apex` around `axis` that covers the corners of a box.
float covering_angle(const Box& box, const Vec3& apex, const Vec3& axis) {
  float angle = 0.0F;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 way = box.corner(corner) - apex;
    const float length = glm::length(way);
    if (!(length > 0.0F)) return static_cast<float>(kPi / 2.0);
    angle = std::max(angle, std::acos(std::clamp(glm::dot(way / length, axis), -1.0F, 1.0F)));
  }
  return angle;
}

/// Where the numbers of a light's parameter may be.
class Ranges {
 public:
  Ranges(const Light& light, int param, const SceneFrame& frame)
      : block_(&light.params), param_(param), frame_(frame) {}
  [[nodiscard]] float least(int c) const { return static_cast<float>(block_->range(param_, c, frame_).low); }
  [[nodiscard]] float largest(int c) const { return static_cast<float>(block_->range(param_, c, frame_).high); }
  /// The nearest to `wanted` that is allowed, not below `low` either.
  [[nodiscard]] float nearest(int c, float wanted, float low) const {
    return std::clamp(wanted, std::min(std::max(low, least(c)), largest(c)), largest(c));
  }

 private:
  const ParamBlock* block_;
  int param_;
  SceneFrame frame_;
};

/// The point nearest to `wanted` on the segment from the hot spot that is within the position's range; where the range
/// leaves the hot spot out, the nearest that it allows.
Vec3 within_range(const Vec3& hot_spot, const Vec3& wanted, const Ranges& ranges) {
  float share = 1.0F;
  for (int c = 0; c < 3; ++c) {
    const float step = wanted[c] - hot_spot[c];
    const float bound = step > 0.0F ? ranges.largest(c) : ranges.least(c);
    if (hot_spot[c] < ranges.least(c) || hot_spot[c] > ranges.largest(c)) continue;
    if (std::abs(step) > 0.0F && (wanted[c] - bound) * step > 0.0F)
      share = std::min(share, (bound - hot_spot[c]) / step);
  }
  Vec3 position = hot_spot + std::max(share, 0.0F) * (wanted - hot_spot);
  for (int c = 0; c < 3; ++c) position[c] = std::clamp(position[c], ranges.least(c), ranges.largest(c));
  return position;
}

}  // namespace

std::vector<float> lightening(const SurfaceBuffer& surface, const Target& target) {
  constexpr float kFaint = 0.01F;
  const bool has_strokes =
      target.stroke.size() == surface.pixels() &&
      std::any_of(target.stroke.begin(), target.stroke.end(), [](std::uint32_t id) { return id != 0; });
  std::vector<float> added(surface.pixels(), 0.0F);
  float most = 0.0F;
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (surface.object[i] == 0 || !(target.importance.data[i] > 0.0F)) continue;
    if (has_strokes && target.stroke[i] == 0) continue;
    const Vec3 change = target.color.rgb(i) - target.before.rgb(i);
    const float sum = change.x + change.y + change.z;
    if (!std::isfinite(sum) || !(sum > 0.0F)) continue;
    added[i] = sum;
    most = std::max(most, sum);
  }
  for (float& value : added) {
    if (value <= kFaint * most) value = 0.0F;
  }
  return added;
}

Result<StartLight> estimate_start_light(const SurfaceBuffer& surface, const Target& target, const SceneFrame& frame) {
  return estimate_start_light(surface, target, frame, {});
}

Result<StartLight> estimate_start_light(const SurfaceBuffer& surface, const Target& target, const SceneFrame& frame,
                                        std::span<const unsigned char> mask) {
  LUM_CHECK(target.color.pixels() == surface.pixels(), "a target has the size of the surface it is painted on");
  const std::vector<float> added = lightening(surface, target);
  Sums sums;
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (added[i] <= 0.0F || (!mask.empty() && mask[i] == 0)) continue;
    sums.add(surface.position[i], surface.normal[i], surface.albedo[i], target.color.rgb(i) - target.before.rgb(i));
  }
  if (sums.count == 0.0) {
    return Error{ErrorKind::kNothingToDo, "no pixel was lightened, so nothing says where a new light should be", "",
                 "paint", "paint some light, or start from a light that is there"};
  }
  StartLight start;
  start.frame = frame;
  start.hot_spot = Vec3(sums.position / sums.count);
  Vec3 to_light(0.0F, 1.0F, 0.0F);
  start.ill_conditioned = !least_squares(sums, to_light, start.intensity);
  if (start.ill_conditioned) {
    to_light = unit_or(sums.normal, unit_or(glm::dvec3(surface.eye - start.hot_spot), to_light));
    for (int c = 0; c < 3; ++c) {
      const double reflectance = std::max(sums.albedo[c], 1e-3 * sums.count);
      start.intensity[c] = static_cast<float>(std::max(0.0, sums.added[c] / reflectance));
    }
  }
  start.direction = -to_light;
  start.position = start.hot_spot + 2.0F * frame.radius * to_light;
  start.half_angle = covering_angle(sums.box, start.position, start.direction);
  return start;
}

void apply_start_light(const StartLight& start, Light& light) {
  const ParamSchema& schema = light.params.schema();
  Vec3 position = start.position;
  if (const auto param = schema.by_role("position")) {
    position = within_range(start.hot_spot, start.position, {light, *param, start.frame});
    light.params.set_vec3(*param, position);
  }
  const float distance = glm::distance(position, start.hot_spot);
  if (const auto param = schema.by_role("direction")) {
    const bool there = distance > 1e-4F * start.frame.radius;
    light.params.set_vec3(*param, there ? (start.hot_spot - position) / distance : start.direction);
  }
  if (const auto param = schema.by_role("color")) {
    const Ranges ranges(light, *param, start.frame);
    for (int c = 0; c < 3; ++c) light.params.set(*param, c, ranges.nearest(c, start.intensity[c], 0.0F));
  }
  if (const auto param = schema.by_role("shape")) {
    const float tangent = std::tan(std::min(start.half_angle, 1.5F));
    const Ranges ranges(light, *param, start.frame);
    for (int c = 0; c < std::min(2, schema[*param].components()); ++c) {
      light.params.set(*param, c, ranges.nearest(c, tangent, 0.02F));
    }
  }
  if (const auto param = schema.by_role("falloff_distance")) {
    const Ranges ranges(light, *param, start.frame);
    light.params.set(*param, 0, ranges.nearest(0, distance, ranges.least(0)));
  }
}

}  // namespace luminist
