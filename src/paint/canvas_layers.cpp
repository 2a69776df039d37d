// The part of a canvas that knows its layers.
#include <utility>

#include <fmt/format.h>

#include "base/check.h"
#include "paint/canvas.h"

namespace luminist {
namespace {

bool copies(const Brush& brush) {
  return brush.tool == PaintTool::kCopy || brush.tool == PaintTool::kShadow || brush.tool == PaintTool::kShadowEraser;
}

}  // namespace

PlaneRefs Canvas::composite() {
  return {&state_.target.color, &state_.paint_left, &state_.target.stroke, &state_.importance.paint};
}

Underlay Canvas::underlay() const {
  if (!work_ || state_.layers.active == state_.layers.lowest_shown()) return {&state_.target.before};
  const PaintPlanes& below = work_->below;
  return {&below.color, &below.stroke, below.importance.empty() ? nullptr : &below.importance};
}

/// The active layer can be painted on from here on.
Result<void> Canvas::prepare_layer() {
  const LayerStack& stack = state_.layers;
  LUM_TRY_VOID(check_paintable(stack));
  if (stack.lies_flat()) {
    work_.reset();
    return {};
  }
  if (work_) return {};
  LUM_TRY(LayerComposer composer, LayerComposer::create(*surface_, stack));
  const Image& before = state_.target.before;
  LayerWork work{std::move(composer), {}, {}};
  work.composer.begin(before, work.below);
  work.composer.compose(0, stack.active, everywhere(), before, refs(work.below));
  work.top = work.below;
  work.composer.lay_layer(stack.active, everywhere(), before, refs(work.top));
  work_ = std::move(work);
  return {};
}

/// The composite follows what was laid on the active layer inside the box.
void Canvas::show(const PixelBox& box) {
  if (work_) {
    const LayerStack& stack = state_.layers;
    const PlaneRefs shown = composite();
    copy_box(refs(std::as_const(work_->top)), shown, box);
    const float opacity = stack.layers[stack.active].opacity;
    if (opacity < 1.0F) mix_box(refs(std::as_const(work_->below)), shown, opacity, box);
    if (stack.active != stack.lowest_shown()) raise_left(work_->below, shown, box);
    work_->composer.compose(stack.active + 1, stack.layers.size(), box, state_.target.before, shown);
  }
  refresh_importance(box);
}

/// What the stroke copies and the peak that it repeats, where they are not known yet.
Result<void> Canvas::complete(KeptStroke& stroke, const std::string& folder) {
  const Brush& brush = stroke.stroke.brush;
  if (!repeats_peak(brush)) stroke.peak.reset();
  if (repeats_peak(brush) && !stroke.peak) stroke.peak = state_.peak;
  if (!copies(brush)) stroke.source.reset();
  if (stroke.source) return {};
  LUM_TRY(stroke.source, source_of(brush, folder));
  return {};
}

/// The stroke that was laid last belongs to the active layer.
void Canvas::keep(KeptStroke stroke) {
  LayerStack& stack = state_.layers;
  stack.layers[stack.active].strokes.push_back(state_.strokes);
  stack.strokes[state_.strokes] = std::make_shared<const KeptStroke>(std::move(stroke));
}

void Canvas::choose_layer(std::size_t layer) {
  LUM_CHECK(!open_, "a stroke stays on its layer");
  LUM_CHECK(layer < state_.layers.layers.size(), "a layer of the stack is chosen");
  if (state_.layers.active == layer) return;
  state_.layers.active = layer;
  work_.reset();
}

Result<void> Canvas::relayer(LayerStack layers, const std::string& folder) {
  LUM_CHECK(!open_, "a stroke has come to its end");
  LUM_CHECK(layers.active < layers.layers.size(), "one of the layers is active");
  LUM_TRY_VOID(check_stack(layers));
  for (auto& [number, kept] : layers.strokes) {
    KeptStroke whole = *kept;
    auto completed = complete(whole, folder);
    if (!completed) {
      Error error = std::move(completed).error();
      error.field = fmt::format("strokes[{}].{}", number, error.field);
      return error;
    }
    kept = std::make_shared<const KeptStroke>(std::move(whole));
  }
  LUM_TRY(LayerComposer composer, LayerComposer::create(*surface_, layers));
  PaintPlanes planes;
  composer.begin(state_.target.before, planes);
  composer.compose(0, layers.layers.size(), everywhere(), state_.target.before, refs(planes));
  state_.target.color = std::move(planes.color);
  state_.target.stroke = std::move(planes.stroke);
  state_.paint_left = std::move(planes.left);
  state_.importance.paint = std::move(planes.importance);
  state_.layers = std::move(layers);
  if (state_.layers.empty()) state_.strokes = 0, state_.peak.reset();
  work_.reset();
  refresh_importance(everywhere());
  return {};
}

}  // namespace luminist
