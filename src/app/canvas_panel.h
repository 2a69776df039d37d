#pragma once
// app/canvas_panel.h -- the picture, and the hand on it.
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/desk.h"
#include "app/hand_event.h"
#include "app/ink.h"
#include "app/light_handles.h"
#include "app/picture_texture.h"

namespace luminist {

class CanvasPanel {
 public:
  /// Takes what the hand did since the last frame and draws. The window's context is current.
  void draw(Desk& desk, const ScreenRect& rect, std::span<const HandEvent> events);
  /// Leaves a stroke that is under way; it is as if it had not begun. returns whether there was one.
  bool cancel_stroke(Desk& desk);

 private:
  enum class Grip { kNone, kStroke, kPan, kSize, kWipe, kPick, kLight, kMove };
  /// One picture on the screen, and what it was made of.
  struct Shown {
    PictureTexture texture;
    std::shared_ptr<const Image> picture;
    std::shared_ptr<const PaintedPictures> painted;
    std::shared_ptr<const ShotFacts> facts;
    std::uint32_t unanswered = 0;
    Channel channel = Channel::kLight;
    DisplayOptions display;
  };

  void take(Desk& desk, const HandEvent& event, bool hovered);
  void press(Desk& desk, const HandEvent& event);
  void move(Desk& desk, const HandEvent& event);
  void release(Desk& desk, const HandEvent& event);
  void begin_stroke(Desk& desk, const HandEvent& event);
  void add_point(const StrokePoint& point);
  void send_points(Desk& desk);
  void pick_color(Desk& desk, const Vec2& screen);
  void pick_clip(Desk& desk, const Vec2& screen);
  void refresh(const Desk& desk, Shown& shown, Channel channel);
  void refresh_kept(const Desk& desk);
  void draw_pictures(Desk& desk);
  void press_stroke(Desk& desk, const Vec2& screen);
  void release_stroke(Desk& desk);
  void draw_selected(const Desk& desk) const;
  void mark_stroke(const Desk& desk, std::uint32_t stroke) const;
  void draw_cursor(const Desk& desk);
  void draw_peak(const Desk& desk, const Vec2& screen) const;

  Shown front_;
  Shown paint_;  ///< on the left of a wipe
  std::unique_ptr<DisplayTable> table_;
  std::vector<std::uint32_t> codes_;
  Ink ink_;
  LightHandles handles_;
  Grip grip_ = Grip::kNone;
  Vec2 pointer_{0.0F};
  Vec2 grip_at_{0.0F};
  float grip_diameter_ = 0.0F;
  bool over_ = false;  ///< the pointer is over the canvas
  int mods_ = 0;
  std::vector<StrokePoint> unsent_;
  Vec2 steadied_{0.0F};     ///< where the stroke is, behind the pointer
  std::uint32_t next_ = 0;  ///< stroke below the one that was pressed; 0: none
  Vec2 moved_{0.0F};        ///< of the stroke that is dragged, in picture heights
};

/// Name of the object at a place of the picture, in pixels; "" where there is none.
std::string object_at(const ShotFacts& facts, const Vec2& picture);

}  // namespace luminist
