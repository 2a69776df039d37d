#include "paint/layer_composer.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "paint/open_stroke.h"

namespace luminist {
namespace {

Error of_stroke(Error error, std::uint32_t number) {
  error.field = fmt::format("strokes[{}].{}", number, error.field);
  return error;
}

void clear_left(const PlaneRefs& planes, const PixelBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    const auto row = planes.left->data.begin() + static_cast<std::ptrdiff_t>(planes.left->index(box.x0, y));
    std::fill_n(row, box.width(), 0.0F);
  }
}

}  // namespace

Result<LayerComposer> LayerComposer::create(const SurfaceBuffer& surface, const LayerStack& stack) {
  LayerComposer composer(surface, stack.lowest_shown());
  composer.ground_ = stack.ground;
  for (std::size_t i = 0; i < stack.layers.size(); ++i) {
    Layer layer{stack.shows(i), stack.layers[i].opacity, {}};
    for (const std::uint32_t number : stack.layers[i].strokes) {
      const std::shared_ptr<const KeptStroke>& kept = stack.strokes.at(number);
      auto mask = clip_mask(kept->stroke, surface);
      if (!mask) return of_stroke(std::move(mask).error(), number);
      auto gradient = Gradient::create(kept->stroke, surface, *mask, kept->peak);
      if (!gradient) return of_stroke(std::move(gradient).error(), number);
      layer.strokes.push_back({number, kept, std::move(*mask), std::move(*gradient)});
    }
    composer.layers_.push_back(std::move(layer));
  }
  return composer;
}

void LayerComposer::begin(const Image& before, PaintPlanes& planes) const {
  if (ground_) {
    planes = *ground_;
    return;
  }
  planes.color = before;
  planes.left = Image(before.width, before.height, 1);
  planes.stroke.assign(before.pixels(), 0);
  planes.importance = Image();
}

void LayerComposer::lay_layer(std::size_t layer, const PixelBox& box, const Image& before, const PlaneRefs& planes) {
  Underlay under{&before};
  if (layer != lowest_) {
    if (below_.color.empty()) begin(before, below_);
    copy_box(refs(planes), refs(below_), box);
    under = {&below_.color, &below_.stroke, below_.importance.empty() ? nullptr : &below_.importance};
    clear_left(planes, box);
  }
  for (const Ready& ready : layers_[layer].strokes) {
    const Stroke& stroke = ready.kept->stroke;
    const Coverage coverage = stroke.brush.bucket ? full_coverage(box)
                                                  : stroke_coverage(stroke.points, stroke.brush.diameter,
                                                                    surface_->width, surface_->height, box);
    const LaidStroke laid{&stroke.brush, ready.number, &ready.mask, &ready.gradient, ready.kept->source.get()};
    lay(*surface_, laid, coverage, under, planes);
  }
}

void LayerComposer::compose(std::size_t from, std::size_t to, const PixelBox& box, const Image& before,
                            const PlaneRefs& planes) {
  for (std::size_t i = from; i < to; ++i) {
    const Layer& layer = layers_[i];
    if (!layer.shown || layer.strokes.empty()) continue;
    const bool over = i != lowest_ || layer.opacity < 1.0F;
    if (over && below_.color.empty()) begin(before, below_);
    if (over) copy_box(refs(planes), refs(below_), box);
    lay_layer(i, box, before, planes);
    if (layer.opacity < 1.0F) mix_box(refs(std::as_const(below_)), planes, layer.opacity, box);
    if (i != lowest_) raise_left(below_, planes, box);
  }
}

}  // namespace luminist
