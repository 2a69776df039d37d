#pragma once
// app/ink.h -- the stroke under the hand before any picture holds it: drawn at once, roughly.
#include <imgui.h>

#include <cstdint>
#include <vector>

#include "app/canvas_view.h"
#include "paint/stroke.h"
#include "studio/studio_snapshot.h"

namespace luminist {

/// Points of strokes that the last snapshot does not show yet, as soft dabs in the brush's colour and opacity, times
/// the albedo under them where the brush asks for that. What gradient and clip make of them a snapshot shows.
class Ink {
 public:
  void begin(const Stroke& stroke);
  void extend(const StrokePoint& point);
  void end() { open_ = false; }
  /// Drops what a snapshot holds. Strokes are counted as the studio counts them.
  void settle(const StudioSnapshot& snapshot);
  void draw(ImDrawList& list, const CanvasView& view, const SurfaceBuffer& surface, float exposure) const;
  [[nodiscard]] bool empty() const { return strokes_.empty(); }

 private:
  struct Held {
    Brush brush;
    std::vector<StrokePoint> points;
    std::size_t shown = 0;  ///< of the points, by a snapshot
    std::uint64_t number = 0;
  };
  std::vector<Held> strokes_;
  std::uint64_t number_ = 0;  ///< strokes begun so far
  bool open_ = false;
};

}  // namespace luminist
