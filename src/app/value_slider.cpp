#include "app/value_slider.h"

#include <imgui_internal.h>  // where a slider stands

#include "app/theme.h"

namespace luminist {
namespace {

/// Without the knob, which would stand over the digits; then a bar as far as the knob would be.
bool slide(const char* id, ImGuiDataType type, void* value, const void* least, const void* most, const char* format,
           ImGuiSliderFlags flags) {
  const float height_px = 2.0F * ImGui::GetFontSize() / 14.0F;
  ImGui::PushStyleColor(ImGuiCol_SliderGrab, 0);
  ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, 0);
  const bool changed = ImGui::SliderScalar(id, type, value, least, most, format, flags);
  ImGui::PopStyleColor(2);
  const bool typed = ImGui::TempInputIsActive(ImGui::GetItemID());
  if (typed || !ImGui::IsItemVisible()) return changed;
  const ImVec2 lo = ImGui::GetItemRectMin();
  const ImVec2 hi = ImGui::GetItemRectMax();
  ImRect knob;
  // Under an id that no item has it only says where the knob is.
  ImGui::SliderBehavior(ImRect(lo, hi), ImGui::GetID("where it stands"), type, value, least, most, format, flags,
                        &knob);
  const bool held = ImGui::IsItemActive() || ImGui::IsItemHovered();
  const ImU32 color = held ? paint_colors::kAccent : ImGui::GetColorU32(ImVec4(0.46F, 0.46F, 0.46F, 1.0F));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({lo.x + 2.0F, hi.y - height_px}, {0.5F * (knob.Min.x + knob.Max.x), hi.y}, color, 1.0F);
  return changed;
}

}  // namespace

bool value_slider(const char* id, float* value, float least, float most, const char* format, ImGuiSliderFlags flags) {
  return slide(id, ImGuiDataType_Float, value, &least, &most, format, flags);
}

bool value_slider(const char* id, int* value, int least, int most, const char* format, ImGuiSliderFlags flags) {
  return slide(id, ImGuiDataType_S32, value, &least, &most, format, flags);
}

}  // namespace luminist
