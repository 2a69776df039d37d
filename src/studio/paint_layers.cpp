#include "studio/paint_layers.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "project/layer_document.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

Error refused(std::string what, std::string field, std::string hint) {
  return {ErrorKind::kUsage, std::move(what), "", std::move(field), std::move(hint)};
}

Result<std::size_t> find(const LayerStack& stack, const std::string& name) {
  if (const auto found = stack.find_layer(name)) return *found;
  std::vector<std::string> names;
  for (const PaintLayer& layer : stack.layers) names.push_back(layer.name);
  const std::string near = nearest_name(name, names);
  return refused(
      fmt::format("there is no layer \"{}\"", name), "layer",
      near.empty() ? fmt::format("there are: {}", fmt::join(names, ", ")) : fmt::format("did you mean \"{}\"?", near));
}

Result<std::size_t> layer_of(const LayerStack& stack, std::uint32_t stroke) {
  if (const auto found = stack.layer_of(stroke)) return *found;
  return refused(fmt::format("there is no stroke {} to be changed", stroke), "stroke",
                 stack.ground ? "paint whose strokes are not known can only be cleared" : "");
}

Result<void> check_name(const LayerStack& stack, const std::string& name) {
  if (name.empty() || name.size() > 255) return refused("a layer has a name of 1 to 255 characters", "name", "");
  if (!stack.find_layer(name)) return {};
  return refused(fmt::format("there is a layer \"{}\" already", name), "name", "choose another name");
}

KeptStroke& change(LayerStack& stack, std::uint32_t stroke, std::shared_ptr<KeptStroke>& copy) {
  copy = std::make_shared<KeptStroke>(*stack.strokes.at(stroke));
  stack.strokes[stroke] = copy;
  return *copy;
}

/// The opacity of a layer becomes that of its strokes.
void bake_opacity(LayerStack& stack, PaintLayer& layer) {
  if (layer.opacity == 1.0F) return;
  for (const std::uint32_t stroke : layer.strokes) {
    std::shared_ptr<KeptStroke> copy;
    change(stack, stroke, copy).stroke.brush.opacity *= layer.opacity;
  }
  layer.opacity = 1.0F;
}

}  // namespace

PaintLayers Session::layers() {
  return PaintLayers(*this);
}

Result<LayerStack> PaintLayers::stack() const {
  LUM_TRY(LayerStack stack, read_stack(session_->project_.document()));
  stack.active = stack.find_layer(session_->layer_).value_or(stack.layers.size() - 1);
  return stack;
}

Result<LayerStack> PaintLayers::layers() {
  LUM_TRY(const Canvas* canvas, session_->canvas());
  return canvas->state().layers;
}

Result<void> PaintLayers::commit(const std::string& label, const std::string& action, LayerStack next,
                                 const std::string& path) {
  LUM_TRY(Canvas * canvas, session_->canvas());
  const std::string chosen = next.layers[next.active].name;
  LUM_TRY_VOID(canvas->relayer(std::move(next), std::filesystem::path(path).parent_path().string()));
  LUM_TRY_VOID(session_->commit_canvas(label, action, canvas->state()));
  session_->layer_ = chosen;
  return {};
}

Result<void> PaintLayers::choose(const std::string& layer) {
  LUM_TRY(const LayerStack stack, this->stack());
  LUM_TRY(const std::size_t index, find(stack, layer));
  session_->layer_ = layer;
  if (session_->canvas_) session_->canvas_->choose_layer(index);
  return {};
}

Result<std::string> PaintLayers::add(const std::string& name) {
  LUM_TRY(LayerStack next, layers());
  const std::string called = name.empty() ? next.unused_name() : name;
  LUM_TRY_VOID(check_name(next, called));
  ++next.active;
  next.layers.insert(next.layers.begin() + static_cast<std::ptrdiff_t>(next.active), PaintLayer{.name = called});
  LUM_TRY_VOID(commit("Add layer " + called, Json{{"do", "layer"}, {"name", called}}.dump(), std::move(next)));
  return called;
}

Result<void> PaintLayers::remove(const std::string& layer) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t index, find(next, layer));
  if (next.layers.size() == 1) return refused("a painting has a layer", "layer", "clear the paint instead");
  for (const std::uint32_t stroke : next.layers[index].strokes) next.strokes.erase(stroke), next.counts.erase(stroke);
  next.layers.erase(next.layers.begin() + static_cast<std::ptrdiff_t>(index));
  if (next.active > index || next.active == next.layers.size()) --next.active;
  return commit("Remove layer " + layer, Json{{"do", "remove_layer"}, {"name", layer}}.dump(), std::move(next));
}

Result<void> PaintLayers::rename(const std::string& layer, const std::string& name) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t index, find(next, layer));
  if (name == layer) return {};
  LUM_TRY_VOID(check_name(next, name));
  next.layers[index].name = name;
  return commit(fmt::format("Layer {} is called {}", layer, name),
                Json{{"do", "layer"}, {"name", layer}, {"rename", name}}.dump(), std::move(next));
}

