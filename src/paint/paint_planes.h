#pragma once
// paint/paint_planes.h -- paint as pixels: what a stroke is laid on, and how it is laid.
#include <cstdint>
#include <vector>

#include "base/image.h"
#include "paint/coverage.h"
#include "paint/gradient.h"
#include "paint/stroke.h"
#include "render/surface_buffer.h"

namespace luminist {

/// All of one size, but for the importance paint, which is empty where there is none.
struct PaintPlanes {
  Image color;                        ///< 3 channels
  Image left;                         ///< 1 channel: 1 where painted, less where the eraser went since, 0 where never
  std::vector<std::uint32_t> stroke;  ///< number of the last stroke on a pixel; 0: unpainted
  Image importance;                   ///< 2 channels: value x weight, weight
};

/// The same planes wherever they are kept.
struct PlaneRefs {
  Image* color;
  Image* left;
  std::vector<std::uint32_t>* stroke;
  Image* importance;
};
struct ConstPlaneRefs {
  const Image* color;
  const Image* left;
  const std::vector<std::uint32_t>* stroke;
  const Image* importance;
};
PlaneRefs refs(PaintPlanes& planes);
ConstPlaneRefs refs(const PaintPlanes& planes);
ConstPlaneRefs refs(const PlaneRefs& planes);

/// Copies the pixels of a box. cost O(pixels of it).
void copy_box(const ConstPlaneRefs& from, const PlaneRefs& to, const PixelBox& box);
/// to = below + opacity (to - below) inside a box, so that what is equal stays so: colours and importance; strokes stay
/// those of `to`.
void mix_box(const ConstPlaneRefs& below, const PlaneRefs& to, float opacity, const PixelBox& box);

/// Paint is left inside a box wherever it is in one of the two. to: PaintPlanes::left
void raise_left(const PaintPlanes& below, const PlaneRefs& to, const PixelBox& box);

/// What an eraser goes back to; strokes and importance may be null: none.
struct Underlay {
  const Image* color = nullptr;
  const std::vector<std::uint32_t>* stroke = nullptr;
  const Image* importance = nullptr;
};

/// A stroke, with what it takes to lay it anywhere. Pointers outlive the call.
struct LaidStroke {
  const Brush* brush = nullptr;
  std::uint32_t number = 0;
  const ObjectMask* mask = nullptr;
  const Gradient* gradient = nullptr;
  const Image* source = nullptr;  ///< of a tool that copies, at the picture's size
};

/// Composites a stroke once, as much as the coverage says of it. cost O(pixels of the coverage's box).
void lay(const SurfaceBuffer& surface, const LaidStroke& stroke, const Coverage& coverage, const Underlay& under,
         const PlaneRefs& planes);

}  // namespace luminist
