#include "app/light_shape.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "params/param_text.h"
#include "trace/rig_light.h"

namespace luminist {
namespace {

constexpr float kNearest = 0.125F;  // of the reach
constexpr float kLeastBarn = 0.01F;

/// The cutoffs of a light: near and far, or one, which is the far one.
std::vector<int> cutoffs(const ParamSchema& schema) {
  std::vector<int> params;
  for (int param = 0; param < schema.size(); ++param) {
    if (schema[param].role == "cutoff" && schema[param].components() == 2) params.push_back(param);
  }
  return params;
}

Vec2 pair_of(const ParamBlock& block, int param) {
  return {static_cast<float>(block.get(param, 0)), static_cast<float>(block.get(param, 1))};
}

template <class Vector>
void assign(const Light& light, int param, const Vector& value, std::vector<std::string>& to) {
  std::string text = fmt::format("lights/{}/{}=", light.name, light.params.schema()[param].name);
  for (int c = 0; c < Vector::length(); ++c) {
    if (c > 0) text += ",";
    text += number_text(shortest_double(value[c]));
  }
  to.push_back(std::move(text));
}

/// Closed: its last place is its first.
std::vector<Vec2> circle() {
  constexpr int kPoints = 48;
  std::vector<Vec2> places;
  for (int i = 0; i <= kPoints; ++i) {
    const float angle = 2.0F * kPiF * static_cast<float>(i % kPoints) / static_cast<float>(kPoints);
    places.emplace_back(std::cos(angle), std::sin(angle));
  }
  return places;
}

/// Half width and height of where a light ends, with its soft edge.
Vec2 outer_size(const Vec3& barn) {
  return glm::max(Vec2(barn) + std::max(barn.z, 0.0F), Vec2(kLeastBarn));
}

/// Where a cutoff is held.
float held_at(float distance, float reach) {
  return std::clamp(distance, kNearest * reach, kFarthest * reach);
}

}  // namespace

LightShape shape_of(const Light& light) {
  const ParamSchema& schema = light.params.schema();
  LightShape shape;
  const auto barn = schema.by_role("shape");
  if (barn && schema[*barn].components() == 3) shape.barn = light.params.vec3(*barn);
  const std::vector<int> both = cutoffs(schema);
  if (both.size() > 1) shape.near_cutoff = pair_of(light.params, both.front());
  if (!both.empty()) shape.far_cutoff = pair_of(light.params, both.back());
  return shape;
}

std::vector<std::string> shape_assignments(const Light& light, const LightShape& now, const LightShape& before) {
  const ParamSchema& schema = light.params.schema();
  std::vector<std::string> result;
  const auto barn = schema.by_role("shape");
  if (barn && now.barn && now.barn != before.barn) assign(light, *barn, *now.barn, result);
  const std::vector<int> both = cutoffs(schema);
  if (both.size() > 1 && now.near_cutoff && now.near_cutoff != before.near_cutoff) {
    assign(light, both.front(), *now.near_cutoff, result);
  }
  if (!both.empty() && now.far_cutoff && now.far_cutoff != before.far_cutoff) {
    assign(light, both.back(), *now.far_cutoff, result);
  }
  return result;
}

std::string shape_words(const LightShape& shape, ShapePart part) {
  switch (part) {
    case ShapePart::kRight:
    case ShapePart::kLeft:
      return fmt::format("width {:.2f}", shape.barn.value_or(Vec3(0.0F)).x);
    case ShapePart::kUp:
    case ShapePart::kDown:
      return fmt::format("height {:.2f}", shape.barn.value_or(Vec3(0.0F)).y);
    case ShapePart::kNear:
      return fmt::format("light from {:.2f}", shape.near_cutoff.value_or(Vec2(0.0F)).x);
    default:
      return fmt::format("light up to {:.2f}", shape.far_cutoff.value_or(Vec2(0.0F)).x);
  }
}

std::vector<ShapeHandle> shape_handles(const LightPose& pose, const LightShape& shape, float reach) {
  std::vector<ShapeHandle> handles;
  const Vec3 axis = pose.direction.value_or(Vec3(1.0F, 0.0F, 0.0F));
  if (pose.direction && shape.barn) {
    Vec3 right;
    Vec3 up;
    light_frame(axis, right, up);
    const Vec3 middle = pose.position + reach * axis;
    const Vec2 barn = outer_size(*shape.barn);
    handles.push_back({ShapePart::kRight, middle + reach * barn.x * right, right});
    handles.push_back({ShapePart::kLeft, middle - reach * barn.x * right, -right});
    handles.push_back({ShapePart::kUp, middle + reach * barn.y * up, up});
    handles.push_back({ShapePart::kDown, middle - reach * barn.y * up, -up});
  }
  const auto cutoff = [&](ShapePart part, const std::optional<Vec2>& value) {
    if (value) handles.push_back({part, pose.position + held_at(value->x, reach) * axis, axis});
  };
  cutoff(ShapePart::kNear, shape.near_cutoff);
  cutoff(ShapePart::kFar, shape.far_cutoff);
  return handles;
}

LightShape dragged_shape(const LightShape& shape, ShapePart part, float length, float reach) {
  LightShape next = shape;
  const auto wider = [&](float& size) { size = std::max(kLeastBarn, size + length / reach); };
  switch (part) {
    case ShapePart::kRight:
    case ShapePart::kLeft:
      wider(next.barn->x);
      break;
    case ShapePart::kUp:
    case ShapePart::kDown:
      wider(next.barn->y);
      break;
    case ShapePart::kNear:
      next.near_cutoff->x = std::max(0.0F, held_at(shape.near_cutoff->x, reach) + length);
      break;
    case ShapePart::kFar:
      next.far_cutoff->x = std::max(0.0F, held_at(shape.far_cutoff->x, reach) + length);
      break;
  }
  return next;
}

std::vector<Vec3> barn_ring(const LightPose& pose, const LightShape& shape, float distance) {
  std::vector<Vec3> ring;
  if (!pose.direction || !shape.barn) return ring;
  Vec3 right;
  Vec3 up;
  light_frame(*pose.direction, right, up);
  const Vec2 size = outer_size(*shape.barn);
  // |x / w|^4 + |y / h|^4 = 1, as the barn's superellipse has it.
  const auto root = [](float v) { return std::copysign(std::sqrt(std::abs(v)), v); };
  for (const Vec2& round : circle()) {
    const Vec2 place = Vec2(root(round.x), root(round.y)) * size;
    ring.push_back(pose.position + distance * (*pose.direction + place.x * right + place.y * up));
  }
  return ring;
}

std::vector<Vec3> cutoff_ring(const LightPose& pose, const LightShape& shape, float distance) {
  std::vector<Vec3> ring = barn_ring(pose, shape, 1.0F);
  if (ring.empty()) {
    for (const Vec2& round : circle()) ring.push_back(pose.position + Vec3(round.x, 0.0F, round.y));
  }
  for (Vec3& point : ring) point = pose.position + distance * glm::normalize(point - pose.position);
  return ring;
}

std::optional<float> slid(const Camera& camera, const Vec3& point, const Vec3& way, const Vec2& pixels, int width,
                          int height) {
  constexpr float kStep = 1e-2F;  // of the distance to the eye
  constexpr float kLeastForeshortening = 0.1F;
  const float distance = glm::length(point - camera.position());
  const float step = kStep * distance;
  const auto from = project(camera, point, width, height);
  const auto to = project(camera, point + step * way, width, height);
  if (!from || !to) return std::nullopt;
  const Vec2 along = (*to - *from) / step;  // pixels a world length
  const float most = static_cast<float>(height) / (2.0F * distance * std::tan(0.5F * camera.fov_y));
  if (glm::length(along) < kLeastForeshortening * most) return std::nullopt;
  return glm::dot(pixels, along) / glm::dot(along, along);
}

}  // namespace luminist
