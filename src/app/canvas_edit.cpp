// The part of the canvas that takes up strokes which were painted before.
#include <algorithm>
#include <utility>

#include "app/canvas_panel.h"
#include "studio/paint_layers.h"

namespace luminist {
namespace {

constexpr float kClick = 3.0F;  // points that a hand may slip without dragging

}  // namespace

/// The uppermost stroke is selected; a click on the one that is selected goes to the next below it.
void CanvasPanel::press_stroke(Desk& desk, const Vec2& screen) {
  const StudioSnapshot& now = *desk.now;
  const Vec2 place = desk.view.to_picture(screen) / desk.view.picture_size().y;
  const std::vector<std::uint32_t> found = strokes_under(*now.layers, now.facts->surface, place);
  const auto held = std::find(found.begin(), found.end(), desk.selected_stroke);
  next_ = 0;
  moved_ = Vec2(0.0F);
  if (found.empty()) {
    desk.selected_stroke = 0;
    if (now.any_paint) desk.tell(StudioMessage::Kind::kNote, "there is no stroke here");
    return;
  }
  if (held == found.end()) {
    desk.selected_stroke = found.front();
  } else if (found.size() > 1) {
    next_ = held + 1 == found.end() ? found.front() : *(held + 1);
  }
  grip_ = Grip::kMove;
}

void CanvasPanel::release_stroke(Desk& desk) {
  const Vec2 by = std::exchange(moved_, Vec2(0.0F));
  const std::uint32_t next = std::exchange(next_, 0);
  const float dragged = glm::length(by) * desk.view.zoom() * desk.view.picture_size().y;
  if (dragged < desk.theme.px(kClick)) {
    if (next != 0) desk.selected_stroke = next;
    return;
  }
  const std::uint32_t stroke = desk.selected_stroke;
  desk.studio->repaint("move a stroke", [=](Session& session) { return session.layers().move(stroke, by); });
}

/// The way of the hand, and how wide the brush was; a bucket's dots.
void CanvasPanel::draw_selected(const Desk& desk) const {
  const KeptStroke* kept = desk.edited_stroke();
  if (kept == nullptr) return;
  const Stroke& stroke = kept->stroke;
  if (stroke.brush.bucket) mark_stroke(desk, desk.selected_stroke);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float height = desk.view.picture_size().y;
  std::vector<ImVec2> way;
  for (const StrokePoint& point : stroke.points) {
    const Vec2 at = desk.view.to_screen(height * (Vec2(point.x, point.y) + moved_));
    way.emplace_back(at.x, at.y);
  }
  const auto ring = [&](std::size_t i) {
    const float radius = 0.5F * stroke.brush.diameter * stroke.points[i].pressure * height * desk.view.zoom();
    list.AddCircle(way[i], radius + 1.0F, IM_COL32(0, 0, 0, 120), 0, 1.0F);
    list.AddCircle(way[i], radius, paint_colors::kAccent, 0, 1.0F);
  };
  if (way.empty()) return;
  const int count = static_cast<int>(way.size());
  list.AddPolyline(way.data(), count, IM_COL32(0, 0, 0, 160), 0, desk.theme.px(3.5F));
  list.AddPolyline(way.data(), count, paint_colors::kAccent, 0, desk.theme.px(1.5F));
  if (!stroke.brush.bucket) ring(0), ring(way.size() - 1);
  list.AddCircleFilled(way[0], desk.theme.px(4.0F), paint_colors::kAccent);
}

}  // namespace luminist
