#include "app/canvas_view.h"

namespace luminist {

void CanvasView::place(const ScreenRect& rect, int width, int height) {
  const Vec2 size(std::max(width, 1), std::max(height, 1));
  if (size != size_) fitted_ = true;
  rect_ = rect;
  size_ = size;
  if (!fitted_) return;
  constexpr float kMargin = 12.0F;  // pixels of the screen that stay free around a picture that fills it
  const Vec2 room = glm::max(rect.size() - Vec2(2.0F * kMargin), Vec2(16.0F));
  zoom_ = std::clamp(std::min(room.x / size.x, room.y / size.y), kLeastZoom, kMostZoom);
  center_ = 0.5F * size;
}

void CanvasView::zoom_to(float zoom, const Vec2& screen) {
  const Vec2 held = to_picture(screen);
  zoom_ = std::clamp(zoom, kLeastZoom, kMostZoom);
  center_ = held - (screen - rect_.center()) / zoom_;
  fitted_ = false;
  pan(Vec2(0.0F));
}

void CanvasView::pan(const Vec2& screen_delta) {
  if (screen_delta != Vec2(0.0F)) fitted_ = false;
  center_ = glm::clamp(center_ - screen_delta / zoom_, Vec2(0.0F), size_);  // some of it stays in sight
}

}  // namespace luminist
