#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "app/brush_widgets.h"
#include "app/icons.h"
#include "app/panels.h"

namespace luminist {
namespace {

void palette(Desk& desk) {
  std::vector<Vec3>& colors = desk.box.palette();
  const float side = desk.theme.px(20.0F);
  const float gap = desk.theme.px(4.0F);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const Vec3& c = colors[i];
    const Vec3 tint = c / std::max({c.x, c.y, c.z, 1.0F});
    const ImVec4 shown(srgb_from_linear(tint.x), srgb_from_linear(tint.y), srgb_from_linear(tint.z), 1.0F);
    if (ImGui::ColorButton("##color", shown, ImGuiColorEditFlags_NoTooltip, {side, side})) desk.box.set_color(c);
    tip(desk.theme, fmt::format("{:.2f}, {:.2f}, {:.2f}. Right click: take it out.", c.x, c.y, c.z).c_str());
    const bool gone = ImGui::IsItemClicked(ImGuiMouseButton_Right);
    ImGui::PopID();
    if (gone) {
      colors.erase(colors.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
    ImGui::SameLine(0.0F, gap);
    if (ImGui::GetCursorScreenPos().x + side > right) ImGui::NewLine();
  }
  if (icon_button(desk.theme, "keep", Icon::kPlus, side, false, "Keep the colour here.")) {
    colors.push_back(desk.box.color());
  }
}

void colors(Desk& desk) {
  Vec3 color = desk.box.color();
  color_field(desk.theme, "front", color, 16.0F, ImGui::GetContentRegionAvail().x - desk.theme.px(50.0F));
  desk.box.set_color(color);
  ImGui::SameLine(0.0F, desk.theme.px(6.0F));
  const Vec3& other = desk.box.other_color();
  const ImVec4 shown(srgb_from_linear(other.x), srgb_from_linear(other.y), srgb_from_linear(other.z), 1.0F);
  if (ImGui::ColorButton("##other", shown, ImGuiColorEditFlags_NoTooltip,
                         {desk.theme.px(44.0F), ImGui::GetFrameHeight()})) {
    desk.box.swap_colors();
  }
  tip(desk.theme, desk.with_key("Swap colours", Deed::kSwapColors).c_str());
  palette(desk);
}

void importance(Desk& desk) {
  for (const bool first : {true, false}) {
    float value = first ? desk.now->nu : desk.now->delta;
    const char* label = first ? "Unpainted ν" : "History δ";
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    tip(desk.theme, first ? "How much the places count that were never painted: 0 not at all, 1 as much as paint."
                          : "How much of what counted before the last accepted solve goes on counting.");
    ImGui::SameLine(desk.theme.px(84.0F));
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::PushID(label);
    ImGuiStorage& held = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("held");
    const bool holding = held.GetBool(ImGui::GetID("holding"));
    if (holding) value = held.GetFloat(id);
    ImGui::SliderFloat("##value", &value, 0.0F, 1.0F, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    held.SetFloat(id, value);
    held.SetBool(ImGui::GetID("holding"), ImGui::IsItemActive());
    if (ImGui::IsItemDeactivatedAfterEdit()) {
      const float nu = first ? value : desk.now->nu;
      const float delta = first ? desk.now->delta : value;
      desk.studio->act(
          "importance", [nu, delta](Session& session) { return session.set_importance(nu, delta); },
          Workbench::After::kFollow);
    }
    ImGui::PopID();
  }
}

void steady(Desk& desk) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Steady");
  tip(desk.theme, "Steadies the hand: the stroke trails behind the pointer.");
  ImGui::SameLine(desk.theme.px(84.0F));
  ImGui::SetNextItemWidth(-1.0F);
  float steady = 100.0F * desk.box.steadiness();
  if (ImGui::SliderFloat("##steady", &steady, 0.0F, 100.0F, "%.0f %%", ImGuiSliderFlags_AlwaysClamp)) {
    desk.box.steadiness() = 0.01F * steady;
  }
  ImGui::PushFont(desk.theme.small);
  ImGui::TextDisabled("%s", desk.pen.c_str());
  ImGui::PopFont();
  tip(desk.theme,
      "How hard a pen presses makes the brush smaller or larger, up to its size. A mouse always presses fully.");
}

void copy_from(Desk& desk) {
  Brush& brush = desk.box.brush();
  const std::string name = std::filesystem::path(brush.copy_from).filename().string();
  if (ImGui::Button(name.empty() ? "Choose an image..." : name.c_str(), {-1.0F, 0.0F})) desk.ask(Question::kImage);
  quality_tip(desk.theme, brush_quality("copy_from"));
}

}  // namespace

void tool_strip(Desk& desk) {
  static constexpr std::array<Deed, kTools> keys = {
      Deed::kToolLight, Deed::kNone,      Deed::kNone,           Deed::kToolShadow, Deed::kNone,
      Deed::kNone,      Deed::kToolErase, Deed::kToolImportance, Deed::kToolPick,   Deed::kToolEdit};
  for (int i = 0; i < kTools; ++i) {
    const auto tool = static_cast<Tool>(i);
    const ToolFacts& facts = facts_of(tool);
    const std::string name = keys[static_cast<std::size_t>(i)] == Deed::kNone
                                 ? facts.name
                                 : desk.with_key(facts.name, keys[static_cast<std::size_t>(i)]);
    if (icon_button(desk.theme, facts.name, icon_of(tool), desk.theme.px(34.0F), desk.box.tool() == tool,
                    (name + "\n" + facts.doc).c_str())) {
      desk.box.take(tool);
    }
  }
}

void brush_panel(Desk& desk) {
  if (!desk.has_shot()) return;
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted(facts_of(desk.box.tool()).name);
  ImGui::PopFont();
  ImGui::PushFont(desk.theme.small);
  ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
  ImGui::TextWrapped("%s", facts_of(desk.box.tool()).doc);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  ImGui::Spacing();
  if (desk.box.tool() == Tool::kLight || desk.box.tool() == Tool::kPick) {
    colors(desk);
    ImGui::Spacing();
  }
  if (desk.box.tool() == Tool::kCopy) copy_from(desk);
  if (desk.box.tool() != Tool::kPick) brush_settings(desk, desk.box.brush()), steady(desk);
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted("What counts");
  ImGui::PopFont();
  importance(desk);
  if (desk.now->any_paint && ImGui::Button("Clear the paint", {-1.0F, 0.0F})) {
    desk.studio->act("clear the paint", [](Session& session) { return session.clear_paint(); });
  }
}

}  // namespace luminist
