#include <algorithm>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/panels.h"
#include "studio/exploration.h"

namespace luminist {
namespace {

/// Patterns of what a light's lock turns: all of it is locked; what its type declares as solved is freed.
std::vector<std::string> lock_patterns(const Light& light, bool any_free) {
  const std::string path = "lights/" + light.name;
  if (any_free) return {path};
  std::vector<std::string> patterns;
  for (const ParamSpec& spec : light.params.schema().specs()) {
    if (spec.solve && spec.dofs() > 0) patterns.push_back(path + "/" + spec.name);
  }
  return patterns.empty() ? std::vector{path} : patterns;
}

int locked_dofs(const ParamBlock& block) {
  int locked = 0;
  for (int d = 0; d < block.schema().dofs(); ++d) locked += block.locked_by_hand(d) ? 1 : 0;
  return locked;
}

void swatch(const Desk& desk, const Light& light) {
  const auto param = light.params.schema().by_role("color");
  const Vec3 color = param ? light.params.vec3(*param) : Vec3(0.0F);
  const float most = std::max({color.x, color.y, color.z, 1.0F});
  const Vec3 shown = color / most;
  const float side = desk.theme.px(14.0F);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float down = 0.5F * (ImGui::GetFrameHeight() - side);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 code = ImGui::ColorConvertFloat4ToU32(
      {srgb_from_linear(shown.x), srgb_from_linear(shown.y), srgb_from_linear(shown.z), 1.0F});
  const ImVec2 lo(at.x, at.y + down);
  const ImVec2 hi(at.x + side, at.y + down + side);
  list.AddRectFilled(lo, hi, code, desk.theme.px(7.0F));
  list.AddRect(lo, hi, IM_COL32(120, 120, 120, 255), desk.theme.px(7.0F));
  ImGui::Dummy({side, side});
}

void toggle_solo(Desk& desk, const std::string& name) {
  if (desk.solo.erase(name) == 0) desk.solo.insert(name);
  std::vector<std::string> lights(desk.solo.begin(), desk.solo.end());
  desk.studio->post("solo", [lights](Workbench& bench) -> Result<void> {
    bench.set_solo(lights);
    return {};
  });
}

void removal(Desk& desk, const std::string& name) {
  if (!ImGui::BeginPopup("removal")) return;
  if (ImGui::MenuItem("Remove it")) {
    desk.studio->change(
        "remove a light", [name](Session& session) { return session.remove_light(name); }, Workbench::After::kFollow);
  }
  if (ImGui::MenuItem("Remove it; the others make up for it", nullptr, false, desk.now->shown->rig.lights.size() > 1)) {
    desk.studio->change("remove a light", [name](Session& session) -> Result<void> {
      LUM_TRY_VOID(start_removal(session, name, SolveOptions{}));
      return {};
    });
  }
  ImGui::EndPopup();
}

void buttons(Desk& desk, const Light& light) {
  const float side = ImGui::GetFrameHeight();
  const Theme& theme = desk.theme;
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 4.0F * side);
  const bool solo = desk.solo.contains(light.name);
  if (icon_button(theme, "solo", Icon::kSolo, side, solo, "Solo: show only this light. Nothing else changes.")) {
    toggle_solo(desk, light.name);
  }
  ImGui::SameLine(0.0F, 0.0F);
  const std::string name = light.name;
  const bool muted = light.muted;
  if (icon_button(theme, "mute", muted ? Icon::kEyeOff : Icon::kEye, side, false,
                  muted ? "Muted. Click to turn it on." : "On. Click to mute it.")) {
    desk.studio->change(
        "mute", [name, muted](Session& session) { return session.set_muted(name, !muted); }, Workbench::After::kFollow);
  }
  ImGui::SameLine(0.0F, 0.0F);
  const int locked = locked_dofs(light.params);
  const int all = light.params.schema().dofs();
  lock_button(desk, "lock", locked, all, lock_patterns(light, locked != all), side);
  ImGui::SameLine(0.0F, 0.0F);
  if (icon_button(theme, "remove", Icon::kTrash, side, false, "Remove this light.")) ImGui::OpenPopup("removal");
  removal(desk, name);
}

void light_row(Desk& desk, const Light& light) {
  ImGui::PushID(light.name.c_str());
  const bool selected = desk.selected == light.name;
  const float height = ImGui::GetFrameHeight();
  const ImVec2 start = ImGui::GetCursorPos();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
  if (ImGui::Selectable("##row", selected, ImGuiSelectableFlags_AllowItemOverlap, {0.0F, height})) {
    desk.selected = selected ? "" : light.name;
  }
  ImGui::SetItemAllowOverlap();
  ImGui::PopStyleVar();
  ImGui::SetCursorPos({start.x + desk.theme.px(4.0F), start.y});
  swatch(desk, light);
  ImGui::SameLine(desk.theme.px(36.0F));
  ImGui::SetCursorPosY(start.y);
  ImGui::AlignTextToFramePadding();
  const auto& waiting = desk.now->waiting;
  const bool waits = std::find(waiting.begin(), waiting.end(), light.name) != waiting.end();
  const ImU32 color = waits ? paint_colors::kAccent : light.muted ? paint_colors::kFaint : paint_colors::kText;
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted((light.name + (waits ? "  paint it" : "")).c_str());
  ImGui::PopStyleColor();
  ImGui::SetCursorPosY(start.y);
  buttons(desk, light);
  ImGui::SetCursorPos({start.x, start.y + height + desk.theme.px(2.0F)});
  ImGui::PopID();
}

}  // namespace

