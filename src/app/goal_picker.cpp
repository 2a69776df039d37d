#include "app/goal_picker.h"

#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "studio/drag_goal.h"

namespace luminist {
namespace {

Vec2 in_heights(const Desk& desk, const Vec2& screen) {
  return desk.view.to_picture(screen) / desk.view.picture_size().y;
}

}  // namespace

void GoalPicker::begin_goal(Desk& desk, const Vec2& to) {
  Drag drag;
  drag.what = desk.goal == DragGoal::kShadow ? Drag::What::kShadow : Drag::What::kHighlight;
  drag.from = in_heights(desk, *from_);
  drag.to = in_heights(desk, to);
  if (desk.now->shown->rig.find(desk.selected) != nullptr) drag.light = desk.selected;
  desk.studio->post("find what was dragged", [drag, studio = desk.studio](Workbench& bench) -> Result<void> {
    if (!bench.has_session() || studio->cancelled()) return {};  // Esc ends the drags that wait, too
    std::string light;
    LUM_TRY_VOID(bench.act([&](Session& session) -> Result<void> {
      LUM_TRY(light, start_drag(session, drag, {}, [studio] { return !studio->cancelled(); }));
      return {};
    }));
    const char* what = drag.what == Drag::What::kShadow ? "the shadow of " : "the highlight of ";
    studio->tell({StudioMessage::Kind::kNote, "solving for " + (what + light) + "; Enter accepts", "", ""});
    bench.after_solve([drag, studio, light](Session& session) -> Result<void> {
      LUM_TRY(std::string words, drag_words(session, drag, light));
      if (!words.empty()) studio->tell({StudioMessage::Kind::kWarning, std::move(words), "", ""});
      return {};
    });
    return {};
  });
}

std::vector<HandEvent> GoalPicker::take(Desk& desk, std::span<const HandEvent> events) {
  std::vector<HandEvent> left(events.begin(), events.end());
  if (!desk.has_shot() || desk.goal == DragGoal::kNone) {
    from_.reset();
    return left;
  }
  const bool covered = desk.question != Question::kNone ||
                       ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  std::erase_if(left, [&](const HandEvent& event) {
    at_ = event.at;
    if (event.kind == HandEvent::Kind::kRelease && from_) {
      if (glm::length(event.at - *from_) > desk.theme.px(6.0F)) begin_goal(desk, event.at);
      from_.reset();
      return true;
    }
    const bool press = event.kind == HandEvent::Kind::kPress && event.button == GLFW_MOUSE_BUTTON_LEFT &&
                       !desk.space_down && !covered && desk.view.rect().contains(event.at);
    if (press) from_ = event.at;
    return press;
  });
  return left;
}

void GoalPicker::draw(Desk& desk) const {
  if (!desk.has_shot() || desk.goal == DragGoal::kNone) return;
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const ScreenRect& rect = desk.view.rect();
  list.PushClipRect({rect.lo.x, rect.lo.y}, {rect.hi.x, rect.hi.y});
  const float radius = desk.theme.px(9.0F);
  if (from_) {
    list.AddLine({from_->x, from_->y}, {at_.x, at_.y}, IM_COL32(0, 0, 0, 180), desk.theme.px(3.5F));
    list.AddLine({from_->x, from_->y}, {at_.x, at_.y}, paint_colors::kAccent, desk.theme.px(1.5F));
    list.AddCircle({from_->x, from_->y}, radius, paint_colors::kAccent, 24, 1.5F);
    list.AddCircleFilled({at_.x, at_.y}, desk.theme.px(4.0F), paint_colors::kAccent);
  }
  const char* words = desk.goal == DragGoal::kShadow
                          ? "Drag the edge of a shadow to where it shall be; a light is found for it.  Esc: done."
                          : "Drag a highlight to where it shall be; a light is found for it.  Esc: done.";
  const ImVec2 size = ImGui::CalcTextSize(words);
  const float pad = desk.theme.px(8.0F);
  const ImVec2 at(rect.center().x - 0.5F * size.x, rect.lo.y + 2.0F * pad);
  list.AddRectFilled({at.x - pad, at.y - 0.5F * pad}, {at.x + size.x + pad, at.y + size.y + 0.5F * pad},
                     IM_COL32(26, 26, 26, 230), pad);
  list.AddText(at, paint_colors::kText, words);
  list.PopClipRect();
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (rect.contains({mouse.x, mouse.y})) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace luminist
