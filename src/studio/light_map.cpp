#include "studio/light_map.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "studio/drawing.h"

namespace luminist {
namespace {

constexpr float kWidest = 6.0F;  // scene radii

/// World to pixels.
struct Projection {
  Vec3 center{0.0F};
  Vec3 right{1.0F, 0.0F, 0.0F};
  Vec3 up{0.0F, 1.0F, 0.0F};
  float pixels = 1.0F;  // per world length
  int width = 1;
  int height = 1;

  [[nodiscard]] DrawPoint at(const Vec3& world) const {
    const Vec3 from = world - center;
    const auto w = static_cast<float>(width);
    const auto h = static_cast<float>(height);
    return {std::clamp(0.5F * w + pixels * glm::dot(from, right), 0.0F, w),
            std::clamp(0.5F * h - pixels * glm::dot(from, up), 0.0F, h)};
  }
};

Projection projection(const SurfaceBuffer& surface, const MapScale& scale, MapView view, int width, int height) {
  Vec3 ahead = scale.frame.center - surface.eye;
  ahead.y = 0.0F;
  const float length = glm::length(ahead);
  ahead = length > 0.0F ? ahead / length : Vec3(0.0F, 0.0F, -1.0F);
  const Vec3 up(0.0F, 1.0F, 0.0F);
  const bool above = view == MapView::kAbove;
  return {scale.frame.center,
          above ? glm::cross(ahead, up) : ahead,
          above ? ahead : up,
          0.45F * static_cast<float>(std::min(width, height)) / scale.extent,
          width,
          height};
}

void draw_surface(Drawing& drawing, const SurfaceBuffer& surface, const Projection& map) {
  constexpr int kDots = 8000;
  constexpr double kGoldenRatio = 0.6180339887498949;  // its multiples are spread evenly
  for (int k = 0; k < kDots; ++k) {
    const double share = k * kGoldenRatio;
    const auto i = static_cast<std::size_t>((share - std::floor(share)) * static_cast<double>(surface.pixels()));
    if (surface.object[i] == 0) continue;
    const DrawPoint at = map.at(surface.position[i]);
    drawing.fill(static_cast<int>(at.x), static_cast<int>(at.y), 1, 1, rgb8(105, 105, 108));
  }
}

void draw_camera(Drawing& drawing, const SurfaceBuffer& surface, const Projection& map) {
  const DrawPoint eye = map.at(surface.eye);
  const DrawPoint center = map.at(map.center);
  const float length = std::max(1.0F, std::hypot(center.x - eye.x, center.y - eye.y));
  const float x = 12.0F * (center.x - eye.x) / length;
  const float y = 12.0F * (center.y - eye.y) / length;
  const Vec3 ink = rgb8(150, 150, 150);
  drawing.line(eye, {eye.x + x - 0.4F * y, eye.y + y + 0.4F * x}, 1.5F, ink);
  drawing.line(eye, {eye.x + x + 0.4F * y, eye.y + y - 0.4F * x}, 1.5F, ink);
}

/// As bright as can be, so that dim lights show their hue.
Vec3 hue(const Light& light) {
  const std::optional<int> color = light.params.schema().by_role("color");
  const Vec3 value = color ? glm::max(light.params.vec3(*color), Vec3(0.0F)) : Vec3(1.0F);
  const float most = largest(value);
  return most > 0.0F && std::isfinite(most) ? value / most : Vec3(0.05F);
}

void draw_light(Drawing& drawing, const Light& light, const Projection& map) {
  const std::optional<int> position = light.params.schema().by_role("position");
  const std::optional<int> direction = light.params.schema().by_role("direction");
  if (light.muted || (!position && !direction)) return;
  // A light without a place stands where it shines from, at the border.
  Vec3 place = map.center;
  if (direction) place -= 1e3F / map.pixels * light.params.vec3(*direction);
  if (position) place = light.params.vec3(*position);
  const DrawPoint at = map.at(place);
  const Vec3 color = hue(light);
  const float length = 0.2F * static_cast<float>(std::min(map.width, map.height)) / map.pixels;
  if (direction) drawing.line(at, map.at(place + length * light.params.vec3(*direction)), 1.5F, color);
  drawing.line(at, at, 9.0F, color);
  const int width = text_width(light.name, 1);
  const int x = std::clamp(static_cast<int>(at.x) + 7, 0, std::max(0, map.width - width - 2));
  const int y = std::clamp(static_cast<int>(at.y) - text_height(1) - 3, 0, std::max(0, map.height - text_height(1)));
  drawing.text(x, y, light.name, 1, rgb8(225, 225, 222));
}

}  // namespace

MapScale map_scale(std::span<const LightRig* const> rigs, const SceneFrame& frame) {
  MapScale scale{frame, 1.2F * frame.radius};
  for (const LightRig* rig : rigs) {
    for (const Light& light : rig->lights) {
      const std::optional<int> position = light.params.schema().by_role("position");
      if (!position || light.muted) continue;
      const Vec3 from = glm::abs(light.params.vec3(*position) - frame.center);
      const float far = std::max(std::hypot(from.x, from.z), from.y);
      if (std::isfinite(far)) scale.extent = std::max(scale.extent, std::min(far, kWidest * frame.radius));
    }
  }
  return scale;
}

Image light_map(const LightRig& rig, const SurfaceBuffer& surface, const MapScale& scale, MapView view, int width,
                int height) {
  Image image(width, height, 3);
  Drawing drawing(image);
  drawing.fill(0, 0, width, height, rgb8(24, 24, 26));
  const Projection map = projection(surface, scale, view, width, height);
  draw_surface(drawing, surface, map);
  draw_camera(drawing, surface, map);
  for (const Light& light : rig.lights) draw_light(drawing, light, map);
  return image;
}

}  // namespace luminist
