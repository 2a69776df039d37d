#pragma once
// project/frame_paint.h -- the paint of the frames that are not looked at: which have some, taking it away, giving it.
#include <cstdint>
#include <vector>

#include "project/document.h"

namespace luminist {

/// A frame with strokes.
struct PaintedFrame {
  double frame = 0.0;
  std::uint32_t strokes = 0;
  bool operator==(const PaintedFrame&) const = default;
};

/// All frames with strokes, ascending; `present` is the one that is looked at. cost O(entries of the frames).
std::vector<PaintedFrame> painted_frames(const Document& document, double present);

/// The document as if a frame were looked at: its paint is that of "paint/...".
Document at_frame(const Document& document, double present, double frame);

/// Puts "paint/..." of `paint` in place of what another frame has.
void put_frame_paint(Document& document, double frame, const Document& paint);

/// Takes the strokes of another frame away; what was important in its last solve stays. returns whether it had any.
bool clear_frame_paint(Document& document, double frame);

}  // namespace luminist
