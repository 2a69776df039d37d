// The timeline of the panel of shots: a ruler to drag along, paint, keys.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/shots_panel.h"
#include "params/param_text.h"
#include "studio/shots.h"

namespace luminist {
namespace {

constexpr float kGutter = 132.0F;  // points, for names
constexpr float kRow = 19.0F;

/// Changes keys; what a solve proposes comes in force first.
template <class Edit>
void edit_keys(Desk& desk, const char* label, const Edit& edit) {
  desk.studio->change(label, [edit](Session& session) -> Result<void> {
    LUM_TRY_VOID(edit(session));
    return {};
  });
}

void set_keys(Desk& desk, const std::string& pattern, KeyInterpolation interpolation) {
  edit_keys(desk, "set a key", [=](Session& session) { return Shots(session).set_keys(pattern, interpolation); });
}

void remove_keys(Desk& desk, const std::string& pattern, double frame) {
  edit_keys(desk, "remove a key", [=](Session& session) { return Shots(session).remove_keys(pattern, frame); });
}

/// A square for a step, a diamond for a line, a disc for a smooth curve.
void key_sign(ImDrawList& list, const ImVec2& at, float radius, KeyInterpolation interpolation, ImU32 color) {
  const ImU32 edge = IM_COL32(20, 20, 20, 255);
  switch (interpolation) {
    case KeyInterpolation::kStep:
      list.AddRectFilled({at.x - 0.8F * radius, at.y - 0.8F * radius}, {at.x + 0.8F * radius, at.y + 0.8F * radius},
                         color);
      list.AddRect({at.x - 0.8F * radius, at.y - 0.8F * radius}, {at.x + 0.8F * radius, at.y + 0.8F * radius}, edge);
      return;
    case KeyInterpolation::kLinear:
      list.AddNgonFilled(at, 1.1F * radius, color, 4);
      list.AddNgon(at, 1.1F * radius, edge, 4);
      return;
    case KeyInterpolation::kSmooth:
      list.AddCircleFilled(at, radius, color, 16);
      list.AddCircle(at, radius, edge, 16);
      return;
  }
}

void name_at(const Desk& desk, const ImVec2& at, const std::string& name, ImU32 color) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(at, {at.x + desk.theme.px(kGutter - 26.0F), at.y + desk.theme.px(kRow)}, true);
  list.AddText(desk.theme.small, desk.theme.small->FontSize, {at.x, at.y + desk.theme.px(2.0F)}, color, name.c_str());
  list.PopClipRect();
}

}  // namespace

void ShotsPanel::ruler(Desk& desk, const FrameFacts& facts, const TimeScale& scale, float height) {
  const Theme& theme = desk.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float reach = theme.px(6.0F);
  const float deep = theme.px(kRow);
  list.AddRectFilled({scale.left - reach, at.y}, {scale.right + reach, at.y + deep}, IM_COL32(46, 46, 46, 255));
  const int step = scale.step(theme.px(34.0F));
  for (int frame = scale.first - scale.first % step; frame <= scale.last; frame += step) {
    if (frame < scale.first) continue;
    const float x = scale.x_of(frame);
    list.AddLine({x, at.y + 0.7F * deep}, {x, at.y + deep}, paint_colors::kDim);
    list.AddText(theme.small, theme.small->FontSize, {x + theme.px(6.0F), at.y + theme.px(1.0F)}, paint_colors::kDim,
                 std::to_string(frame).c_str());
  }
  ImGui::SetCursorScreenPos({scale.left - reach, at.y});
  ImGui::InvisibleButton("ruler", {scale.right - scale.left + 2.0F * reach, deep});
  if (ImGui::IsItemActive()) {
    const double frame = scale.frame_at(ImGui::GetIO().MousePos.x);
    if (frame != head_.value_or(facts.frame)) desk.studio->preview_frame(frame);
    head_ = frame;
  } else if (ImGui::IsItemDeactivated() && head_) {
    desk.studio->go_to(*head_);
  }
  if (!head_) tip(theme, "Drag to look through time; let go to stay there.");
  const float x = scale.x_of(head_.value_or(facts.frame));
  list.AddLine({x, at.y}, {x, at.y + height}, paint_colors::kAccent, theme.px(1.5F));
  list.AddTriangleFilled({x - theme.px(5.0F), at.y}, {x + theme.px(5.0F), at.y}, {x, at.y + theme.px(7.0F)},
                         paint_colors::kAccent);
  ImGui::SetCursorScreenPos({at.x, at.y + deep + theme.px(2.0F)});
}

void ShotsPanel::clear_menu(Desk& desk, const Vantage& at) {
  if (!ImGui::BeginPopupContextItem("clear")) return;
  const std::string words = "Clear the paint of " + vantage_text(at, desk.now->facts->cameras);
  if (ImGui::MenuItem(words.c_str())) {
    desk.studio->act("clear the paint", [at](Session& session) { return Shots(session).clear_paint(at); });
  }
  ImGui::EndPopup();
}

