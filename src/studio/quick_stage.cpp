#include "studio/quick_stage.h"

#include <cmath>
#include <utility>

namespace luminist {
namespace {

double pixels(const Shot& shot) {
  return static_cast<double>(shot.width) * static_cast<double>(shot.height);
}

Image at_size(const Image& image, int width, int height) {
  return image.empty() ? Image() : resized(image, width, height);
}

}  // namespace

CanvasState resized_paint(const CanvasState& paint, CanvasState fresh) {
  const int width = fresh.target.color.width;
  const int height = fresh.target.color.height;
  CanvasState small = std::move(fresh);
  small.importance.nu = paint.importance.nu;
  small.importance.delta = paint.importance.delta;
  small.importance.previous = at_size(paint.importance.previous, width, height);
  if (paint.strokes == 0) return small;
  small.importance.paint = at_size(paint.importance.paint, width, height);
  small.target.color = at_size(paint.target.color, width, height);
  small.target.before = at_size(paint.target.before, width, height);
  small.paint_left = at_size(paint.paint_left, width, height);
  small.strokes = paint.strokes;
  small.peak = paint.peak;
  const Image& large = paint.target.color;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int from_x = (2 * x + 1) * large.width / (2 * width);
      const int from_y = (2 * y + 1) * large.height / (2 * height);
      small.target.stroke[small.target.color.index(x, y)] = paint.target.stroke[large.index(from_x, from_y)];
    }
  }
  return small;
}

bool QuickStage::helps(const Shot& shot) {
  return pixels(shot) > 1.2 * kQuickPixels;
}

Result<std::unique_ptr<QuickStage>> QuickStage::open(Device& device, const AssetRoots& roots, const Shot& shot,
                                                     const std::filesystem::path& folder, Diagnostics& diagnostics) {
  Shot small = shot;
  const double scale = std::sqrt(std::min(1.0, kQuickPixels / pixels(shot)));
  small.width = std::max(1, static_cast<int>(std::lround(scale * shot.width)));
  small.height = std::max(1, static_cast<int>(std::lround(scale * shot.height)));
  LUM_TRY(auto stage, open_stage(device, roots, small, folder, diagnostics));
  return std::unique_ptr<QuickStage>(new QuickStage(std::move(stage)));
}

Result<LivePainting> QuickStage::paint(const CanvasState& paint, const ParamState& in_force, const ParamState& start,
                                       std::vector<std::string> new_lights) const {
  Renderer& renderer = *stage_->renderer;
  LUM_TRY(Image picture, renderer.render(in_force));
  Canvas canvas(renderer.surface(), std::move(picture),
                [&renderer, in_force] { return render_shadow_pair(renderer, in_force); });
  canvas.restore(resized_paint(paint, canvas.state()));
  return LivePainting(*stage_, std::move(canvas), start, std::move(new_lights), LivePainting::Options{});
}

}  // namespace luminist