Result<void> PaintLayers::set_visible(const std::string& layer, bool visible) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t index, find(next, layer));
  next.layers[index].visible = visible;
  return commit((visible ? "Show layer " : "Hide layer ") + layer,
                Json{{"do", "layer"}, {"name", layer}, {"visible", visible}}.dump(), std::move(next));
}

Result<void> PaintLayers::set_opacity(const std::string& layer, float opacity) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t index, find(next, layer));
  if (!(opacity >= 0.0F && opacity <= 1.0F)) return refused("an opacity lies between 0 and 1", "opacity", "");
  next.layers[index].opacity = opacity;
  return commit(fmt::format("Opacity of {} {:.0f} %", layer, 100.0F * opacity),
                Json{{"do", "layer"}, {"name", layer}, {"opacity", opacity}}.dump(), std::move(next));
}

Result<void> PaintLayers::place(const std::string& layer, std::size_t place) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t index, find(next, layer));
  const std::string active = next.layers[next.active].name;
  PaintLayer moved = std::move(next.layers[index]);
  next.layers.erase(next.layers.begin() + static_cast<std::ptrdiff_t>(index));
  const std::size_t to = std::min(place, next.layers.size());
  next.layers.insert(next.layers.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
  next.active = *next.find_layer(active);
  return commit("Move layer " + layer, Json{{"do", "layer"}, {"name", layer}, {"place", to}}.dump(), std::move(next));
}

Result<void> PaintLayers::merge_down(const std::string& layer) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t index, find(next, layer));
  if (index == 0) return refused("there is no layer below it", "layer", "");
  PaintLayer& below = next.layers[index - 1];
  PaintLayer& above = next.layers[index];
  if (!next.shows(index) || !next.shows(index - 1)) return refused("one of the two is hidden", "layer", "show both");
  const bool paint_below = !below.strokes.empty() || (next.ground && index - 1 == next.lowest_shown());
  for (const std::uint32_t stroke : above.strokes) {
    if (next.strokes.at(stroke)->stroke.brush.tool != PaintTool::kErase || !paint_below) continue;
    return refused(fmt::format("stroke {} would erase what is painted on {}", stroke, below.name), "layer",
                   "delete that stroke, or leave the layers apart");
  }
  bake_opacity(next, below);
  bake_opacity(next, above);
  below.strokes.insert(below.strokes.end(), above.strokes.begin(), above.strokes.end());
  if (next.active >= index) --next.active;
  next.layers.erase(next.layers.begin() + static_cast<std::ptrdiff_t>(index));
  return commit("Merge layer " + layer, Json{{"do", "merge_layer"}, {"name", layer}}.dump(), std::move(next));
}

Result<void> PaintLayers::set_brush(std::uint32_t stroke, const Brush& brush, const std::string& path) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY_VOID(layer_of(next, stroke));
  std::shared_ptr<KeptStroke> copy;
  KeptStroke& kept = change(next, stroke, copy);
  const Brush before = std::exchange(kept.stroke.brush, brush);
  if (before.tool != brush.tool || before.copy_from != brush.copy_from) kept.source.reset();
  Json action = Json::parse(brush_changes(before, brush));
  if (action.empty()) return {};
  action["do"] = "edit_stroke";
  action["stroke"] = stroke;
  return commit(fmt::format("Change stroke {}", stroke), action.dump(), std::move(next), path);
}

Result<void> PaintLayers::move(std::uint32_t stroke, const Vec2& by) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY_VOID(layer_of(next, stroke));
  std::shared_ptr<KeptStroke> copy;
  for (StrokePoint& point : change(next, stroke, copy).stroke.points) point.x += by.x, point.y += by.y;
  return commit(fmt::format("Move stroke {}", stroke),
                Json{{"do", "move_stroke"}, {"stroke", stroke}, {"by", {by.x, by.y}}}.dump(), std::move(next));
}

Result<void> PaintLayers::place_stroke(std::uint32_t stroke, const std::string& layer, std::size_t place) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t from, layer_of(next, stroke));
  LUM_TRY(const std::size_t to, find(next, layer));
  std::erase(next.layers[from].strokes, stroke);
  std::vector<std::uint32_t>& strokes = next.layers[to].strokes;
  const std::size_t at = std::min(place, strokes.size());
  strokes.insert(strokes.begin() + static_cast<std::ptrdiff_t>(at), stroke);
  const Json action = {{"do", "move_stroke"}, {"stroke", stroke}, {"layer", layer}, {"place", at}};
  return commit(from == to ? fmt::format("Reorder stroke {}", stroke) : fmt::format("Stroke {} to {}", stroke, layer),
                action.dump(), std::move(next));
}

Result<void> PaintLayers::remove_stroke(std::uint32_t stroke) {
  LUM_TRY(LayerStack next, layers());
  LUM_TRY(const std::size_t from, layer_of(next, stroke));
  std::erase(next.layers[from].strokes, stroke);
  next.strokes.erase(stroke);
  next.counts.erase(stroke);
  return commit(fmt::format("Delete stroke {}", stroke), Json{{"do", "delete_stroke"}, {"stroke", stroke}}.dump(),
                std::move(next));
}

}  // namespace luminist
