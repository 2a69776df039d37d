#pragma once
// paint/open_stroke.h -- a stroke whose points still arrive, and the paint as it was before it.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "paint/coverage.h"
#include "paint/gradient.h"
#include "paint/stroke.h"

namespace luminist {

/// What Canvas keeps from begin_stroke() to end_stroke().
struct OpenStroke {
  Stroke stroke;  ///< with the points so far
  std::string folder;
  ObjectMask mask;
  Image copied;                      ///< what PaintTool::kCopy paints with
  std::optional<Gradient> gradient;  ///< none until its start is known
  Coverage coverage;                 ///< of all points; its box is the picture
  PixelBox reached;                  ///< by any point so far

  // As it was before the stroke; the importance paint is empty where there was none.
  Image color;
  Image paint_left;
  Image importance_paint;
  std::vector<std::uint32_t> stroke_ids;
  std::optional<Peak> peak;
};

/// The objects that a stroke may touch. errors kBadContent: an unknown clip object, "@" where there is none.
Result<ObjectMask> clip_mask(const Stroke& stroke, const SurfaceBuffer& surface);

}  // namespace luminist
