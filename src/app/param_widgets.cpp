#include "app/param_widgets.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/value_slider.h"
#include "params/param_text.h"

namespace luminist {
namespace {

constexpr float kDegrees = 57.29578F;
constexpr float kLockGap = 4.0F;      // points between a lock and a name
constexpr float kWidgetsAt = 146.0F;  // points from the left border

/// The widget's numbers of a parameter: declared units; a direction as turn and height in degrees.
std::array<float, 3> widget_values(const ParamBlock& block, int param, const SceneFrame& frame) {
  const ParamSpec& spec = block.schema()[param];
  std::array<float, 3> values{};
  if (spec.type == ParamType::kDirection) {
    const Vec3 d = block.vec3(param);
    values[0] = kDegrees * std::atan2(d.x, -d.z);
    values[1] = kDegrees * std::asin(std::clamp(d.y, -1.0F, 1.0F));
    return values;
  }
  for (int c = 0; c < spec.components(); ++c) {
    values[static_cast<std::size_t>(c)] = static_cast<float>(spec.written(c, block.get(param, c), frame));
  }
  return values;
}

/// "0.3,0.3,0.1": what an assignment says.
std::string assigned(const ParamSpec& spec, const std::array<float, 3>& values, const SceneFrame& frame) {
  if (spec.type == ParamType::kBool) return values[0] != 0.0F ? "true" : "false";
  if (spec.type == ParamType::kChoice) return spec.choices[static_cast<std::size_t>(values[0])];
  if (spec.type == ParamType::kDirection) {
    const float turn = values[0] / kDegrees;
    const float height = values[1] / kDegrees;
    return fmt::format("{},{},{}", number_text(std::sin(turn) * std::cos(height)), number_text(std::sin(height)),
                       number_text(-std::cos(turn) * std::cos(height)));
  }
  std::string text;
  for (int c = 0; c < spec.components(); ++c) {
    const double stored = spec.stored(c, values[static_cast<std::size_t>(c)], frame);
    if (c > 0) text.append(",");
    text.append(number_text(shortest_double(static_cast<float>(stored))));
  }
  return text;
}

ColorEdit edited(bool changed) {
  return {changed, ImGui::IsItemDeactivatedAfterEdit()};
}

ColorEdit slider(const char* id, float& value, float least, float most, const char* format, bool logarithmic,
                 float width) {
  ImGui::SetNextItemWidth(width);
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  return edited(value_slider(id, &value, least, most, format, flags));
}

ColorEdit numbers(const ParamBlock& block, int param, const SceneFrame& frame, std::array<float, 3>& values,
                  float width) {
  const ParamSpec& spec = block.schema()[param];
  static constexpr std::array<const char*, 3> ids = {"##0", "##1", "##2"};
  const int count = spec.components();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float each = (width - gap * static_cast<float>(count - 1)) / static_cast<float>(count);
  ColorEdit all;
  for (int c = 0; c < count; ++c) {
    const auto i = static_cast<std::size_t>(c);
    if (c > 0) ImGui::SameLine(0.0F, gap);
    const ParamRange range = block.range(param, c, frame);
    const auto low = static_cast<float>(spec.written(c, range.low, frame));
    const auto high = static_cast<float>(spec.written(c, range.high, frame));
    const ColorEdit one =
        slider(ids[i], values[i], low, high, count == 1 ? "%.3f" : "%.2f", spec.scale == ParamScale::kLog, each);
    all.changed |= one.changed;
    all.done |= one.done;
  }
  return all;
}

ColorEdit direction(std::array<float, 3>& values, float width) {
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float each = 0.5F * (width - gap);
  const ColorEdit turn = slider("##turn", values[0], -180.0F, 180.0F, "turn %.0f°", false, each);
  ImGui::SameLine(0.0F, gap);
  const ColorEdit height = slider("##height", values[1], -90.0F, 90.0F, "up %.0f°", false, each);
  return {turn.changed || height.changed, turn.done || height.done};
}

std::string tip_of(const ParamBlock& block, int param, const SceneFrame& frame, const std::string& path) {
  const ParamSpec& spec = block.schema()[param];
  std::string text = spec.doc;
  if (!spec.unit.empty()) text += "\nUnit: " + spec.unit + ".";
  if (!spec.range_min.empty() && spec.type != ParamType::kBool && spec.type != ParamType::kChoice) {
    const ParamRange range = block.range(param, 0, frame);
    text +=
        fmt::format("\nRange: {:g} to {:g}.", spec.written(0, range.low, frame), spec.written(0, range.high, frame));
  }
  text += "\nCtrl+click on a slider to type a number.";
  if (takes_ranges(spec, path)) text += "\nRight click on the name to hold it in a range.";
  return text;
}

std::string title(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

ColorEdit color_field(const Theme& theme, const char* id, Vec3& color, float most, float width) {
  ImGui::PushID(id);
  ColorEdit edit;
  const float strength = std::max({color.x, color.y, color.z, 1e-4F});
  const float unit = std::max(strength, 1.0F);  // up to 1 the tint itself is darker
  const Vec3 tint = color / unit;
  float encoded[3] = {srgb_from_linear(tint.x), srgb_from_linear(tint.y), srgb_from_linear(tint.z)};
  const ImGuiColorEditFlags look = ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoAlpha;
  const float swatch = theme.px(44.0F);
  if (ImGui::ColorButton("##swatch", {encoded[0], encoded[1], encoded[2], 1.0F}, look,
                         {swatch, ImGui::GetFrameHeight()})) {
    ImGui::OpenPopup("picker");
  }
  if (ImGui::BeginPopup("picker")) {
    ImGui::SetNextItemWidth(theme.px(220.0F));
    if (ImGui::ColorPicker3("##pick", encoded,
                            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_DisplayHSV |
                                ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_NoAlpha)) {
      color = unit * Vec3(linear_from_srgb(encoded[0]), linear_from_srgb(encoded[1]), linear_from_srgb(encoded[2]));
      edit.changed = true;
    }
    edit.done |= ImGui::IsItemDeactivatedAfterEdit();
    ImGui::EndPopup();
  }
  ImGui::SameLine(0.0F, ImGui::GetStyle().ItemInnerSpacing.x);
  float wanted = strength;
  const ColorEdit power = slider("##strength", wanted, 0.0F, most, "strength %.2f", true,
                                 width - swatch - ImGui::GetStyle().ItemInnerSpacing.x);
  tip(theme, "The largest of red, green and blue: may exceed 1, as light does.");
  if (power.changed) color = strength <= 2e-4F ? Vec3(wanted) : color * (wanted / strength);
  ImGui::PopID();
  return {edit.changed || power.changed, edit.done || power.done};
}

void row_label(const Theme& theme, const char* name, const char* words) {
  const float side = ImGui::GetFrameHeight();
  ImGui::Dummy({side, side});
  ImGui::SameLine(0.0F, theme.px(kLockGap));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(name);
  tip(theme, words);
  ImGui::SameLine(theme.px(kWidgetsAt));
}

void lock_button(Desk& desk, const char* id, int locked, int all, const std::vector<std::string>& patterns,
                 float size) {
  const Icon icon = locked == 0 ? Icon::kOpen : locked == all ? Icon::kLocked : Icon::kPartly;
  const char* words = locked == 0     ? "Free: the solver may turn it. Click to lock it."
                      : locked == all ? "Locked: the solver leaves it as it is. Click to free it."
                                      : "Some of it is free. Click to lock all of it.";
  if (!icon_button(desk.theme, id, icon, size, locked == 0, words)) return;
  const bool lock = locked != all;
  desk.studio->change(
      lock ? "lock" : "unlock",
      [patterns, lock](Session& session) -> Result<void> {
        LUM_TRY(const int named, session.set_locked(patterns, lock));
        static_cast<void>(named);
        return {};
      },
      Workbench::After::kFollow);
}

ColorEdit ParamWidgets::widget(const Desk& desk, const ParamBlock& block, int param, Values& values, float width) {
  const ParamSpec& spec = block.schema()[param];
  switch (spec.type) {
    case ParamType::kColor: {
      Vec3 color(values[0], values[1], values[2]);
      float most = 0.0F;
      for (int c = 0; c < 3; ++c) {
        most = std::max(most, static_cast<float>(block.range(param, c, desk.now->facts->frame).high));
      }
      const ColorEdit edit = color_field(desk.theme, "color", color, most, width);
      values = {color.x, color.y, color.z};
      return edit;
    }
    case ParamType::kDirection:
      return direction(values, width);
    case ParamType::kBool: {
      bool on = values[0] != 0.0F;
      const bool changed = ImGui::Checkbox("##on", &on);
      values[0] = on ? 1.0F : 0.0F;
      return {changed, changed};
    }
    case ParamType::kChoice: {
      bool changed = false;
      ImGui::SetNextItemWidth(width);
      if (ImGui::BeginCombo("##choice", spec.choices[static_cast<std::size_t>(values[0])].c_str())) {
        for (std::size_t i = 0; i < spec.choices.size(); ++i) {
          if (!ImGui::Selectable(spec.choices[i].c_str(), static_cast<std::size_t>(values[0]) == i)) continue;
          values[0] = static_cast<float>(i);
          changed = true;
        }
        ImGui::EndCombo();
      }
      return {changed, changed};
    }
    case ParamType::kInt: {
      int value = static_cast<int>(std::lround(values[0]));
      ImGui::SetNextItemWidth(width);
      const bool changed = value_slider("##int", &value, static_cast<int>(spec.range_min[0]),
                                        static_cast<int>(spec.range_max[0]), "%d", ImGuiSliderFlags_AlwaysClamp);
      values[0] = static_cast<float>(value);
      return edited(changed);
    }
    default:
      return numbers(block, param, desk.now->facts->frame, values, width);
  }
}

void ParamWidgets::turned(Desk& desk, const ParamSpec& spec, const std::string& path, const Values& values,
                          const ColorEdit& edit) {
  if (!edit.changed && !edit.done) return;
  const std::vector<std::string> assignments = {path + "=" + assigned(spec, values, desk.now->facts->frame)};
  held_ = path;
  held_values_ = values;
  let_go_ = edit.done ? desk.now->version : 0;
  if (edit.done) {
    desk.studio->change("set", [assignments](Session& session) { return session.set(assignments); });
  } else {
    desk.studio->preview(assignments);
  }
}

/// In the accent's colour where a range holds it.
void ParamWidgets::name(Desk& desk, const ParamBlock& block, int param, const std::string& path) {
  const ParamSpec& spec = block.schema()[param];
  bool held = false;
  for (int d = 0; d < spec.dofs(); ++d) held = held || block.limits(spec.first_dof + d) != nullptr;
  ImGui::PushStyleColor(ImGuiCol_Text, held ? paint_colors::kAccent : ImGui::GetColorU32(ImGuiCol_Text));
  ImGui::TextUnformatted(title(spec.name).c_str());
  ImGui::PopStyleColor();
  tip(desk.theme, tip_of(block, param, desk.now->facts->frame, path).c_str());
  if (takes_ranges(spec, path)) range_.offer(desk, block, param, path);
}

void ParamWidgets::row(Desk& desk, const ParamBlock& block, int param, const std::string& path) {
  const ParamSpec& spec = block.schema()[param];
  const Theme& theme = desk.theme;
  const std::string full = path + "/" + spec.name;
  ImGui::PushID(param);
  const float side = ImGui::GetFrameHeight();
  if (spec.dofs() > 0) {
    int locked = 0;
    for (int d = 0; d < spec.dofs(); ++d) locked += block.locked_by_hand(spec.first_dof + d) ? 1 : 0;
    lock_button(desk, "lock", locked, spec.dofs(), {full}, side);
  } else {
    ImGui::Dummy({side, side});
  }
  ImGui::SameLine(0.0F, theme.px(kLockGap));
  ImGui::AlignTextToFramePadding();
  name(desk, block, param, full);
  ImGui::SameLine(theme.px(kWidgetsAt));
  Values values = held_ == full ? held_values_ : widget_values(block, param, desk.now->facts->frame);
  const bool follows = spec.dofs() > 0 && block.following(spec.first_dof);
  if (follows) {
    ImGui::TextDisabled("follows another light");
  } else {
    const ColorEdit edit = widget(desk, block, param, values, ImGui::GetContentRegionAvail().x);
    turned(desk, spec, full, values, edit);
  }
  ImGui::PopID();
}

void ParamWidgets::draw(Desk& desk, const ParamBlock& block, const std::string& path) {
  draw(desk, block, path, [](const ParamSpec&) { return true; });
}

void ParamWidgets::draw(Desk& desk, const ParamBlock& block, const std::string& path, const Filter& filter) {
  // What was let go is held until a later snapshot, with nothing left to do, shows it.
  if (let_go_ != 0 && desk.now->version > let_go_ && desk.activity.label.empty() && desk.activity.waiting == 0) {
    held_.clear();
    let_go_ = 0;
  }
  ImGui::PushID(path.c_str());
  std::string group;
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    if (!filter(spec)) continue;
    if (spec.group != group) {
      group = spec.group;
      ImGui::PushFont(desk.theme.small);
      ImGui::TextDisabled("%s", group.c_str());
      ImGui::PopFont();
    }
    row(desk, block, param, path);
  }
  ImGui::PopID();
}

}  // namespace luminist
