#pragma once
// paint/layer_stack.h -- strokes that can still be changed, in layers.
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "paint/paint_planes.h"
#include "paint/stroke.h"

namespace luminist {

/// A stroke with what its paint came from, so that it can be laid again whatever became of lights and files since.
struct KeptStroke {
  Stroke stroke;
  std::optional<Peak> peak = std::nullopt;        ///< that it repeats; none: it finds one of its own
  std::shared_ptr<const Image> source = nullptr;  ///< of a tool that copies, at the picture's size; null: to be had
};

struct PaintLayer {
  std::string name;  ///< no other layer of the stack has it
  bool visible = true;
  float opacity = 1.0F;  ///< in [0,1]: how much of what the layer makes of the picture below it is shown
  std::vector<std::uint32_t> strokes = {};  ///< numbers, in the order in which they are laid
};

/// The strokes of a canvas in layers. A stroke's number is its for good: it is what Target::stroke and verdicts say.
///
/// Layers are laid from the lowest to the highest, each over what those below it came to. An eraser takes away what its
/// own layer has put down; that of the lowest visible layer also reaches the ground. Hidden layers, and those of
/// opacity 0, are left out.
struct LayerStack {
  std::vector<PaintLayer> layers = {{.name = "Layer 1"}};              ///< lowest first, never empty
  std::map<std::uint32_t, std::shared_ptr<const KeptStroke>> strokes;  ///< each in one layer
  std::map<std::uint32_t, float> counts;      ///< importance of a stroke's pixels; 0: of those unpainted
  std::shared_ptr<const PaintPlanes> ground;  ///< paint under all layers whose strokes are not known; may be null
  std::size_t active = 0;                     ///< the layer that is painted on; a document does not keep it

  [[nodiscard]] bool shows(std::size_t layer) const { return layers[layer].visible && layers[layer].opacity > 0.0F; }
  [[nodiscard]] std::size_t lowest_shown() const;  ///< layers.size() if none is
  /// What is painted next goes onto the composite itself, because no other layer has any part in it.
  [[nodiscard]] bool lies_flat() const;
  [[nodiscard]] bool empty() const { return strokes.empty() && !ground; }
  [[nodiscard]] std::optional<std::size_t> find_layer(const std::string& name) const;
  [[nodiscard]] std::optional<std::size_t> layer_of(std::uint32_t stroke) const;
  /// "Layer 2", with a number that is free.
  [[nodiscard]] std::string unused_name() const;
};

/// Names that are there and differ, opacities in [0,1], every stroke in one layer, strokes that check_stroke() takes.
/// errors kBadContent naming layer or stroke.
Result<void> check_stack(const LayerStack& stack);

/// The active layer is shown. errors kUsage.
Result<void> check_paintable(const LayerStack& stack);

/// Strokes under a place of the picture (as a StrokePoint), the uppermost first: those of layers that are shown, whose
/// brush covers it. surface: of any size, of the same picture.
std::vector<std::uint32_t> strokes_under(const LayerStack& stack, const SurfaceBuffer& surface, const Vec2& place);

}  // namespace luminist
