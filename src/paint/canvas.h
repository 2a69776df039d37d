#pragma once
// paint/canvas.h -- the picture that is painted on, and the target and importance that come of it.
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "paint/copy_source.h"
#include "paint/coverage.h"
#include "paint/gradient.h"
#include "paint/importance.h"
#include "paint/layer_composer.h"
#include "paint/layer_stack.h"
#include "paint/open_stroke.h"
#include "paint/stroke.h"
#include "render/surface_buffer.h"
#include "render/target.h"

namespace luminist {

/// What the shadow brush and eraser copy from (paper, section 4.2).
enum class ShadowPicture : std::uint8_t {
  kFreeLightsOff,  ///< the scene with all modifiable lights turned off: of the brush
  kShadowsOff,     ///< all lights on, no shadows: of the eraser
};

/// Everything that paint made, as plain values and images: what a document stores and undo puts back.
struct CanvasState {
  Target target;              ///< its stroke ids are the numbers of strokes, from 1 after a rebase
  Image paint_left;           ///< 1 channel: 1 where painted, less where the eraser went since, 0 where never
  ImportanceMap importance;   ///< target.importance follows from it
  std::uint32_t strokes = 0;  ///< the last number that was given to a stroke since the last rebase
  std::optional<Peak> peak;   ///< of the last stroke with a gradient by normals
  LayerStack layers;          ///< what the above is the composite of

  /// What a pixel counts.
  [[nodiscard]] float importance_at(std::size_t pixel) const;
};

/// Paint on one picture between two accepted solves. Copyable: a copy is a snapshot.
///
/// A pixel counts as painted where a stroke covers it with at least kPaintEdge, that is inside the brush's circle,
/// whatever the opacity: a faint glaze is as deliberate as a thick one, while a gaussian's tail is not paint. There its
/// importance is 1 and not a fraction, as in the paper: the soft edge inside the circle is part of what is asked for.
/// The background (object 0) has no albedo and no normal, and the formulas take them as zero: paint that behaves like
/// light (texture or gradient 1) leaves it black as any light would; plain paint shows.
class Canvas {
 public:
  /// Called when a picture is needed, at most once each until they change.
  using ShadowSource = std::function<Result<Image>(ShadowPicture)>;

  /// surface must outlive the canvas; picture has its size, 3 channels. images reads what PaintTool::kCopy names.
  Canvas(const SurfaceBuffer& surface, Image picture, ShadowSource shadow_source);
  Canvas(const SurfaceBuffer& surface, Image picture, ShadowSource shadow_source, ImageReader images);

  /// Composites one stroke on the active layer: within it coverage is the maximum of its dabs, composited once. folder
  /// is where copy_from is looked for. returns the box of the pixels that may have changed.
  /// errors kBadContent: check_stroke(), an unknown clip object (nearest name), a gradient that starts on no surface;
  /// load_copy_source()'s; the shadow source's; kUsage: the layer is hidden. The canvas is unchanged then.
  /// cost O(pixels under the stroke), times the strokes above it; a copy reads its image, the first shadow stroke
  /// renders a picture, the first stroke among other layers lays them all.
  Result<PixelBox> apply(const Stroke& stroke, const std::string& folder);

  /// nu and delta, then every stroke. path is the file's: for messages, and copies are looked for beside it.
  /// errors those of a stroke with its index in the field; nothing is changed then.
  Result<void> apply(const StrokeFile& file, const std::string& path);

  /// A stroke whose points still arrive; not a bucket. It begins with the points that it has so far; at any time the
  /// canvas is, bit for bit, what apply() of the points so far makes of it. Until a gradient's start is known nothing
  /// is laid. Ends with end_stroke(); other calls that change the canvas wait until then.
  /// returns the box of the pixels that may have changed. errors as apply(); the canvas is unchanged then.
  /// cost begin: a copy of the paint; extend: O(pixels under the new points), with a screen gradient under all.
  Result<PixelBox> begin_stroke(const Stroke& stroke, const std::string& folder);
  Result<PixelBox> extend_stroke(std::span<const StrokePoint> points);
  /// errors kBadContent if the gradient found no start; the canvas is as before the stroke then.
  Result<void> end_stroke();

  /// The layer that takes what is painted next. layer < layers.size()
  void choose_layer(std::size_t layer);
  /// Other layers and strokes in place of those that there are: the target is composited anew. What strokes copy and
  /// the peak that they repeat is found where it is not known yet. folder: as in apply(). errors check_stack()'s,
  /// LayerComposer's, those of sources; nothing is changed then. cost every stroke.
  Result<void> relayer(LayerStack layers, const std::string& folder);

  /// Importance of what is not painted: I = (1 - delta) nu + delta I_p, both in [0,1]. cost O(pixels).
  void set_importance(float nu, float delta);

  [[nodiscard]] const Target& target() const { return state_.target; }
  [[nodiscard]] bool painted() const;  ///< any pixel painted in colour since the last rebase

  /// A solve was accepted: its picture is what is painted on next, and the importance map becomes the previous one.
  void rebase(Image picture);

  [[nodiscard]] const CanvasState& state() const { return state_; }
  /// Puts back a state of a canvas of the same size; target.importance is made anew. cost O(pixels).
  void restore(CanvasState state);

  /// What the shadow brush or its eraser copies from is there before a stroke waits for it. Nothing for other tools.
  /// errors the shadow source's. cost a picture, unless it is known.
  Result<void> ready_shadows(PaintTool tool);
  [[nodiscard]] bool has_shadows(PaintTool tool) const { return shadows_of(tool) != nullptr; }
  /// What either canvas asks for serves both, until one is rebased.
  /// of: a canvas of the same lights on the same picture.
  void share_shadows(const Canvas& of) { shadow_pictures_ = of.shadow_pictures_; }

 private:
  /// The active layer by itself, where the composite is more than that.
  struct LayerWork {
    LayerComposer composer;
    PaintPlanes below;  ///< what the layer lies on
    PaintPlanes top;    ///< the layer over it, without its opacity
  };
  Result<void> prepare_layer();
  [[nodiscard]] PlaneRefs composite();
  [[nodiscard]] PlaneRefs top() { return work_ ? refs(work_->top) : composite(); }
  [[nodiscard]] Underlay underlay() const;
  void show(const PixelBox& box);
  Result<PixelBox> lay_open(std::span<const StrokePoint> points);
  [[nodiscard]] std::shared_ptr<const Image>& shadows_of(PaintTool tool) const;
  Result<std::shared_ptr<const Image>> source_of(const Brush& brush, const std::string& folder);
  Result<void> complete(KeptStroke& stroke, const std::string& folder);
  void keep(KeptStroke stroke);
  void refresh_importance(const PixelBox& box);
  void begin(Image picture);

  using ShadowPictures = std::array<std::shared_ptr<const Image>, 2>;
  [[nodiscard]] PixelBox everywhere() const { return {0, 0, surface_->width, surface_->height}; }

  const SurfaceBuffer* surface_;
  ShadowSource shadow_source_;
  ImageReader images_;
  std::shared_ptr<ShadowPictures> shadow_pictures_ = std::make_shared<ShadowPictures>();  ///< shared by copies
  CanvasState state_;
  std::optional<LayerWork> work_;  ///< made when it is needed
  std::optional<OpenStroke> open_;
};

}  // namespace luminist
