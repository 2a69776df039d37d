// Layers of paint and the strokes in them.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/brush_widgets.h"
#include "app/canvas_panel.h"
#include "app/icons.h"
#include "app/panels.h"
#include "studio/paint_layers.h"

namespace luminist {
namespace {

template <class Act>
void post(Desk& desk, const char* label, Act act) {
  desk.studio->repaint(label, [act](Session& session) -> Result<void> {
    PaintLayers layers = session.layers();
    return act(layers);
  });
}

void choose(Desk& desk, const std::string& layer) {
  post(desk, "choose a layer", [layer](PaintLayers& layers) { return layers.choose(layer); });
}

/// What became of a stroke in the last verdict, or null.
const StrokeVerdict* verdict_of(const Desk& desk, std::uint32_t number) {
  if (!desk.now->verdict) return nullptr;
  const auto& strokes = desk.now->verdict->strokes;
  const auto found =
      std::find_if(strokes.begin(), strokes.end(), [&](const auto& each) { return each.stroke == number; });
  return found == strokes.end() ? nullptr : &*found;
}

const char* tool_name(PaintTool tool) {
  for (int i = 0; i < kTools; ++i) {
    if (facts_of(static_cast<Tool>(i)).paint == tool) return facts_of(static_cast<Tool>(i)).name;
  }
  return "";
}

/// "3  Light on jug"
std::string title_of(const Desk& desk, std::uint32_t number, const Stroke& stroke) {
  std::string object = stroke.brush.clip;
  if (object == "@") {
    const StrokePoint& first = stroke.points.front();
    object = object_at(*desk.now->facts, desk.view.picture_size().y * Vec2(first.x, first.y));
  }
  const std::string tool =
      stroke.brush.bucket ? fmt::format("{} bucket", tool_name(stroke.brush.tool)) : tool_name(stroke.brush.tool);
  return fmt::format("{}  {}{}", number, tool, object.empty() ? "" : " on " + object);
}

void heading(const Desk& desk, const char* text) {
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

/// Buttons that act on the layer that is painted on.
void layer_buttons(Desk& desk) {
  const Theme& theme = desk.theme;
  const LayerStack& stack = *desk.now->layers;
  const std::string name = stack.layers[stack.active].name;
  const std::size_t place = stack.active;
  const float side = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 5.0F * side);
  if (icon_button(theme, "add layer", Icon::kPlus, side, false, "Add a layer above this one, and paint on it.")) {
    post(desk, "add a layer", [](PaintLayers& layers) -> Result<void> {
      LUM_TRY_VOID(layers.add());
      return {};
    });
  }
  ImGui::SameLine(0.0F, 0.0F);
  if (icon_button(theme, "layer up", Icon::kUp, side, false, "Move the layer up.") && place + 1 < stack.layers.size()) {
    post(desk, "move a layer", [=](PaintLayers& layers) { return layers.place(name, place + 1); });
  }
  ImGui::SameLine(0.0F, 0.0F);
  if (icon_button(theme, "layer down", Icon::kDown, side, false, "Move the layer down.") && place > 0) {
    post(desk, "move a layer", [=](PaintLayers& layers) { return layers.place(name, place - 1); });
  }
  ImGui::SameLine(0.0F, 0.0F);
  if (icon_button(theme, "merge layer", Icon::kMerge, side, false,
                  "Merge it into the layer below. Its strokes stay strokes, and take over its opacity.")) {
    post(desk, "merge layers", [=](PaintLayers& layers) { return layers.merge_down(name); });
  }
  ImGui::SameLine(0.0F, 0.0F);
  if (icon_button(theme, "remove layer", Icon::kTrash, side, false, "Remove the layer with its strokes.")) {
    post(desk, "remove a layer", [=](PaintLayers& layers) { return layers.remove(name); });
  }
}

void swatch(const Desk& desk, const Brush& brush) {
  const float side = desk.theme.px(14.0F);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float down = 0.5F * (ImGui::GetFrameHeight() - side);
  const Vec3 tint = brush.color / std::max({brush.color.x, brush.color.y, brush.color.z, 1.0F});
  const bool colored = brush.tool == PaintTool::kColor;
  const ImU32 code = ImGui::ColorConvertFloat4ToU32(
      {srgb_from_linear(tint.x), srgb_from_linear(tint.y), srgb_from_linear(tint.z), 1.0F});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (colored) {
    list.AddRectFilled({at.x, at.y + down}, {at.x + side, at.y + down + side}, code, desk.theme.px(3.0F));
    return;
  }
  Tool tool = Tool::kLight;
  for (int i = 0; i < kTools; ++i) {
    if (facts_of(static_cast<Tool>(i)).paint == brush.tool) tool = static_cast<Tool>(i);
  }
  draw_icon(list, icon_of(tool), {at.x + 0.5F * side, at.y + 0.5F * ImGui::GetFrameHeight()}, side,
            paint_colors::kText);
}

/// The layer that a stroke is on, its place there, and the way out.
void where(Desk& desk, std::uint32_t number) {
  const Theme& theme = desk.theme;
  const LayerStack& stack = *desk.now->layers;
  const std::size_t layer = stack.layer_of(number).value_or(0);
  const std::vector<std::uint32_t>& order = stack.layers[layer].strokes;
  const auto place = static_cast<std::size_t>(std::find(order.begin(), order.end(), number) - order.begin());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Layer");
  ImGui::SameLine(theme.px(84.0F));
  ImGui::SetNextItemWidth(-1.0F);
  const auto to = [&](const std::string& name, std::size_t at) {
    post(desk, "move a stroke", [=](PaintLayers& layers) { return layers.place_stroke(number, name, at); });
  };
  if (ImGui::BeginCombo("##layer", stack.layers[layer].name.c_str())) {
    for (const PaintLayer& each : stack.layers) {
      const bool own = &each == &stack.layers[layer];
      if (ImGui::Selectable(each.name.c_str(), own) && !own) to(each.name, each.strokes.size());
    }
    ImGui::EndCombo();
  }
  tip(theme, "The layer that the stroke is on.");
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float third = (ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F;
  if (ImGui::Button("Up", {third, 0.0F}) && place + 1 < order.size()) to(stack.layers[layer].name, place + 1);
  tip(theme, "Lay it after the stroke above it.");
  ImGui::SameLine();
  if (ImGui::Button("Down", {third, 0.0F}) && place > 0) to(stack.layers[layer].name, place - 1);
  tip(theme, "Lay it before the stroke below it.");
  ImGui::SameLine();
  if (ImGui::Button("Delete", {third, 0.0F})) delete_stroke(desk);
  tip(theme, desk.with_key("The stroke goes; what it covered comes back", Deed::kDeleteStroke).c_str());
}

}  // namespace

/// A field for a name, over the layer's row.
void StrokePanel::rename_popup(Desk& desk, const std::string& layer) {
  if (!ImGui::BeginPopup("rename")) return;
  std::array<char, 256> text{};
  std::copy_n(name_.begin(), std::min(name_.size(), text.size() - 1), text.begin());
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(desk.theme.px(180.0F));
  const bool entered = ImGui::InputText("##name", text.data(), text.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  name_ = text.data();
  ImGui::SameLine();
  if (ImGui::Button("Rename") || entered) {
    post(desk, "rename a layer", [from = layer, to = name_](PaintLayers& layers) { return layers.rename(from, to); });
    ImGui::CloseCurrentPopup();
  }
  tip(desk.theme, "The layer is called so from now on, also in scripts.");
  ImGui::EndPopup();
}

void StrokePanel::layer_name(Desk& desk, std::size_t index, float width) {
  const PaintLayer& layer = desk.now->layers->layers[index];
  const bool active = index == desk.now->layers->active;
  ImGui::PushStyleColor(ImGuiCol_Text, active          ? paint_colors::kAccent
                                       : layer.visible ? paint_colors::kText
                                                       : paint_colors::kFaint);
  const std::string title = fmt::format("{}  ({})", layer.name, layer.strokes.size());
  const bool clicked = ImGui::Selectable(title.c_str(), active, ImGuiSelectableFlags_AllowDoubleClick, {width, 0.0F});
  ImGui::PopStyleColor();
  const bool twice = clicked && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (twice || ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
    name_ = layer.name;
    ImGui::OpenPopup("rename");
  } else if (clicked && !active) {
    choose(desk, layer.name);
  }
  tip(desk.theme, "Click to paint on this layer, right click to rename it. The number says how many strokes it has.");
  rename_popup(desk, layer.name);
}

void StrokePanel::layer_row(Desk& desk, std::size_t index) {
  const PaintLayer& layer = desk.now->layers->layers[index];
  const Theme& theme = desk.theme;
  const float side = ImGui::GetFrameHeight();
  const float opacity_width = theme.px(92.0F);
  ImGui::PushID(static_cast<int>(index));
  if (icon_button(theme, "eye", layer.visible ? Icon::kEye : Icon::kEyeOff, side, false,
                  layer.visible ? "Hide the layer: the lights then answer the others alone." : "Show the layer.")) {
    post(desk, "show a layer",
         [name = layer.name, shown = !layer.visible](PaintLayers& layers) { return layers.set_visible(name, shown); });
  }
  ImGui::SameLine(0.0F, theme.px(4.0F));
  ImGui::AlignTextToFramePadding();
  layer_name(desk, index, ImGui::GetContentRegionAvail().x - opacity_width - theme.px(8.0F));
  ImGui::SameLine(ImGui::GetContentRegionMax().x - opacity_width);
  ImGui::SetNextItemWidth(opacity_width);
  float shown = 100.0F * (faded_ == layer.name ? opacity_ : layer.opacity);
  if (ImGui::SliderFloat("##opacity", &shown, 0.0F, 100.0F, "%.0f %%", ImGuiSliderFlags_AlwaysClamp)) {
    faded_ = layer.name;
    opacity_ = 0.01F * shown;
  }
  if (ImGui::IsItemDeactivatedAfterEdit()) {
    post(desk, "opacity of a layer",
         [name = layer.name, opacity = opacity_](PaintLayers& layers) { return layers.set_opacity(name, opacity); });
    faded_.clear();
  }
  tip(theme, "Opacity: how strongly the layer shows over what is below it.");
  ImGui::PopID();
}

void StrokePanel::stroke_row(Desk& desk, std::uint32_t number) {
  const Stroke& stroke = desk.now->layers->strokes.at(number)->stroke;
  const Theme& theme = desk.theme;
  ImGui::PushID(static_cast<int>(number));
  const ImVec2 start = ImGui::GetCursorPos();
  const bool selected = desk.selected_stroke == number && desk.box.tool() == Tool::kEdit;
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0F, 0.5F});
  if (ImGui::Selectable("##row", selected, ImGuiSelectableFlags_AllowItemOverlap, {0.0F, ImGui::GetFrameHeight()})) {
    desk.selected_stroke = number;
    desk.box.take(Tool::kEdit);
  }
  ImGui::PopStyleVar();
  if (ImGui::IsItemHovered()) desk.pointed_stroke = number;
  const StrokeVerdict* verdict = verdict_of(desk, number);
  tip(theme, verdict != nullptr ? verdict_line(*verdict).c_str() : "Click to change the stroke (left panel).");
  const ImVec2 end = ImGui::GetCursorPos();
  ImGui::SetCursorPos({start.x + theme.px(4.0F), start.y});
  swatch(desk, stroke.brush);
  ImGui::SetCursorPos({start.x + theme.px(26.0F), start.y});
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(title_of(desk, number, stroke).c_str());
  if (verdict != nullptr) {
    const ImVec2 at = ImGui::GetWindowPos();
    const float x = at.x + ImGui::GetContentRegionMax().x - theme.px(12.0F);
    const float y = at.y + start.y - ImGui::GetScrollY() + 0.5F * ImGui::GetFrameHeight();
    ImGui::GetWindowDrawList()->AddCircleFilled({x, y}, theme.px(4.0F), outcome_color(verdict->outcome));
  }
  ImGui::SetCursorPos(end);
  ImGui::PopID();
}

void StrokePanel::list(Desk& desk) {
  const LayerStack& stack = *desk.now->layers;
  heading(desk, "Layers");
  layer_buttons(desk);
  for (std::size_t i = stack.layers.size(); i-- > 0;) layer_row(desk, i);
  ImGui::Spacing();
  const std::vector<std::uint32_t>& strokes = stack.layers[stack.active].strokes;
  heading(desk, fmt::format("Strokes of {}", stack.layers[stack.active].name).c_str());
  if (strokes.empty()) ImGui::TextDisabled("Nothing is painted on this layer.");
  for (auto number = strokes.rbegin(); number != strokes.rend(); ++number) stroke_row(desk, *number);
  if (desk.now->ground) {
    ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
    ImGui::TextWrapped(
        "Below all layers lies paint whose strokes are not known: a picture that was taken as target, or "
        "paint of an older project. It can only be erased or cleared.");
    ImGui::PopStyleColor();
  }
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  heading(desk, "Verdict");
  verdict_panel(desk);
}

/// The brush of the session's stroke, unless the hand holds another value of it.
void StrokePanel::take_up(const Desk& desk) {
  const bool answered = posted_ != nullptr && posted_ != desk.now->layers.get();
  if (held_ && !answered && stroke_ == desk.selected_stroke) return;
  stroke_ = desk.selected_stroke;
  brush_ = desk.edited_stroke()->stroke.brush;
  held_ = false;
  posted_ = nullptr;
}

void StrokePanel::settings(Desk& desk) {
  if (!desk.has_shot()) return;
  const Theme& theme = desk.theme;
  const KeptStroke* kept = desk.edited_stroke();
  heading(desk, kept != nullptr ? fmt::format("Stroke {}", desk.selected_stroke).c_str() : facts_of(Tool::kEdit).name);
  ImGui::PushFont(theme.small);
  ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
  ImGui::TextWrapped("%s", facts_of(Tool::kEdit).doc);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::Spacing();
  if (kept == nullptr) return;
  take_up(desk);
  const std::uint32_t number = desk.selected_stroke;
  bool done = false;
  if (brush_.tool == PaintTool::kColor) {
    const ColorEdit edit = color_field(theme, "stroke color", brush_.color, 16.0F, ImGui::GetContentRegionAvail().x);
    done = edit.done;
    ImGui::Spacing();
  }
  done |= brush_settings(desk, brush_);
  held_ = held_ || brush_changes(kept->stroke.brush, brush_) != "{}";
  if (done && brush_changes(kept->stroke.brush, brush_) != "{}") {
    posted_ = desk.now->layers.get();
    const std::string path = (std::filesystem::current_path() / "strokes.json").string();
    post(desk, "change a stroke",
         [=, brush = brush_](PaintLayers& layers) { return layers.set_brush(number, brush, path); });
  }
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  where(desk, number);
}

}  // namespace luminist