/// A dab for every frame with strokes.
void ShotsPanel::paint_row(Desk& desk, const FrameFacts& facts, const TimeScale& scale) {
  const Theme& theme = desk.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  name_at(desk, at, "Paint", paint_colors::kText);
  const float middle = at.y + 0.5F * theme.px(kRow);
  list.AddLine({scale.left, middle}, {scale.right, middle}, IM_COL32(58, 58, 58, 255));
  const float r = theme.px(5.0F);
  for (const PaintedFrame& painted : facts.painted) {
    if (painted.at.camera != facts.camera) continue;
    const float x = scale.x_of(painted.at.frame);
    ImGui::PushID(static_cast<int>(std::lround(painted.at.frame * 100.0)));
    list.AddCircleFilled({x, middle}, r, IM_COL32(196, 132, 96, 255), 16);
    list.AddCircleFilled({x + 0.5F * r, middle - 0.6F * r}, 0.5F * r, IM_COL32(228, 176, 132, 255), 12);
    ImGui::SetCursorScreenPos({x - r, middle - r});
    if (ImGui::InvisibleButton("paint", {2.0F * r, 2.0F * r})) desk.studio->go_to(painted.at.frame);
    const std::string number = number_text(painted.at.frame);
    tip(theme, fmt::format("Frame {}: {} stroke{}. Click to go there, right click to clear.", number, painted.strokes,
                           painted.strokes == 1 ? "" : "s")
                   .c_str());
    clear_menu(desk, painted.at);
    ImGui::PopID();
  }
  if (std::ranges::none_of(facts.painted, [&](const PaintedFrame& each) { return each.at.camera == facts.camera; })) {
    const char* words = facts.painted.empty() ? "no frame is painted" : "no frame is painted through this camera";
    list.AddText(theme.small, theme.small->FontSize, {scale.left + theme.px(8.0F), at.y + theme.px(2.0F)},
                 paint_colors::kDim, words);
  }
  ImGui::SetCursorScreenPos({at.x, at.y + theme.px(kRow)});
}

void ShotsPanel::key_menu(Desk& desk, const KeyRow& row) {
  if (!ImGui::BeginPopup("key menu")) return;
  const double frame = menu_frame_;
  const std::string pattern = row.pattern;
  const auto key = std::find_if(row.keys.begin(), row.keys.end(), [&](const Key& each) { return each.frame == frame; });
  ImGui::TextDisabled("%s at frame %s", row.name.c_str(), number_text(frame).c_str());
  static constexpr std::array<const char*, 3> words = {"Stay, then jump", "Go straight to the next", "Go on smoothly"};
  for (int i = 0; i < 3; ++i) {
    const auto how = static_cast<KeyInterpolation>(i);
    const bool chosen = key != row.keys.end() && key->interpolation == how;
    if (!ImGui::MenuItem(words[static_cast<std::size_t>(i)], nullptr, chosen)) continue;
    edit_keys(desk, "change a key",
              [=](Session& session) { return Shots(session).interpolate_keys(pattern, frame, how); });
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Go there")) desk.studio->go_to(frame);
  if (ImGui::MenuItem("Remove the key")) remove_keys(desk, pattern, frame);
  ImGui::EndPopup();
}

void ShotsPanel::key_marks(Desk& desk, const KeyRow& row, const TimeScale& scale, float middle) {
  const Theme& theme = desk.theme;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float r = theme.px(5.0F);
  for (std::size_t i = 0; i < row.keys.size(); ++i) {
    const Key& key = row.keys[i];
    const bool held = held_row_ == row.pattern && held_from_ == key.frame;
    const ImVec2 at(scale.x_of(held ? held_to_ : key.frame), middle);
    ImGui::PushID(static_cast<int>(i));
    ImGui::SetCursorScreenPos({scale.x_of(key.frame) - r, middle - r});
    ImGui::InvisibleButton("key", {2.0F * r, 2.0F * r});
    const bool hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    key_sign(list, at, r, key.interpolation, hot || held ? paint_colors::kAccent : IM_COL32(190, 190, 190, 255));
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
      menu_frame_ = key.frame;
      ImGui::PopID();
      ImGui::OpenPopup("key menu");
      ImGui::PushID(static_cast<int>(i));
    }
    if (ImGui::IsItemActive()) {
      held_row_ = row.pattern, held_from_ = key.frame;
      held_to_ = std::abs(ImGui::GetMouseDragDelta().x) > theme.px(3.0F) ? scale.frame_at(ImGui::GetIO().MousePos.x)
                                                                         : key.frame;
    } else if (ImGui::IsItemDeactivated() && held) {
      if (held_to_ != held_from_) {
        edit_keys(desk, "move a key", [pattern = row.pattern, from = held_from_, to = held_to_](Session& session) {
          return Shots(session).move_keys(pattern, from, to);
        });
      } else {
        desk.studio->go_to(key.frame);
      }
      held_row_.clear();
    } else {
      tip(theme,
          fmt::format("Key at frame {}, {}. Click to go there, drag to move it, right click for more.",
                      number_text(key.frame), key_interpolation_words()[static_cast<std::size_t>(key.interpolation)])
              .c_str());
    }
    ImGui::PopID();
  }
}

