#pragma once
// project/frame_paint.h -- the paint of cameras and frames that are not looked at: which have some, taking it away,
// giving it.
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "project/document.h"

namespace luminist {

/// What a picture is painted for.
struct Vantage {
  std::string camera;  ///< its name; "" where the scene has none
  double frame = 0.0;
  auto operator<=>(const Vantage&) const = default;
};

/// A vantage with strokes.
struct PaintedFrame {
  Vantage at;
  std::uint32_t strokes = 0;
  bool operator==(const PaintedFrame&) const = default;
};

/// All with strokes, by camera and frame; `present` is what is looked at. Its paint is at "paint/...", that of others
/// at "cameras/NAME/frames/FRAME/paint/..."; "frames/FRAME/paint/...", the older form, is of the present camera.
/// cost O(entries of the frames).
std::vector<PaintedFrame> painted_frames(const Document& document, const Vantage& present);

/// Puts the paint away as that of one vantage and takes out that of another; if there is none, none but nu and delta.
/// cost O(entries).
void turn_paint(Document& document, const Vantage& from, const Vantage& to);

/// The document as if a vantage were looked at: its paint is that of "paint/...".
Document at_vantage(const Document& document, const Vantage& present, const Vantage& vantage);

/// Puts "paint/..." of `paint` in place of what another vantage has.
void put_frame_paint(Document& document, const Vantage& present, const Vantage& vantage, const Document& paint);

/// Takes the strokes of another vantage away; what was important in its last solve stays. returns whether it had any.
bool clear_frame_paint(Document& document, const Vantage& present, const Vantage& vantage);

/// Forgets the paint of all, and what counted before; how much counts what is not painted stays as at the present one.
void forget_paint(Document& document);

}  // namespace luminist
