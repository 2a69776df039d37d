#include "app/layout.h"

#include <algorithm>

#include "app/icons.h"

namespace luminist {
namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                    ImGuiWindowFlags_NoSavedSettings;

void begin(const char* name, const ScreenRect& rect, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos({rect.lo.x, rect.lo.y});
  ImGui::SetNextWindowSize({rect.size().x, rect.size().y});
  ImGui::Begin(name, nullptr, kFixed | more);
}

/// A border that can be dragged. width grows as the border moves by `sign`.
void splitter(const Desk& desk, const char* name, float x, const ScreenRect& between, float& width, float sign) {
  const float half = desk.theme.px(3.0F);
  ImGui::SetNextWindowPos({x - half, between.lo.y});
  ImGui::SetNextWindowSize({2.0F * half, between.size().y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
  ImGui::Begin(name, nullptr,
               (kFixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoScrollbar);
  ImGui::InvisibleButton("border", {2.0F * half, between.size().y});
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) {
    width = std::clamp(width + sign * ImGui::GetIO().MouseDelta.x / desk.theme.scale, 190.0F, 480.0F);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace

void Layout::left_side(Desk& desk, const ScreenRect& rect) {
  const float strip = desk.theme.px(46.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {desk.theme.px(6.0F), desk.theme.px(8.0F)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, desk.theme.px(3.0F)});
  begin("tools", {rect.lo, {rect.lo.x + strip, rect.hi.y}});
  tool_strip(desk);
  ImGui::End();
  ImGui::PopStyleVar(2);
  begin("brush", {{rect.lo.x + strip, rect.lo.y}, rect.hi});
  desk.box.tool() == Tool::kEdit ? strokes_.settings(desk) : brush_panel(desk);
  ImGui::End();
}

void Layout::right_side(Desk& desk, const ScreenRect& rect) {
  const float solve = desk.theme.px(176.0F);
  const float split = rect.hi.y - solve;
  begin("panels", {rect.lo, {rect.hi.x, split}});
  if (desk.has_shot() && ImGui::BeginTabBar("tabs")) {
    const auto tab = [&](const char* name, const auto& draw) {
      if (!ImGui::BeginTabItem(name)) return;
      ImGui::BeginChild(name);
      draw();
      ImGui::EndChild();
      ImGui::EndTabItem();
    };
    tab("Lights", [&] { lights_.draw(desk, widgets_); });
    tab("Style", [&] { style_.draw(desk, widgets_); });
    tab("Paint", [&] { strokes_.list(desk); });
    tab("Explore", [&] { explore_.draw(desk); });
    tab("History", [&] { history_panel(desk); });
    ImGui::EndTabBar();
  }
  ImGui::End();
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.21F, 0.21F, 0.21F, 1.0F));
  begin("solve", {{rect.lo.x, split}, rect.hi});
  ImGui::PopStyleColor();
  if (desk.has_shot()) solve_panel(desk);
  ImGui::End();
}

float Layout::shots(Desk& desk, const ScreenRect& middle) {
  if (!shots_shown(desk)) {
    shots_.hide(desk);
    return 0.0F;
  }
  const float height = ShotsPanel::height(desk.theme);
  begin("shots", {{middle.lo.x, middle.hi.y - height}, middle.hi}, ImGuiWindowFlags_NoScrollbar);
  shots_.draw(desk);
  ImGui::End();
  return height;
}

void Layout::draw(Desk& desk, CanvasPanel& canvas, std::span<const HandEvent> events) {
  const ImGuiIO& io = ImGui::GetIO();
  menu_bar(desk);
  const float top = ImGui::GetFrameHeight();
  const float status = desk.theme.px(28.0F);
  const float bar = desk.theme.px(38.0F);
  const float bottom = io.DisplaySize.y - status;
  const float left = desk.show_panels ? desk.theme.px(46.0F + left_) : 0.0F;
  const float right = io.DisplaySize.x - (desk.show_panels ? desk.theme.px(right_) : 0.0F);
  ScreenRect middle{{left, top + bar}, {right, bottom}};
  middle.hi.y -= shots(desk, middle);
  if (desk.orbit && desk.has_shot()) {
    orbit_.draw(desk, middle, events);
  } else {
    orbit_.closed(desk);
    const std::vector<HandEvent> others = goal_picker_.take(desk, link_picker_.take(desk, events));
    canvas.draw(desk, middle, others);
    link_picker_.draw(desk);
    goal_picker_.draw(desk);
  }
  begin("view", {{left, top}, {right, top + bar}}, ImGuiWindowFlags_NoScrollbar);
  if (desk.has_shot()) view_bar(desk);
  ImGui::End();
  if (desk.show_panels) {
    left_side(desk, {{0.0F, top}, {left, bottom}});
    right_side(desk, {{right, top}, {io.DisplaySize.x, bottom}});
    splitter(desk, "left border", left, middle, left_, 1.0F);
    splitter(desk, "right border", right, middle, right_, -1.0F);
  }
  tour_.draw(desk, middle);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {desk.theme.px(10.0F), desk.theme.px(5.0F)});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.15F, 0.15F, 0.15F, 1.0F));
  begin("status", {{0.0F, bottom}, {io.DisplaySize.x, io.DisplaySize.y}}, ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  status_bar(desk);
  ImGui::End();
}

}  // namespace luminist
