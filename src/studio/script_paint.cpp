// The part of a script that works on layers and strokes.
#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "studio/paint_layers.h"
#include "studio/script_runner.h"

namespace luminist {
namespace {

Result<std::uint32_t> stroke_of(const Action& action) {
  LUM_TRY(const auto stroke, action.whole("stroke", 1));
  if (!stroke) return action.wrong("the number of a stroke is wanted", "stroke");
  return *stroke;
}

/// [across, down] in picture heights.
Result<std::optional<Vec2>> shift_of(const Action& action) {
  if (!action.has("by")) return std::optional<Vec2>{};
  LUM_TRY(const std::string text, action.value_text("by"));
  const nlohmann::json numbers = nlohmann::json::parse("[" + text + "]", nullptr, false);
  const bool pair = numbers.is_array() && numbers.size() == 2 && numbers[0].is_number() && numbers[1].is_number();
  if (!pair) return action.wrong("[across, down] is wanted, in picture heights", "by");
  return std::optional(Vec2(numbers[0].get<float>(), numbers[1].get<float>()));
}

}  // namespace

std::vector<std::string> ScriptRunner::stroke_fields() {
  std::vector<std::string> fields = {"stroke"};
  for (const BrushQuality& quality : brush_qualities()) fields.emplace_back(quality.name);
  return fields;
}

Result<void> ScriptRunner::layer(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("name"));
  LUM_TRY(const auto rename, action.text("rename"));
  LUM_TRY(const auto visible, action.flag("visible"));
  LUM_TRY(const auto opacity, action.number("opacity"));
  LUM_TRY(const auto place, action.whole("place", 0));
  PaintLayers layers = session_->layers();
  LUM_TRY(const LayerStack stack, layers.stack());
  if (stack.find_layer(name)) {
    LUM_TRY_VOID(layers.choose(name));
  } else {
    LUM_TRY_VOID(layers.add(name));
  }
  if (visible) LUM_TRY_VOID(layers.set_visible(name, *visible));
  if (opacity) LUM_TRY_VOID(layers.set_opacity(name, static_cast<float>(*opacity)));
  if (place) LUM_TRY_VOID(layers.place(name, *place));
  return rename ? layers.rename(name, *rename) : Result<void>();
}

/// "merge_layer" too.
Result<void> ScriptRunner::remove_layer(const Action& action) {
  LUM_TRY(const std::string name, action.needed_text("name"));
  return action.verb() == "remove_layer" ? session_->layers().remove(name) : session_->layers().merge_down(name);
}

Result<void> ScriptRunner::edit_stroke(const Action& action) {
  LUM_TRY(const std::uint32_t stroke, stroke_of(action));
  LUM_TRY(const LayerStack stack, session_->layers().stack());
  const auto kept = stack.strokes.find(stroke);
  if (kept == stack.strokes.end()) return action.wrong("there is no such stroke to be changed", "stroke");
  static constexpr std::array kNotOfTheBrush = {"stroke"};
  LUM_TRY(const Brush brush, parse_brush(action.rest(kNotOfTheBrush), action.where(), kept->second->stroke.brush));
  return session_->layers().set_brush(stroke, brush, (folder_ / "strokes").string());
}

Result<void> ScriptRunner::move_stroke(const Action& action) {
  LUM_TRY(const std::uint32_t stroke, stroke_of(action));
  LUM_TRY(const auto by, shift_of(action));
  LUM_TRY(const auto layer, action.text("layer"));
  LUM_TRY(const auto place, action.whole("place", 0));
  PaintLayers layers = session_->layers();
  if (by) LUM_TRY_VOID(layers.move(stroke, *by));
  if (!layer && !place) return by ? Result<void>() : action.wrong("say where to: by, layer or place", "by");
  LUM_TRY(const LayerStack stack, layers.stack());
  const auto own = stack.layer_of(stroke);
  if (!own) return action.wrong("there is no such stroke to be moved", "stroke");
  return layers.place_stroke(stroke, layer.value_or(stack.layers[*own].name), place.value_or(0xFFFFFFFFU));
}

Result<void> ScriptRunner::delete_stroke(const Action& action) {
  LUM_TRY(const std::uint32_t stroke, stroke_of(action));
  return session_->layers().remove_stroke(stroke);
}

}  // namespace luminist
