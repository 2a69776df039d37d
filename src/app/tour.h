#pragma once
// app/tour.h -- the first steps, told one after another on the canvas as they are done.
#include "app/desk.h"

namespace luminist {

/// What to do next; each step goes when it was done. Told once: it is remembered that somebody went through, or closed
/// it.
class Tour {
 public:
  Tour();
  /// Over the lower edge of the canvas.
  void draw(Desk& desk, const ScreenRect& canvas);

 private:
  void advance(const Desk& desk);
  void finish();
  int step_ = 0;
};

}  // namespace luminist
