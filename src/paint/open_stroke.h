#pragma once
// paint/open_stroke.h -- a stroke whose points still arrive, and the paint as it was before it.
#include <memory>
#include <optional>
#include <string>

#include "paint/coverage.h"
#include "paint/gradient.h"
#include "paint/paint_planes.h"
#include "paint/stroke.h"

namespace luminist {

/// What Canvas keeps from begin_stroke() to end_stroke().
struct OpenStroke {
  Stroke stroke;  ///< with the points so far
  ObjectMask mask;
  std::shared_ptr<const Image> source;  ///< of a tool that copies
  std::optional<Gradient> gradient;     ///< none until its start is known
  Coverage coverage;                    ///< of all points; its box is the picture
  PixelBox reached;                     ///< by any point so far

  // The layer, and the peak, as they were before the stroke.
  PaintPlanes saved;
  std::optional<Peak> peak;
};

/// The objects that a stroke may touch. errors kBadContent: an unknown clip object, "@" where there is none.
Result<ObjectMask> clip_mask(const Stroke& stroke, const SurfaceBuffer& surface);

}  // namespace luminist
