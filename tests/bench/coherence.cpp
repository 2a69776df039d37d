#include "bench/coherence.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include <fmt/format.h>

#include "bench/bench_scene.h"

namespace luminist {
namespace {

/// A frame: what is seen, its picture, and how to find its surface points again.
struct Frame {
  SurfaceBuffer surface;
  Image picture;
  std::vector<Mat4> world_from_object;
  Mat4 clip_from_world{1.0F};
};

struct Change {
  double followed = 0.0;  ///< mean |change| of luminance at the same surface point
  double at_pixel = 0.0;  ///< and at the same pixel
  double motion = 0.0;    ///< mean, pixels
  std::size_t points = 0;
};

Result<Frame> draw(Device& device, const AssetRoots& roots, const Shot& shot, std::unique_ptr<Stage>& stage) {
  Diagnostics diagnostics;
  LUM_TRY(stage, open_stage(device, roots, shot, ".", diagnostics, stage ? stage->moving : nullptr));
  LUM_TRY(const ParamState state, starting_state(*stage, roots, shot, "."));
  Frame frame;
  LUM_TRY(frame.picture, stage->renderer->render(state));
  frame.surface = stage->renderer->surface();
  const Scene& scene = *stage->moving;
  for (const Object& object : scene.objects) frame.world_from_object.push_back(object.world_from_object);
  frame.clip_from_world =
      scene.cameras.front().clip_from_world(static_cast<float>(shot.width) / static_cast<float>(shot.height));
  return frame;
}

float luminance(const Image& image, std::size_t pixel) {
  return glm::dot(image.rgb(pixel), Vec3(0.2126F, 0.7152F, 0.0722F));
}

/// Bilinear between the centres of pixels; nothing at the border.
std::optional<float> luminance_at(const Image& image, const Vec2& place) {
  const Vec2 at = place - 0.5F;
  const int x = static_cast<int>(std::floor(at.x));
  const int y = static_cast<int>(std::floor(at.y));
  if (x < 0 || y < 0 || x + 1 >= image.width || y + 1 >= image.height) return std::nullopt;
  const Vec2 t = at - Vec2(static_cast<float>(x), static_cast<float>(y));
  const auto l = [&](int dx, int dy) { return luminance(image, image.index(x + dx, y + dy)); };
  return (1 - t.y) * ((1 - t.x) * l(0, 0) + t.x * l(1, 0)) + t.y * ((1 - t.x) * l(0, 1) + t.x * l(1, 1));
}

/// Where a point of the first frame is in the second, in pixels; nothing where it is hidden there.
std::optional<Vec2> found_again(const Frame& from, std::size_t pixel, const Frame& to) {
  constexpr float kSame = 0.02F;  // of the distance from the eye: the same place on a surface
  const std::size_t object = from.surface.object[pixel] - 1;
  const Vec4 local = glm::inverse(from.world_from_object[object]) * Vec4(from.surface.position[pixel], 1.0F);
  const Vec4 world = to.world_from_object[object] * local;
  const Vec4 clip = to.clip_from_world * world;
  if (!(clip.w > 0.0F)) return std::nullopt;
  const Vec2 place((0.5F + 0.5F * clip.x / clip.w) * static_cast<float>(to.surface.width),
                   (0.5F - 0.5F * clip.y / clip.w) * static_cast<float>(to.surface.height));
  const int x = static_cast<int>(std::floor(place.x));
  const int y = static_cast<int>(std::floor(place.y));
  if (x < 0 || y < 0 || x >= to.surface.width || y >= to.surface.height) return std::nullopt;
  const std::size_t there = to.surface.index(x, y);
  if (to.surface.object[there] != object + 1) return std::nullopt;
  const float away = glm::distance(to.surface.position[there], Vec3(world));
  if (away > kSame * glm::distance(to.surface.eye, Vec3(world))) return std::nullopt;
  return place;
}

Change change_between(const Frame& from, const Frame& to) {
  constexpr float kMoved = 0.5F;  // pixels
  Change change;
  for (std::size_t pixel = 0; pixel < from.surface.pixels(); ++pixel) {
    if (from.surface.object[pixel] == 0) continue;
    const auto place = found_again(from, pixel, to);
    if (!place) continue;
    const auto width = static_cast<std::size_t>(from.surface.width);
    const Vec2 here(static_cast<float>(pixel % width) + 0.5F, static_cast<float>(pixel / width) + 0.5F);
    const float motion = glm::distance(here, *place);
    const auto later = luminance_at(to.picture, *place);
    if (motion < kMoved || !later) continue;
    const float before = luminance(from.picture, pixel);
    change.followed += std::abs(*later - before);
    change.at_pixel += std::abs(luminance(to.picture, pixel) - before);
    change.motion += motion;
    ++change.points;
  }
  const double count = std::max<double>(1.0, static_cast<double>(change.points));
  change.followed /= count, change.at_pixel /= count, change.motion /= count;
  return change;
}

double median_of(const std::vector<Change>& changes, double Change::*value) {
  std::vector<double> list;
  for (const Change& change : changes) list.push_back(change.*value);
  std::sort(list.begin(), list.end());
  return list.empty() ? 0.0 : list[list.size() / 2];
}

}  // namespace

Result<void> run_coherence(Device& device, const CoherenceOptions& options) {
  const AssetRoots roots = AssetRoots::standard();
  for (const std::string& style : options.styles) {
    Shot shot = demo_scene("creature").shot;
    shot.style = style;
    shot.width = options.width;
    shot.height = options.height;
    std::unique_ptr<Stage> stage;
    std::vector<Change> changes;
    std::optional<Frame> last;
    for (int k = 0; k <= options.count; ++k) {
      shot.frame = options.first + k;
      LUM_TRY(Frame now, draw(device, roots, shot, stage));
      if (last) changes.push_back(change_between(*last, now));
      last = std::move(now);
    }
    const double followed = median_of(changes, &Change::followed);
    const double at_pixel = median_of(changes, &Change::at_pixel);
    const double motion = median_of(changes, &Change::motion);
    if (options.json) {
      const nlohmann::ordered_json line{{"bench", "coherence"}, {"kind", "result"},
                                        {"style", style},       {"pairs", changes.size()},
                                        {"followed", followed}, {"at_pixel", at_pixel},
                                        {"motion_px", motion},  {"per_pixel", motion > 0.0 ? followed / motion : 0.0}};
      std::printf("%s\n", line.dump().c_str());
    } else {
      fmt::print(
          "{:<14} {} pairs  {:.2f} px of motion  change at the surface point {:.4f} ({:.4f} per px), at the pixel "
          "{:.4f}\n",
          style, changes.size(), motion, followed, motion > 0.0 ? followed / motion : 0.0, at_pixel);
    }
    std::fflush(stdout);
  }
  return {};
}

}  // namespace luminist
