#include "paint/layer_stack.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "paint/open_stroke.h"

namespace luminist {
namespace {

Error wrong(std::string what, std::string field) {
  return {ErrorKind::kBadContent, std::move(what), "", std::move(field), ""};
}

/// Whether the circles of a brush along its way hold a place.
bool touches(const Stroke& stroke, const Vec2& place) {
  const std::vector<StrokePoint>& points = stroke.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const StrokePoint& a = points[i];
    const StrokePoint& b = points[std::min(i + 1, points.size() - 1)];
    const Vec2 from(a.x, a.y);
    const Vec2 along = Vec2(b.x, b.y) - from;
    const float squared = glm::dot(along, along);
    const float t = squared > 0.0F ? std::clamp(glm::dot(place - from, along) / squared, 0.0F, 1.0F) : 0.0F;
    const float radius = 0.5F * stroke.brush.diameter * glm::mix(a.pressure, b.pressure, t);
    if (glm::length(place - from - t * along) <= radius) return true;
  }
  return false;
}

bool covers(const Stroke& stroke, const SurfaceBuffer& surface, const Vec2& place, std::size_t pixel) {
  if (!stroke.brush.bucket && !touches(stroke, place)) return false;
  const auto mask = clip_mask(stroke, surface);
  return mask && (mask->empty() || (*mask)[surface.object[pixel]]);
}

}  // namespace

std::size_t LayerStack::lowest_shown() const {
  std::size_t layer = 0;
  while (layer < layers.size() && !shows(layer)) ++layer;
  return layer;
}

bool LayerStack::lies_flat() const {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (i != active && shows(i) && !layers[i].strokes.empty()) return false;
  }
  return layers[active].visible && layers[active].opacity == 1.0F && (!ground || active == lowest_shown());
}

std::optional<std::size_t> LayerStack::find_layer(const std::string& name) const {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].name == name) return i;
  }
  return std::nullopt;
}

std::optional<std::size_t> LayerStack::layer_of(std::uint32_t stroke) const {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const std::vector<std::uint32_t>& held = layers[i].strokes;
    if (std::find(held.begin(), held.end(), stroke) != held.end()) return i;
  }
  return std::nullopt;
}

std::string LayerStack::unused_name() const {
  for (std::size_t number = layers.size() + 1;; ++number) {
    std::string name = fmt::format("Layer {}", number);
    if (!find_layer(name)) return name;
  }
}

Result<void> check_stack(const LayerStack& stack) {
  std::size_t held = 0;
  for (std::size_t i = 0; i < stack.layers.size(); ++i) {
    const PaintLayer& layer = stack.layers[i];
    const std::string field = fmt::format("layers[{}]", i);
    if (layer.name.empty() || layer.name.size() > 255) return wrong("a layer has a name of 1 to 255 characters", field);
    if (stack.find_layer(layer.name) != i) return wrong(fmt::format("two layers are called \"{}\"", layer.name), field);
    if (!(layer.opacity >= 0.0F && layer.opacity <= 1.0F)) return wrong("an opacity lies in [0,1]", field);
    for (const std::uint32_t number : layer.strokes) {
      if (!stack.strokes.contains(number)) return wrong(fmt::format("there is no stroke {}", number), field);
      if (stack.layer_of(number) != i) return wrong(fmt::format("stroke {} is in two layers", number), field);
    }
    held += layer.strokes.size();
  }
  if (stack.layers.empty() || held != stack.strokes.size()) return wrong("every stroke is in one layer", "layers");
  for (const auto& [number, kept] : stack.strokes) {
    if (auto good = check_stroke(kept->stroke); !good) {
      Error error = std::move(good).error();
      error.field = fmt::format("strokes[{}].{}", number, error.field);
      return error;
    }
  }
  return {};
}

Result<void> check_paintable(const LayerStack& stack) {
  if (stack.shows(stack.active)) return {};
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" is hidden", stack.layers[stack.active].name), "", "layer",
               "show the layer to paint on it"};
}

std::vector<std::uint32_t> strokes_under(const LayerStack& stack, const SurfaceBuffer& surface, const Vec2& place) {
  std::vector<std::uint32_t> found;
  const int x = static_cast<int>(std::floor(place.x * static_cast<float>(surface.height)));
  const int y = static_cast<int>(std::floor(place.y * static_cast<float>(surface.height)));
  if (x < 0 || y < 0 || x >= surface.width || y >= surface.height) return found;
  const std::size_t pixel = surface.index(x, y);
  for (std::size_t i = stack.layers.size(); i-- > 0;) {
    if (!stack.shows(i)) continue;
    const std::vector<std::uint32_t>& held = stack.layers[i].strokes;
    for (auto number = held.rbegin(); number != held.rend(); ++number) {
      if (covers(stack.strokes.at(*number)->stroke, surface, place, pixel)) found.push_back(*number);
    }
  }
  return found;
}

}  // namespace luminist
