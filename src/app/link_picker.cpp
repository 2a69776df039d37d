#include "app/link_picker.h"

#include <algorithm>

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/canvas_panel.h"
#include "app/light_rows.h"
#include "rig/light_links.h"

namespace luminist {

void LinkPicker::toggle(Desk& desk, const Vec2& screen) {
  const Light* light = desk.now->shown->rig.find(desk.linking);
  const std::string object = object_at(*desk.now->facts, desk.view.to_picture(screen));
  if (light == nullptr || object.empty()) return;
  const auto objects = std::span(desk.now->facts->surface.object_names).subspan(1);
  // The first click chooses one object, not all but one.
  const bool all = light->objects.empty();
  const std::vector<std::string> linked =
      all ? std::vector<std::string>{object} : toggled_link(*light, objects, object);
  desk.studio->change(
      "link a light", [name = light->name, linked](Session& session) { return session.link_light(name, linked); },
      Workbench::After::kFollow);
}

std::vector<HandEvent> LinkPicker::take(Desk& desk, std::span<const HandEvent> events) {
  std::vector<HandEvent> left(events.begin(), events.end());
  if (!desk.has_shot() || desk.linking.empty() || desk.now->shown->rig.find(desk.linking) == nullptr) {
    desk.linking.clear();
    pressed_ = false;
    return left;
  }
  const bool covered = desk.question != Question::kNone ||
                       ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  std::erase_if(left, [&](const HandEvent& event) {
    if (event.kind == HandEvent::Kind::kRelease) return std::exchange(pressed_, false);
    const bool press = event.kind == HandEvent::Kind::kPress && event.button == GLFW_MOUSE_BUTTON_LEFT &&
                       !desk.space_down && !covered && desk.view.rect().contains(event.at);
    if (!press) return false;
    pressed_ = true;
    toggle(desk, event.at);
    return true;
  });
  return left;
}

void LinkPicker::draw(Desk& desk) const {
  const Light* light = desk.has_shot() ? desk.now->shown->rig.find(desk.linking) : nullptr;
  if (light == nullptr) return;
  const SurfaceBuffer& surface = desk.now->facts->surface;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const ScreenRect& rect = desk.view.rect();
  list.PushClipRect({rect.lo.x, rect.lo.y}, {rect.hi.x, rect.hi.y});
  std::vector<bool> lit(surface.object_names.size());
  for (std::size_t i = 1; i < lit.size(); ++i) lit[i] = lights_object(*light, surface.object_names[i]);
  const int step = std::max(3, static_cast<int>(9.0F * desk.theme.scale / desk.view.zoom()));
  for (int y = step / 2; y < surface.height; y += step) {
    for (int x = step / 2; x < surface.width; x += step) {
      const Vec2 at = desk.view.to_screen(Vec2(x, y));
      if (lit[surface.object[surface.index(x, y)]]) {
        list.AddCircleFilled({at.x, at.y}, desk.theme.px(1.3F), (paint_colors::kAccent & 0x00FFFFFFU) | 0xB0000000U, 8);
      }
    }
  }
  const std::string words = fmt::format("Click what {} shall light ({}).  Esc: done.", light->name, link_words(*light));
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const float pad = desk.theme.px(8.0F);
  const ImVec2 at(rect.center().x - 0.5F * size.x, rect.lo.y + 2.0F * pad);
  list.AddRectFilled({at.x - pad, at.y - 0.5F * pad}, {at.x + size.x + pad, at.y + size.y + 0.5F * pad},
                     IM_COL32(26, 26, 26, 230), pad);
  list.AddText(at, paint_colors::kText, words.c_str());
  list.PopClipRect();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (rect.contains({mouse.x, mouse.y})) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace luminist
