#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/panels.h"

namespace luminist {
namespace {

/// The declaration of a quality of the brush.
const BrushQuality& quality(const char* name) {
  const auto all = brush_qualities();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const BrushQuality& each) { return std::strcmp(each.name, name) == 0; });
  LUM_CHECK(found != all.end(), "brushes have this quality");
  return *found;
}

void quality_tip(const Theme& theme, const BrushQuality& what) {
  const std::string range = quality_range(what);
  tip(theme, (std::string(what.doc) + (range.empty() ? "" : "\n" + range + ".")).c_str());
}

struct NumberLook {
  float least = 0.0F;
  float most = 1.0F;
  const char* format = "%.2f";
  float scale = 1.0F;  ///< shown number over the quality's
  bool logarithmic = false;
};
constexpr NumberLook kPercent{0.0F, 1.0F, "%.0f %%", 100.0F};

void number(const Desk& desk, const char* label, float& value, const char* name, const NumberLook& look) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  quality_tip(desk.theme, quality(name));
  ImGui::SameLine(desk.theme.px(84.0F));
  ImGui::SetNextItemWidth(-1.0F);
  float shown = look.scale * value;
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_AlwaysClamp | (look.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  if (ImGui::SliderFloat(fmt::format("##{}", name).c_str(), &shown, look.scale * look.least, look.scale * look.most,
                         look.format, flags)) {
    value = shown / look.scale;
  }
}

void flag(const Desk& desk, const char* label, bool& value, const char* name) {
  ImGui::Checkbox(label, &value);
  quality_tip(desk.theme, quality(name));
}

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

/// Which object strokes stay on.
void clip(Desk& desk) {
  std::string& clip = desk.box.brush().clip;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Stay on");
  quality_tip(desk.theme, quality("clip"));
  ImGui::SameLine(desk.theme.px(84.0F));
  const float side = ImGui::GetFrameHeight();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - side - desk.theme.px(4.0F));
  const char* shown = clip.empty() ? "anything" : clip == "@" ? "where it begins" : clip.c_str();
  if (ImGui::BeginCombo("##clip", shown)) {
    if (ImGui::Selectable("anything", clip.empty())) clip.clear();
    if (ImGui::Selectable("where it begins", clip == "@")) clip.assign(1, '@');
    ImGui::Separator();
    for (const std::string& name : desk.now->facts->surface.object_names) {
      if (!name.empty() && ImGui::Selectable(name.c_str(), clip == name)) clip = name;
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine(0.0F, desk.theme.px(4.0F));
  if (icon_button(desk.theme, "pick clip", Icon::kTarget, side, desk.pick_clip,
                  "Then click on the object to stay on.")) {
    desk.pick_clip = !desk.pick_clip;
  }
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

void settings(Desk& desk) {
  Brush& brush = desk.box.brush();
  const bool stops = brush.tool == PaintTool::kBrighten || brush.tool == PaintTool::kDarken;
  number(desk, "Size", brush.diameter, "diameter", {0.004F, 2.0F, "%.3f", 1.0F, true});
  number(desk, "Opacity", brush.opacity, "opacity", kPercent);
  if (brush.tool == PaintTool::kColor) number(desk, "Texture", brush.texture, "texture", kPercent);
  if (brush.tool != PaintTool::kErase) number(desk, "Gradient", brush.gradient, "gradient", kPercent);
  if (stops) number(desk, "Strength", brush.strength, "strength", {0.0F, 4.0F, "%.2f stops"});
  if (brush.tool == PaintTool::kImportance) number(desk, "Counts", brush.importance, "importance", {0.0F, 2.0F});
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Steady");
  tip(desk.theme, "Steadies the hand: the stroke trails behind the pointer.");
  ImGui::SameLine(desk.theme.px(84.0F));
  ImGui::SetNextItemWidth(-1.0F);
  float steady = 100.0F * desk.box.steadiness();
  if (ImGui::SliderFloat("##steady", &steady, 0.0F, 100.0F, "%.0f %%", ImGuiSliderFlags_AlwaysClamp)) {
    desk.box.steadiness() = 0.01F * steady;
  }
  clip(desk);
  const float half = 0.5F * ImGui::GetContentRegionMax().x;
  flag(desk, "Bucket", brush.bucket, "bucket");
  if (brush.tool == PaintTool::kColor) {
    ImGui::SameLine(half);
    flag(desk, "Never darken", brush.add_light, "add_light");
  }
  if (brush.gradient <= 0.0F) return;
  bool specular = brush.peak == PeakKind::kSpecular;
  if (ImGui::Checkbox("Highlight", &specular)) brush.peak = specular ? PeakKind::kSpecular : PeakKind::kDiffuse;
  quality_tip(desk.theme, quality("peak"));
  ImGui::SameLine(half);
  flag(desk, "Same peak", brush.repeat_peak, "repeat_peak");
  flag(desk, "Fade along the drag", brush.screen_gradient, "screen_gradient");
}

void copy_from(Desk& desk) {
  Brush& brush = desk.box.brush();
  const std::string name = std::filesystem::path(brush.copy_from).filename().string();
  if (ImGui::Button(name.empty() ? "Choose an image..." : name.c_str(), {-1.0F, 0.0F})) desk.ask(Question::kImage);
  quality_tip(desk.theme, quality("copy_from"));
}

}  // namespace

void tool_strip(Desk& desk) {
  static constexpr std::array<Deed, kTools> keys = {Deed::kToolLight,  Deed::kNone,           Deed::kNone,
                                                    Deed::kToolShadow, Deed::kNone,           Deed::kNone,
                                                    Deed::kToolErase,  Deed::kToolImportance, Deed::kToolPick};
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
  if (desk.box.tool() != Tool::kPick) settings(desk);
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
