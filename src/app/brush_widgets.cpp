#include "app/brush_widgets.h"

#include <algorithm>
#include <cstring>

#include <fmt/format.h>

#include "app/icons.h"
#include "base/check.h"

namespace luminist {

const BrushQuality& brush_quality(const char* name) {
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

namespace {

struct NumberLook {
  float least = 0.0F;
  float most = 1.0F;
  const char* format = "%.2f";
  float scale = 1.0F;  ///< shown number over the quality's
  bool logarithmic = false;
};
constexpr NumberLook kPercent{0.0F, 1.0F, "%.0f %%", 100.0F};

/// returns whether the hand let go of it.
bool number(const Desk& desk, const char* label, float& value, const char* name, const NumberLook& look) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  quality_tip(desk.theme, brush_quality(name));
  ImGui::SameLine(desk.theme.px(84.0F));
  ImGui::SetNextItemWidth(-1.0F);
  float shown = look.scale * value;
  const ImGuiSliderFlags flags =
      ImGuiSliderFlags_AlwaysClamp | (look.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  if (ImGui::SliderFloat(fmt::format("##{}", name).c_str(), &shown, look.scale * look.least, look.scale * look.most,
                         look.format, flags)) {
    value = shown / look.scale;
  }
  return ImGui::IsItemDeactivatedAfterEdit();
}

bool flag(const Desk& desk, const char* label, bool& value, const char* name) {
  const bool turned = ImGui::Checkbox(label, &value);
  quality_tip(desk.theme, brush_quality(name));
  return turned;
}

/// Which object strokes stay on.
bool clip_combo(Desk& desk, std::string& clip) {
  const std::string before = clip;
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Stay on");
  quality_tip(desk.theme, brush_quality("clip"));
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
  return clip != before;
}

}  // namespace

bool brush_settings(Desk& desk, Brush& brush) {
  const bool stops = brush.tool == PaintTool::kBrighten || brush.tool == PaintTool::kDarken;
  bool done = number(desk, "Size", brush.diameter, "diameter", {0.004F, 2.0F, "%.3f", 1.0F, true});
  done |= number(desk, "Opacity", brush.opacity, "opacity", kPercent);
  if (brush.tool == PaintTool::kColor) done |= number(desk, "Texture", brush.texture, "texture", kPercent);
  if (brush.tool != PaintTool::kErase) done |= number(desk, "Gradient", brush.gradient, "gradient", kPercent);
  if (stops) done |= number(desk, "Strength", brush.strength, "strength", {0.0F, 4.0F, "%.2f stops"});
  if (brush.tool == PaintTool::kImportance) {
    done |= number(desk, "Counts", brush.importance, "importance", {0.0F, 2.0F});
  }
  done |= clip_combo(desk, brush.clip);
  const float half = 0.5F * ImGui::GetContentRegionMax().x;
  done |= flag(desk, "Bucket", brush.bucket, "bucket");
  if (brush.tool == PaintTool::kColor) {
    ImGui::SameLine(half);
    done |= flag(desk, "Never darken", brush.add_light, "add_light");
  }
  if (brush.gradient <= 0.0F) return done;
  bool specular = brush.peak == PeakKind::kSpecular;
  done |= ImGui::Checkbox("Highlight", &specular);
  brush.peak = specular ? PeakKind::kSpecular : PeakKind::kDiffuse;
  quality_tip(desk.theme, brush_quality("peak"));
  ImGui::SameLine(half);
  done |= flag(desk, "Same peak", brush.repeat_peak, "repeat_peak");
  done |= flag(desk, "Fade along the drag", brush.screen_gradient, "screen_gradient");
  return done;
}

}  // namespace luminist
