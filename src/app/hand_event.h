#pragma once
// app/hand_event.h -- what a hand did, as the window system told it: every point, not one a frame.
#include "base/math.h"

namespace luminist {

inline constexpr float kPrecise = 0.1F;  ///< of a drag, where it shall be precise

struct HandEvent {
  enum class Kind { kMove, kPress, kRelease, kScroll };
  Kind kind = Kind::kMove;
  Vec2 at{0.0F};        ///< pixels of the window
  int button = 0;       ///< GLFW's
  int mods = 0;         ///< GLFW's
  float scroll = 0.0F;  ///< notches, away from the hand
  float pressure = 1.0F;
  double time = 0.0;  ///< seconds of the window's clock
};

}  // namespace luminist