void lights_panel(Desk& desk, ParamWidgets& widgets) {
  const ParamState& shown = *desk.now->shown;
  const std::string add = desk.with_key("Add a light", Deed::kAddLight);
  if (ImGui::Button(add.c_str(), {-1.0F, 0.0F})) add_light(desk);
  tip(desk.theme,
      "A dark light that begins where you paint next. The other lights are locked, and what a solve "
      "proposes is accepted.");
  if (shown.rig.lights.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
    ImGui::TextWrapped("There is no light yet, only a dim ambient. Paint on the picture, and a light is added.");
    ImGui::PopStyleColor();
  }
  for (const Light& light : shown.rig.lights) light_row(desk, light);
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  const Light* light = shown.rig.find(desk.selected);
  if (light != nullptr) {
    ImGui::PushFont(desk.theme.strong);
    ImGui::TextUnformatted(light->name.c_str());
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("%s", light->type.c_str());
    widgets.draw(desk, light->params, "lights/" + light->name);
  } else {
    ImGui::PushFont(desk.theme.strong);
    ImGui::TextUnformatted("Ambient");
    ImGui::PopFont();
    widgets.draw(desk, shown.rig.ambient, "ambient");
    if (!shown.rig.lights.empty()) ImGui::TextDisabled("Select a light to see what it has.");
  }
}

void style_panel(Desk& desk, ParamWidgets& widgets) {
  const ShotFacts& facts = *desk.now->facts;
  ImGui::SetNextItemWidth(-1.0F);
  if (ImGui::BeginCombo("##style", facts.shot.style.c_str())) {
    for (const std::string& name : facts.styles) {
      if (!ImGui::Selectable(name.c_str(), name == facts.shot.style)) continue;
      desk.studio->change("compile the style " + name, [name](Session& session) { return session.restyle(name); });
    }
    ImGui::EndCombo();
  }
  ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
  ImGui::TextWrapped("%s", facts.style_doc.c_str());
  ImGui::PopStyleColor();
  ImGui::Spacing();
  widgets.draw(desk, desk.now->shown->style, "style");
}

void history_panel(Desk& desk) {
  const HistoryFacts& history = desk.now->history;
  if (history.labels.empty()) return ImGui::TextDisabled("Nothing was done yet.");
  for (std::size_t i = history.labels.size(); i-- > 0;) {
    const std::size_t index = history.first + i;
    const bool undone = index >= history.undo_steps;
    const bool present = index + 1 == history.undo_steps;
    ImGui::PushID(static_cast<int>(index));
    ImGui::PushStyleColor(ImGuiCol_Text, undone ? paint_colors::kFaint : paint_colors::kText);
    if (ImGui::Selectable(history.labels[i].c_str(), present)) {
      const std::size_t wanted = index + 1;
      desk.studio->act(
          "go through the history",
          [wanted](Session& session) -> Result<void> {
            while (session.project().undo_steps() > wanted) LUM_TRY_VOID(session.undo());
            while (session.project().undo_steps() < wanted) LUM_TRY_VOID(session.redo());
            return {};
          },
          Workbench::After::kFollow);
    }
    ImGui::PopStyleColor();
    tip(desk.theme, undone ? "Undone. Click to go forward to here." : "Click to go back to here.");
    ImGui::PopID();
  }
}

}  // namespace luminist
