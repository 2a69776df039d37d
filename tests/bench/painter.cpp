#include "bench/painter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "studio/stage.h"

namespace luminist {
namespace {

constexpr double kPointJitter = 0.008;  // picture heights, deviation
constexpr double kColorJitter = 0.04;   // of a channel, deviation

Vec3 unsteady_color(const Vec3& color, Random& random) {
  Vec3 result(0.0F);
  for (int c = 0; c < 3; ++c) result[c] = color[c] * static_cast<float>(std::exp(kColorJitter * random.normal()));
  return result;
}

StrokePoint unsteady_point(StrokePoint point, Random& random) {
  point.x += static_cast<float>(kPointJitter * random.normal());
  point.y += static_cast<float>(kPointJitter * random.normal());
  return point;
}

/// The pixels of one cell that are in a mask.
struct CellPart {
  int inside = 0;
  int all = 0;
  Vec3 sum{0.0F};
};

CellPart part_of(std::span<const unsigned char> mask, const Image* picture, int width, int height, int left, int top,
                 int side) {
  CellPart part;
  for (int y = top; y < std::min(top + side, height); ++y) {
    for (int x = left; x < std::min(left + side, width); ++x) {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      ++part.all;
      if (mask[pixel] == 0) continue;
      ++part.inside;
      if (picture != nullptr) part.sum += picture->rgb(pixel);
    }
  }
  return part;
}

std::vector<Stroke> dab_cells(const Brush& brush, const Image* picture, std::span<const unsigned char> mask, int width,
                              int height, Random& random) {
  constexpr float kOverlap = 0.5F;  // cells are half a brush apart, so that dabs close up
  const int side = std::max(1, static_cast<int>(std::lround(kOverlap * brush.diameter * static_cast<float>(height))));
  std::vector<Stroke> strokes;
  for (int top = 0; top < height; top += side) {
    for (int left = 0; left < width; left += side) {
      const CellPart part = part_of(mask, picture, width, height, left, top, side);
      if (2 * part.inside < part.all) continue;
      Stroke stroke{brush, {}};
      if (picture != nullptr) stroke.brush.color = part.sum / static_cast<float>(part.inside);
      const float scale = 1.0F / static_cast<float>(height);
      const float half = 0.5F * static_cast<float>(side);
      stroke.points.push_back(unsteady_point(
          {scale * (static_cast<float>(left) + half), scale * (static_cast<float>(top) + half), 1.0F}, random));
      strokes.push_back(std::move(stroke));
    }
  }
  return strokes;
}

}  // namespace

Result<Canvas> canvas_on(const BenchStage& stage, const ParamState& state) {
  Renderer& renderer = stage.renderer();
  LUM_TRY(Image picture, renderer.render(state));
  return Canvas(renderer.surface(), std::move(picture),
                [&renderer, state](ShadowPicture which) { return render_shadow_picture(renderer, state, which); });
}

Result<StrokeFile> committed_strokes(const std::string& file) {
  LUM_TRY(const std::filesystem::path path, AssetRoots::standard().find(file));
  return load_strokes(path.string());
}

StrokeFile unsteady(StrokeFile strokes, Random& random) {
  for (Stroke& stroke : strokes.strokes) {
    stroke.brush.color = unsteady_color(stroke.brush.color, random);
    for (StrokePoint& point : stroke.points) point = unsteady_point(point, random);
  }
  return strokes;
}

std::vector<Stroke> dabs(const Brush& brush, std::span<const unsigned char> mask, int width, int height,
                         Random& random) {
  return dab_cells(brush, nullptr, mask, width, height, random);
}

std::vector<Stroke> colored_dabs(const Brush& brush, const Image& picture, std::span<const unsigned char> mask,
                                 Random& random) {
  return dab_cells(brush, &picture, mask, picture.width, picture.height, random);
}

}  // namespace luminist
