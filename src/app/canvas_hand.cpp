// The part of the canvas that follows the hand.
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/canvas_panel.h"
#include "app/materials_panel.h"

namespace luminist {
namespace {

StrokePoint stroke_point(const CanvasView& view, const HandEvent& event) {
  const Vec2 at = view.to_picture(event.at) / view.picture_size().y;
  return {at.x, at.y, event.pressure};
}

}  // namespace

void CanvasPanel::take(Desk& desk, const HandEvent& event, bool hovered) {
  pointer_ = event.at;
  mods_ = event.mods;
  switch (event.kind) {
    case HandEvent::Kind::kMove:
      return move(desk, event);
    case HandEvent::Kind::kPress:
      if (hovered && desk.view.rect().contains(event.at)) press(desk, event);
      return;
    case HandEvent::Kind::kRelease:
      return release(desk, event);
    case HandEvent::Kind::kScroll:
      constexpr float kNotch = 1.2F;
      if (!hovered || !desk.view.rect().contains(event.at) || handles_.scroll(desk, event.at, event.scroll)) return;
      desk.view.zoom_by(std::pow(kNotch, event.scroll), event.at);
      return;
  }
}

void CanvasPanel::press(Desk& desk, const HandEvent& event) {
  if (grip_ != Grip::kNone) return;
  grip_at_ = event.at;
  if (event.button == GLFW_MOUSE_BUTTON_MIDDLE || desk.space_down) {
    grip_ = Grip::kPan;
    return;
  }
  if (event.button != GLFW_MOUSE_BUTTON_LEFT) return;
  if (desk.pick_clip) return pick_clip(desk, event.at);
  if (std::exchange(desk.pick_material, false)) return choose_material(desk, desk.view.to_picture(event.at));
  if (handles_.press(desk, event.at)) {
    grip_ = Grip::kLight;
    return;
  }
  const float line = desk.view.to_screen(Vec2(desk.wipe_at * desk.view.picture_size().x, 0.0F)).x;
  if (desk.wipe && std::abs(event.at.x - line) < desk.theme.px(8.0F)) {
    grip_ = Grip::kWipe;
  } else if (desk.box.tool() == Tool::kPick || event.mods == desk.keys().pick_mods) {
    grip_ = Grip::kPick;
    pick_color(desk, event.at);
  } else if (desk.box.tool() == Tool::kEdit) {
    press_stroke(desk, event.at);
  } else if (event.mods == GLFW_MOD_SHIFT) {
    grip_ = Grip::kSize;
    grip_diameter_ = desk.box.brush().diameter;
  } else {
    begin_stroke(desk, event);
  }
}

void CanvasPanel::begin_stroke(Desk& desk, const HandEvent& event) {
  desk.hush();
  const Stroke stroke{desk.box.ready(), {stroke_point(desk.view, event)}};
  if (stroke.brush.tool == PaintTool::kCopy && stroke.brush.copy_from.empty()) {
    return desk.tell(StudioMessage::Kind::kNote, "choose an image to copy from first (left panel)");
  }
  if (stroke.brush.clip == "@" && object_at(*desk.now->facts, desk.view.to_picture(event.at)).empty()) {
    return desk.tell(StudioMessage::Kind::kNote, "there is no object here; begin on one, or set Stay on: anything");
  }
  const bool first = desk.now->shown->rig.lights.empty() && stroke.brush.tool == PaintTool::kColor;
  if (first) add_light(desk, true);
  desk.handles_aside = true;
  desk.studio->begin_stroke(stroke, std::filesystem::current_path());
  ink_.begin(stroke);
  if (stroke.brush.bucket) return ink_.end();
  grip_ = Grip::kStroke;
  steadied_ = event.at;
}

void CanvasPanel::move(Desk& desk, const HandEvent& event) {
  switch (grip_) {
    case Grip::kStroke: {
      HandEvent steadied = event;
      steadied_ = glm::mix(event.at, steadied_, 0.92F * desk.box.steadiness());
      steadied.at = steadied_;
      return add_point(stroke_point(desk.view, steadied));
    }
    case Grip::kPan:
      desk.view.pan(event.at - std::exchange(grip_at_, event.at));
      return;
    case Grip::kSize: {
      const float pixels = desk.view.picture_size().y * desk.view.zoom();
      desk.box.brush().diameter = grip_diameter_;
      desk.box.scale_diameter(std::max(0.01F, 1.0F + 2.0F * (event.at.x - grip_at_.x) / (grip_diameter_ * pixels)));
      return;
    }
    case Grip::kWipe: {
      const float x = desk.view.to_picture(event.at).x / desk.view.picture_size().x;
      desk.wipe_at = std::clamp(x, 0.0F, 1.0F);
      return;
    }
    case Grip::kPick:
      return pick_color(desk, event.at);
    case Grip::kMove:
      moved_ = (event.at - grip_at_) / (desk.view.zoom() * desk.view.picture_size().y);
      return;
    case Grip::kLight:
      return handles_.move(desk, event.at, event.mods == GLFW_MOD_SHIFT);
    case Grip::kNone:
      return;
  }
}

void CanvasPanel::add_point(const StrokePoint& point) {
  unsent_.push_back(point);
  ink_.extend(point);
}

void CanvasPanel::release(Desk& desk, const HandEvent& event) {
  if (grip_ == Grip::kStroke) {
    if (desk.box.steadiness() > 0.0F) add_point(stroke_point(desk.view, event));  // it catches up with the pointer
    send_points(desk);
    desk.studio->end_stroke();
    ink_.end();
  }
  if (grip_ == Grip::kMove) release_stroke(desk);
  handles_.release(desk);
  if (grip_ == Grip::kPick && desk.box.tool() == Tool::kPick) desk.box.take_last();
  grip_ = Grip::kNone;
}

void CanvasPanel::send_points(Desk& desk) {
  if (!unsent_.empty()) desk.studio->extend_stroke(std::exchange(unsent_, {}));
}

bool CanvasPanel::cancel_stroke(Desk& desk) {
  if (grip_ != Grip::kStroke) return false;
  grip_ = Grip::kNone;
  unsent_.clear();
  ink_.end();
  desk.studio->post("leave the stroke", [](Workbench& bench) -> Result<void> {
    if (bench.has_session()) bench.cancel_stroke();
    return {};
  });
  return true;
}

void CanvasPanel::pick_color(Desk& desk, const Vec2& screen) {
  const Vec2 at = desk.view.to_picture(screen);
  choose_material(desk, at);
  const Image& painted = desk.now->painted->color;
  const bool small = !desk.now->picture->same_size(painted);  // while the brush moves
  const Image& image = desk.channel == Channel::kPaint || small ? painted : *desk.now->picture;
  const int x = static_cast<int>(std::floor(at.x));
  const int y = static_cast<int>(std::floor(at.y));
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  desk.box.set_color(image.rgb(image.index(x, y)));
}

void CanvasPanel::pick_clip(Desk& desk, const Vec2& screen) {
  const std::string object = object_at(*desk.now->facts, desk.view.to_picture(screen));
  desk.pick_clip = false;
  choose_material(desk, desk.view.to_picture(screen));
  if (!object.empty()) desk.box.brush().clip = object;
}

}  // namespace luminist
