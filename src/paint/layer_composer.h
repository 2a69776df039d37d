#pragma once
// paint/layer_composer.h -- layers of strokes over one another.
#include <memory>
#include <vector>

#include "paint/layer_stack.h"

namespace luminist {

/// The strokes of a stack, ready to be laid again, whole or inside a box; the same bits either way. Copyable.
class LayerComposer {
 public:
  /// surface must outlive it. Sources are there already. errors kBadContent: an unknown clip object, a gradient that
  /// starts on no surface; with the stroke in the field.
  static Result<LayerComposer> create(const SurfaceBuffer& surface, const LayerStack& stack);

  /// planes become those below all layers: the picture before the paint, or the ground.
  void begin(const Image& before, PaintPlanes& planes) const;
  /// Lays the strokes of a layer, shown or not, over what `planes` hold of those below it, without its opacity; left
  /// is of this layer alone. before: the picture under all paint.
  void lay_layer(std::size_t layer, const PixelBox& box, const Image& before, const PlaneRefs& planes);
  /// Lays layers from..to - 1 as they are shown. cost for each O(pixels of its strokes inside the box).
  void compose(std::size_t from, std::size_t to, const PixelBox& box, const Image& before, const PlaneRefs& planes);

 private:
  struct Ready {
    std::uint32_t number = 0;
    std::shared_ptr<const KeptStroke> kept;
    ObjectMask mask;
    Gradient gradient;
  };
  struct Layer {
    bool shown = true;
    float opacity = 1.0F;
    std::vector<Ready> strokes;
  };
  LayerComposer(const SurfaceBuffer& surface, std::size_t lowest) : surface_(&surface), lowest_(lowest) {}

  const SurfaceBuffer* surface_;
  std::size_t lowest_;  ///< that is shown
  std::shared_ptr<const PaintPlanes> ground_;
  std::vector<Layer> layers_;
  PaintPlanes below_;  ///< what the layer that is laid lies on; empty until it is needed
};

}  // namespace luminist
