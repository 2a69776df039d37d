#include "app/lights_panel.h"

#include <algorithm>

#include <fmt/format.h>
#include <imgui_stdlib.h>

#include "app/icons.h"
#include "app/light_rows.h"
#include "studio/light_list.h"

namespace luminist {
namespace {

constexpr std::string_view kGroup = "group:";

/// Patterns of what a light's lock turns: all of it is locked; what its type declares as solved is freed.
std::vector<std::string> lock_patterns(const Light& light, bool any_free) {
  const std::string path = light_path(light.name);
  if (any_free) return {path};
  std::vector<std::string> patterns;
  for (const ParamSpec& spec : light.params.schema().specs()) {
    if (spec.solve && spec.dofs() > 0) patterns.push_back(path + "/" + spec.name);
  }
  return patterns.empty() ? std::vector{path} : patterns;
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

void tell_solo(Desk& desk) {
  std::vector<std::string> lights(desk.solo.begin(), desk.solo.end());
  desk.studio->post("solo", [lights](Workbench& bench) -> Result<void> {
    bench.set_solo(lights);
    return {};
  });
}

void toggle_solo(Desk& desk, const std::vector<std::string>& names) {
  const bool all = std::ranges::all_of(names, [&](const std::string& name) { return desk.solo.contains(name); });
  for (const std::string& name : names) {
    if (all) desk.solo.erase(name);
    if (!all) desk.solo.insert(name);
  }
  tell_solo(desk);
}

void mute(Desk& desk, const std::string& who, bool muted) {
  desk.studio->change(
      "mute", [who, muted](Session& session) { return session.light_list().mute({who}, muted); },
      Workbench::After::kFollow);
}

void mute_button(Desk& desk, const std::string& who, bool muted, float side) {
  if (icon_button(desk.theme, "mute", muted ? Icon::kEyeOff : Icon::kEye, side, false,
                  muted ? "Muted. Click to turn it on." : "On. Click to mute it.")) {
    mute(desk, who, !muted);
  }
}

/// A line that is selected by a click; what lies on it is drawn from `start` on.
struct RowPlace {
  ImVec2 start;
  bool clicked = false;
  bool twice = false;  ///< clicked twice
};
RowPlace begin_row(bool selected) {
  RowPlace row{ImGui::GetCursorPos()};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
  row.clicked =
      ImGui::Selectable("##row", selected, ImGuiSelectableFlags_AllowItemOverlap, {0.0F, ImGui::GetFrameHeight()});
  row.twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) ImGui::OpenPopup("menu");
  ImGui::SetItemAllowOverlap();
  ImGui::PopStyleVar();
  return row;
}

void end_row(const Desk& desk, const RowPlace& row) {
  ImGui::SetCursorPos({row.start.x, row.start.y + ImGui::GetFrameHeight() + desk.theme.px(2.0F)});
  ImGui::Dummy({0.0F, 0.0F});
  ImGui::SetCursorPos({row.start.x, row.start.y + ImGui::GetFrameHeight() + desk.theme.px(2.0F)});
}

void shared_shadows(Desk& desk) {
  const LightRig& rig = desk.now->shown->rig;
  if (rig.lights.size() < 2 && rig.shadow_light.empty()) return;
  const auto share = [&](const std::string& name) {
    desk.studio->change(
        "share shadows", [name](Session& session) { return session.share_shadows(name); }, Workbench::After::kFollow);
  };
  row_label(desk.theme, "Shadows", "Whose shadows are cast. Sharing one light's keeps a stylized picture calm.");
  ImGui::SetNextItemWidth(-1.0F);
  const std::string now = rig.shadow_light.empty() ? "each light its own" : "all lights those of " + rig.shadow_light;
  if (!ImGui::BeginCombo("##shadows", now.c_str())) return;
  if (ImGui::Selectable("each light its own", rig.shadow_light.empty())) share("");
  tip(desk.theme, "Every light casts the shadows that it has from its own place.");
  for (const Light& light : rig.lights) {
    const std::string words = "all lights those of " + light.name;
    if (ImGui::Selectable(words.c_str(), rig.shadow_light == light.name)) share(light.name);
    tip(desk.theme, "All lights are shadowed where this one is.");
  }
  ImGui::EndCombo();
}

/// What the heading of a group says of its lights.
struct Members {
  std::vector<std::string> names;
  std::vector<std::string> lock_patterns;  ///< of what its lock turns
  int locked = 0;
  int dofs = 0;
  bool muted = true;  ///< all of them
};
Members members_of(const LightRig& rig, const std::string& group) {
  Members members;
  for (const Light& light : rig.lights) {
    if (light.group != group) continue;
    members.names.push_back(light.name);
    members.muted = members.muted && light.muted;
    members.locked += light.params.locks();
    members.dofs += light.params.schema().dofs();
  }
  const bool any_free = members.locked != members.dofs;
  for (const std::string& name : members.names) {
    for (std::string& pattern : lock_patterns(*rig.find(name), any_free)) {
      members.lock_patterns.push_back(std::move(pattern));
    }
  }
  return members;
}

}  // namespace

void LightsPanel::begin_rename(const std::string& name, const std::string& text) {
  renaming_ = name;
  renamed_to_ = text;
  rename_began_ = true;
}

void LightsPanel::end_rename(Desk& desk) {
  const std::string from = std::exchange(renaming_, "");
  const std::string to = renamed_to_;
  if (from.starts_with(kGroup)) {
    if (to == from.substr(kGroup.size()) || to.empty()) return;
    if (folded_.erase(from.substr(kGroup.size())) > 0) folded_.insert(to);
    return desk.studio->change("rename a group",
                               [from, to](Session& session) { return session.light_list().group({from}, to); });
  }
  if (to == from || !is_light_name(to) || desk.now->shown->rig.find(to) != nullptr) {
    if (to != from) desk.tell(StudioMessage::Kind::kError, "\"" + to + "\" is taken, or no name for a light");
    return;
  }
  desk.studio->change("rename a light", [from, to](Session& session) { return session.light_list().rename(from, to); });
  if (desk.selected == from) desk.selected = to;
  if (desk.solo.erase(from) > 0) {
    desk.solo.insert(to);
    tell_solo(desk);
  }
}

/// The field in place of a name that is being changed. returns whether it is there.
bool LightsPanel::name_field(Desk& desk, const std::string& name) {
  if (renaming_ != name) return false;
  ImGui::SetNextItemWidth(desk.theme.px(140.0F));
  if (rename_began_) ImGui::SetKeyboardFocusHere();
  const bool done = ImGui::InputText("##name", &renamed_to_,
                                     ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  tip(desk.theme, "Enter keeps the name, Esc leaves the old one.");
  const bool escaped = ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  const bool left = !std::exchange(rename_began_, false) && ImGui::IsItemDeactivated();
  if (escaped) {
    renaming_.clear();
  } else if (done || left) {
    end_rename(desk);
  }
  return true;
}

void LightsPanel::light_menu(Desk& desk, const Light& light) {
  if (!ImGui::BeginPopup("menu")) return;
  const std::string name = light.name;
  if (ImGui::MenuItem("Rename")) begin_rename(name, name);
  if (ImGui::MenuItem("Duplicate")) {
    desk.studio->change("duplicate a light", [name](Session& session) -> Result<void> {
      LUM_TRY_VOID(session.light_list().duplicate(name));
      return {};
    });
    desk.selected = desk.now->shown->rig.unused_name(name);
    desk.handles_aside = false;
  }
  if (ImGui::BeginMenu("Group")) {
    group_choices(desk, light);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Lights")) {
    link_choices(desk, light);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  removal_choices(desk, light);
  ImGui::EndPopup();
}

void LightsPanel::buttons(Desk& desk, const Light& light) {
  const float side = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 4.0F * side);
  if (icon_button(desk.theme, "solo", Icon::kSolo, side, desk.solo.contains(light.name),
                  "Solo: show only this light. Nothing else changes.")) {
    toggle_solo(desk, {light.name});
  }
  ImGui::SameLine(0.0F, 0.0F);
  mute_button(desk, light.name, light.muted, side);
  ImGui::SameLine(0.0F, 0.0F);
  const int locked = light.params.locks();
  const int all = light.params.schema().dofs();
  lock_button(desk, "lock", locked, all, lock_patterns(light, locked != all), side);
  ImGui::SameLine(0.0F, 0.0F);
  if (icon_button(desk.theme, "more", Icon::kMore, side, false,
                  "Rename, duplicate, group, link or remove this light.")) {
    ImGui::OpenPopup("menu");
  }
  light_menu(desk, light);
}

void LightsPanel::light_row(Desk& desk, const Light& light) {
  ImGui::PushID(light.name.c_str());
  const bool selected = desk.selected == light.name;
  const RowPlace row = begin_row(selected);
  if (row.twice) {
    clicked_twice_ = light.name;
    desk.selected = light.name;
  } else if (row.clicked && renaming_ != light.name) {
    // The click that asks for handles again is none to leave the light.
    desk.selected = selected && !desk.handles_aside ? "" : light.name;
  }
  if (row.clicked) desk.handles_aside = false;
  const float indent = light.group.empty() ? 4.0F : 20.0F;
  ImGui::SetCursorPos({row.start.x + desk.theme.px(indent), row.start.y});
  swatch(desk, light);
  ImGui::SameLine(0.0F, desk.theme.px(8.0F));
  ImGui::SetCursorPosY(row.start.y);
  if (!name_field(desk, light.name)) {
    ImGui::AlignTextToFramePadding();
    const auto& waiting = desk.now->waiting;
    const bool waits = std::find(waiting.begin(), waiting.end(), light.name) != waiting.end();
    const ImU32 color = waits ? paint_colors::kAccent : light.muted ? paint_colors::kFaint : paint_colors::kText;
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted((light.name + (waits ? "  paint it" : "")).c_str());
    ImGui::PopStyleColor();
  }
  ImGui::SetCursorPosY(row.start.y);
  buttons(desk, light);
  end_row(desk, row);
  ImGui::PopID();
}

void LightsPanel::group_row(Desk& desk, const std::string& group) {
  const std::string path = "group:" + group;
  ImGui::PushID(path.c_str());
  const bool folded = folded_.contains(group);
  const RowPlace row = begin_row(false);
  if (row.twice) {
    clicked_twice_ = path;
  } else if (row.clicked && renaming_ != path) {
    folded ? static_cast<void>(folded_.erase(group)) : static_cast<void>(folded_.insert(group));
  }
  const float side = ImGui::GetFrameHeight();
  draw_icon(*ImGui::GetWindowDrawList(), folded ? Icon::kFolded : Icon::kUnfolded,
            {ImGui::GetWindowPos().x + row.start.x + 0.5F * side - ImGui::GetScrollX(),
             ImGui::GetWindowPos().y + row.start.y + 0.5F * side - ImGui::GetScrollY()},
            desk.theme.px(12.0F), paint_colors::kDim);
  ImGui::SetCursorPos({row.start.x + desk.theme.px(22.0F), row.start.y});
  if (!name_field(desk, path)) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(desk.theme.strong);
    ImGui::TextUnformatted(group.c_str());
    ImGui::PopFont();
  }
  const Members members = members_of(desk.now->shown->rig, group);
  ImGui::SetCursorPosY(row.start.y);
  ImGui::SameLine(ImGui::GetContentRegionMax().x - 4.0F * side);
  const bool solo =
      std::ranges::all_of(members.names, [&](const std::string& name) { return desk.solo.contains(name); });
  if (icon_button(desk.theme, "solo", Icon::kSolo, side, solo, "Solo: show only the lights of this group.")) {
    toggle_solo(desk, members.names);
  }
  ImGui::SameLine(0.0F, 0.0F);
  mute_button(desk, path, members.muted, side);
  ImGui::SameLine(0.0F, 0.0F);
  lock_button(desk, "lock", members.locked, members.dofs, members.lock_patterns, side);
  ImGui::SameLine(0.0F, 0.0F);
  if (icon_button(desk.theme, "more", Icon::kMore, side, false, "Rename or dissolve this group.")) {
    ImGui::OpenPopup("menu");
  }
  if (ImGui::BeginPopup("menu")) {
    if (ImGui::MenuItem("Rename")) begin_rename(path, group);
    if (ImGui::MenuItem("Ungroup")) {
      desk.studio->change("ungroup", [path](Session& session) { return session.light_list().group({path}, ""); });
    }
    ImGui::EndPopup();
  }
  end_row(desk, row);
  ImGui::PopID();
}

void LightsPanel::details(Desk& desk, const Light& light, ParamWidgets& widgets) {
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted(light.name.c_str());
  ImGui::PopFont();
  ImGui::SameLine();
  ImGui::TextDisabled("%s", light.type.c_str());
  row_label(desk.theme, "Group", "Lights of a group are muted, locked and linked together, as group:NAME in scripts.");
  ImGui::SetNextItemWidth(-1.0F);
  if (ImGui::BeginCombo("##group", light.group.empty() ? "none" : light.group.c_str())) {
    group_choices(desk, light);
    ImGui::EndCombo();
  }
  row_label(desk.theme, "Lights", "Which objects this light lights. Its shadows still come from all of them.");
  const float side = ImGui::GetFrameHeight();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - side - desk.theme.px(4.0F));
  if (ImGui::BeginCombo("##objects", link_words(light).c_str(), ImGuiComboFlags_HeightLarge)) {
    link_choices(desk, light);
    ImGui::EndCombo();
  }
  ImGui::SameLine(0.0F, desk.theme.px(4.0F));
  const bool linking = desk.linking == light.name;
  if (icon_button(desk.theme, "pick", Icon::kTarget, side, linking,
                  linking ? "Click on the picture what it shall light. Click here, or Esc, to end."
                          : "Choose the objects by clicks on the picture.")) {
    linking ? desk.linking.clear() : begin_linking(desk, light);
  }
  constraint_list(desk, light);
  widgets.draw(desk, light.params, light_path(light.name));
}

