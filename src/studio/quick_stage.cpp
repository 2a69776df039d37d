#include "studio/quick_stage.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace luminist {
namespace {

double pixels(const Shot& shot) {
  return static_cast<double>(shot.width) * static_cast<double>(shot.height);
}

Image at_size(const Image& image, int width, int height) {
  return image.empty() ? Image() : resized(image, width, height);
}

/// Those at the pixels' centres.
std::vector<std::uint32_t> resized_strokes(const std::vector<std::uint32_t>& strokes, const Image& large, int width,
                                           int height) {
  std::vector<std::uint32_t> small;
  small.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int from_x = (2 * x + 1) * large.width / (2 * width);
      const int from_y = (2 * y + 1) * large.height / (2 * height);
      small.push_back(strokes[large.index(from_x, from_y)]);
    }
  }
  return small;
}

/// Strokes are of no size; what they copy and what lies under them is.
LayerStack resized_layers(const LayerStack& layers, int width, int height) {
  LayerStack small = layers;
  if (layers.lies_flat()) {  // only what is painted next will be laid
    small = LayerStack();
    small.counts = layers.counts;
    return small;
  }
  std::map<const Image*, std::shared_ptr<const Image>> sources;
  for (auto& [number, kept] : small.strokes) {
    if (!kept->source) continue;
    std::shared_ptr<const Image>& source = sources[kept->source.get()];
    if (!source) source = std::make_shared<const Image>(at_size(*kept->source, width, height));
    KeptStroke copy = *kept;
    copy.source = source;
    kept = std::make_shared<const KeptStroke>(std::move(copy));
  }
  if (!layers.ground) return small;
  const PaintPlanes& ground = *layers.ground;
  small.ground = std::make_shared<const PaintPlanes>(PaintPlanes{
      at_size(ground.color, width, height), at_size(ground.left, width, height),
      resized_strokes(ground.stroke, ground.color, width, height), at_size(ground.importance, width, height)});
  return small;
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
  small.layers = resized_layers(paint.layers, width, height);
  small.target.stroke = resized_strokes(paint.target.stroke, paint.target.color, width, height);
  return small;
}

bool QuickStage::helps(const Shot& shot) {
  return luminist::pixels(shot) > 1.2 * QuickSize::kMost;
}

double QuickStage::pixels() const {
  return static_cast<double>(stage_->renderer->surface().pixels());
}

/// The hand's time counts, not the number of rounds: long ones, in which a light moves, answer most of what it did. The
/// longest of all compiled something, or waited for another program.
void QuickSize::note(double fixed, double growing, double pixels) {
  constexpr std::size_t kFewest = 6;
  constexpr std::size_t kMostRounds = 200;
  constexpr double kMemory = 3.0;              // seconds of the hand
  constexpr double kLongest = 4.0 * kSeconds;  // what took longer waited for something else
  constexpr double kShare = 2.0 / 3.0;         // of its time was answered so quickly
  const double left_for_pixels = std::max(kSeconds - fixed, 0.2 * kSeconds);
  rounds_.push_back({std::min(fixed + growing, kLongest), pixels * left_for_pixels / std::max(growing, 1e-4)});
  double all = 0.0;
  for (const Round& round : rounds_) all += round.seconds;
  const auto is_old = [&] { return rounds_.size() > kMostRounds || all - rounds_.front().seconds > kMemory; };
  for (; rounds_.size() > kFewest && is_old(); rounds_.pop_front()) all -= rounds_.front().seconds;
  if (rounds_.size() < kFewest) return;
  std::vector<Round> sorted(rounds_.begin(), rounds_.end());
  const auto longest = std::ranges::max_element(sorted, {}, &Round::seconds);
  all -= longest->seconds;
  sorted.erase(longest);
  std::ranges::sort(sorted, std::ranges::greater(), &Round::pixels);
  double left = kShare * all;
  auto round = sorted.begin();
  while (round + 1 != sorted.end() && (left -= round->seconds) > 0.0) ++round;
  best_ = std::clamp(round->pixels, kLeast, kMost);
}

Result<std::unique_ptr<QuickStage>> QuickStage::open(Device& device, const AssetRoots& roots, const Shot& shot,
                                                     double pixels, const std::filesystem::path& folder,
                                                     Diagnostics& diagnostics) {
  Shot small = shot;
  const double scale = std::sqrt(std::min(1.0, pixels / luminist::pixels(shot)));
  small.width = std::max(1, static_cast<int>(std::lround(scale * shot.width)));
  small.height = std::max(1, static_cast<int>(std::lround(scale * shot.height)));
  LUM_TRY(auto stage, open_stage(device, roots, small, folder, diagnostics));
  return std::unique_ptr<QuickStage>(new QuickStage(std::move(stage)));
}

Result<LivePainting> QuickStage::paint(const CanvasState& paint, const ParamState& in_force, const ParamState& start,
                                       std::vector<std::string> new_lights) const {
  Renderer& renderer = *stage_->renderer;
  LUM_TRY(Image picture, renderer.render(in_force));
  Canvas canvas(renderer.surface(), std::move(picture), [&renderer, in_force](ShadowPicture which) {
    return render_shadow_picture(renderer, in_force, which);
  });
  canvas.restore(resized_paint(paint, canvas.state()));
  return LivePainting(*stage_, std::move(canvas), start, std::move(new_lights), LivePainting::Options{});
}

}  // namespace luminist