void ShotsPanel::key_row(Desk& desk, const FrameFacts& facts, const TimeScale& scale, const KeyRow& row) {
  const Theme& theme = desk.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = at.y + 0.5F * theme.px(kRow);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushID(row.pattern.c_str());
  name_at(desk, at, row.name, paint_colors::kText);
  const bool here =
      std::any_of(row.keys.begin(), row.keys.end(), [&](const Key& each) { return each.frame == facts.frame; });
  const ImVec2 dot(scale.left - theme.px(16.0F), middle);
  if (here) {
    list.AddNgonFilled(dot, theme.px(5.0F), paint_colors::kAccent, 4);
  } else {
    list.AddNgon(dot, theme.px(5.0F), paint_colors::kDim, 4, theme.px(1.0F));
  }
  ImGui::SetCursorScreenPos({dot.x - theme.px(7.0F), dot.y - theme.px(7.0F)});
  if (ImGui::InvisibleButton("here", {theme.px(14.0F), theme.px(14.0F)})) {
    if (here) {
      remove_keys(desk, row.pattern, facts.frame);
    } else {
      set_keys(desk, row.pattern, interpolation_);
    }
  }
  tip(theme, here ? "A key at this frame. Click to take it away." : "No key at this frame. Click to set one.");
  list.AddLine({scale.left, middle}, {scale.right, middle}, IM_COL32(58, 58, 58, 255));
  key_marks(desk, row, scale, middle);
  key_menu(desk, row);
  ImGui::PopID();
  ImGui::SetCursorScreenPos({at.x, at.y + theme.px(kRow)});
  ImGui::Dummy({0.0F, 0.0F});
}

/// A key for a parameter of the selected light, or for one number of it.
void ShotsPanel::new_key(Desk& desk) {
  const LightRig& rig = desk.now->shown->rig;
  const Light* light = rig.find(desk.selected);
  const ParamBlock& block = light != nullptr ? light->params : rig.ambient;
  const std::string path = light_path(light != nullptr ? light->name : "");
  if (ImGui::SmallButton("+ key")) ImGui::OpenPopup("new key");
  tip(desk.theme, light != nullptr ? "Keys a parameter of the selected light at this frame."
                                   : "Keys the ambient at this frame; select a light to key what it has.");
  ImGui::SameLine(0.0F, desk.theme.px(4.0F));
  ImGui::SetNextItemWidth(desk.theme.px(70.0F));
  ImGui::PushFont(desk.theme.small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {desk.theme.px(4.0F), desk.theme.px(1.0F)});
  if (ImGui::BeginCombo("##how", key_interpolation_words()[static_cast<std::size_t>(interpolation_)].c_str())) {
    for (int i = 0; i < 3; ++i) {
      const auto how = static_cast<KeyInterpolation>(i);
      if (ImGui::Selectable(key_interpolation_words()[static_cast<std::size_t>(i)].c_str(), how == interpolation_)) {
        interpolation_ = how;
      }
    }
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
  ImGui::PopFont();
  tip(desk.theme, "How new keys go on to the next: step stays and jumps, linear goes straight, smooth has no kinks.");
  if (!ImGui::BeginPopup("new key")) return;
  if (ImGui::MenuItem("all of it")) set_keys(desk, path, interpolation_);
  ImGui::Separator();
  for (const ParamSpec& spec : block.schema().specs()) {
    if (!keys_by_component(spec)) {
      if (ImGui::MenuItem(spec.name.c_str())) set_keys(desk, path + "/" + spec.name, interpolation_);
      continue;
    }
    if (!ImGui::BeginMenu(spec.name.c_str())) continue;
    if (ImGui::MenuItem("all numbers")) set_keys(desk, path + "/" + spec.name, interpolation_);
    for (int c = 0; c < spec.components(); ++c) {
      const std::string name = dof_name(spec, c);
      if (ImGui::MenuItem(name.c_str())) set_keys(desk, path + "/" + name, interpolation_);
    }
    ImGui::EndMenu();
  }
  ImGui::EndPopup();
}

void ShotsPanel::timeline(Desk& desk, const FrameFacts& facts) {
  const Theme& theme = desk.theme;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const TimeScale scale{at.x + theme.px(kGutter), at.x + room.x - theme.px(20.0F), facts.first, facts.last};
  new_key(desk);
  ImGui::SetCursorScreenPos(at);
  ruler(desk, facts, scale, room.y);
  ImGui::BeginChild("rows", {0.0F, 0.0F});
  paint_row(desk, facts, scale);
  const std::vector<KeyRow> rows = key_rows(desk.now->shown->rig, desk.selected);
  for (const KeyRow& row : rows) key_row(desk, facts, scale, row);
  if (rows.empty()) {
    const ImVec2 here = ImGui::GetCursorScreenPos();
    name_at(desk, here, desk.selected.empty() ? "Keys" : desk.selected, paint_colors::kText);
    ImGui::GetWindowDrawList()->AddText(theme.small, theme.small->FontSize,
                                        {scale.left + theme.px(8.0F), here.y + theme.px(2.0F)}, paint_colors::kDim,
                                        "no keys: what it is holds at every frame; + key sets one here");
  }
  ImGui::EndChild();
}

}  // namespace luminist