void LightsPanel::draw(Desk& desk, ParamWidgets& widgets) {
  const LightRig& rig = desk.now->shown->rig;
  // A field gets no focus while the button that asked for it is down.
  if (!clicked_twice_.empty() && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    const std::string name = std::exchange(clicked_twice_, "");
    begin_rename(name, name.starts_with(kGroup) ? name.substr(kGroup.size()) : name);
  }
  const std::string add = desk.with_key("Add a light", Deed::kAddLight);
  if (ImGui::Button(add.c_str(), {-1.0F, 0.0F})) add_light(desk);
  tip(desk.theme,
      "A dark light that begins where you paint next. The other lights are locked, and what a solve "
      "proposes is accepted.");
  if (rig.lights.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
    ImGui::TextWrapped("There is no light yet, only a dim ambient. Paint on the picture, and a light is added.");
    ImGui::PopStyleColor();
  }
  for (const LightRow& row : light_rows(rig, folded_)) {
    row.light != nullptr ? light_row(desk, *row.light) : group_row(desk, row.group);
  }
  shared_shadows(desk);
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  if (const Light* light = rig.find(desk.selected)) return details(desk, *light, widgets);
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted("Ambient");
  ImGui::PopFont();
  widgets.draw(desk, desk.now->shown->rig.ambient, "ambient");
  if (!rig.lights.empty()) ImGui::TextDisabled("Select a light to see what it has.");
}

}  // namespace luminist
