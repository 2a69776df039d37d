#include "verdict/stroke_region.h"

#include <algorithm>
#include <map>

#include "base/check.h"
#include "solve/sample_cells.h"

namespace luminist {
namespace {

constexpr float kChange = 1e-3F;  // of linear RGB: paint that changes less asks for nothing

/// FNV-1a: equal sets get equal ids, so that engines recognize them.
std::uint64_t pixel_hash(std::span<const std::uint32_t> pixels) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const std::uint32_t pixel : pixels) hash = (hash ^ pixel) * 0x100000001B3ULL;
  return hash;
}

/// The object that the paint changes most; if it changes nothing, that of most of the pixels.
std::string object_changed(const StrokeRegion& region, const SurfaceBuffer& surface, const Target& target) {
  std::map<std::uint32_t, std::pair<double, std::size_t>> change;  // and pixels
  for (const std::uint32_t pixel : region.pixels) {
    auto& [sum, pixels] = change[surface.object[pixel]];
    sum += target.importance.data[pixel] * glm::distance(target.color.rgb(pixel), target.before.rgb(pixel));
    ++pixels;
  }
  const auto most =
      std::max_element(change.begin(), change.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == change.end() || most->first >= surface.object_names.size()) return "";
  return surface.object_names[most->first];
}

/// `count` of the pixels at equal distances in row order; all if there are no more.
std::vector<std::uint32_t> evenly(const std::vector<std::uint32_t>& pixels, std::size_t count) {
  if (pixels.size() <= count) return pixels;
  std::vector<std::uint32_t> drawn;
  for (std::size_t k = 0; k < count; ++k) drawn.push_back(pixels[(2 * k + 1) * pixels.size() / (2 * count)]);
  return drawn;
}

/// Some of the pixels, away from edges where that can be had, with the importance of all.
void add_samples(const std::vector<std::uint32_t>& pixels, std::size_t count, const std::vector<bool>& edge,
                 const Target& target, int region, SampledWish& wish) {
  std::vector<std::uint32_t> inside;
  double all = 0.0;
  for (const std::uint32_t pixel : pixels) {
    all += target.importance.data[pixel];
    if (!edge[pixel]) inside.push_back(pixel);
  }
  double drawn_sum = 0.0;
  const auto drawn = evenly(inside.size() >= count / 4 + 1 ? inside : pixels, count);
  for (const std::uint32_t pixel : drawn) drawn_sum += target.importance.data[pixel];
  for (const std::uint32_t pixel : drawn) {
    wish.samples.pixels.push_back(pixel);
    wish.target.push_back(target.color.rgb(pixel));
    wish.weight.push_back(target.importance.data[pixel] * all / drawn_sum);
    wish.region.push_back(region);
  }
}

void finish(SampledWish& wish) {
  double sum = 0.0;
  for (const double weight : wish.weight) sum += weight;
  for (double& weight : wish.weight) weight = sum > 0.0 ? weight / sum : 0.0;
  wish.samples.id = pixel_hash(wish.samples.pixels);
}

}  // namespace

std::vector<StrokeRegion> stroke_regions(const SurfaceBuffer& surface, const Target& target) {
  LUM_CHECK(target.stroke.size() == surface.pixels(), "a target has the size of the surface it is painted on");
  std::map<std::uint32_t, StrokeRegion> found;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (!(target.importance.data[i] > 0.0F)) continue;
    StrokeRegion& region = found[target.stroke[i]];
    if (surface.object[i] == 0) {
      ++region.empty_pixels;
    } else {
      region.pixels.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::vector<StrokeRegion> regions;
  for (auto& [stroke, region] : found) {
    region.stroke = stroke;
    region.object = object_changed(region, surface, target);
    regions.push_back(std::move(region));
  }
  return regions;
}

double Shortfall::attained() const {
  return wished > 0.0 ? std::clamp(1.0 - missed / wished, 0.0, 1.0) : 1.0;
}

Shortfall shortfall(const StrokeRegion& region, const Target& target, const Image& picture) {
  Shortfall sum;
  double importance = 0.0;
  for (const std::uint32_t pixel : region.pixels) {
    const double weight = target.importance.data[pixel];
    const Vec3 wanted = target.color.rgb(pixel);
    const Vec3 lack = wanted - picture.rgb(pixel);
    const Vec3 light = glm::max(lack, 0.0F);
    const Vec3 dark = glm::max(-lack, 0.0F);
    const double wished = weight * glm::distance(wanted, target.before.rgb(pixel));
    importance += weight;
    sum.wished += wished;
    sum.missed += weight * glm::length(lack);
    sum.light += weight * (light.x + light.y + light.z);
    sum.dark += weight * (dark.x + dark.y + dark.z);
    sum.scale += weight * glm::length(wanted);
    sum.missed_where_wished += wished * glm::length(lack);
    sum.scale_where_wished += wished * glm::length(wanted);
  }
  if (!(importance > 0.0)) return {};
  if (sum.wished > 0.0) sum.missed_where_wished /= sum.wished, sum.scale_where_wished /= sum.wished;
  for (double* mean : {&sum.wished, &sum.missed, &sum.light, &sum.dark, &sum.scale}) *mean /= importance;
  return sum;
}

double SampledWish::error(std::span<const Vec3> colors) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < target.size(); ++i) sum += weight[i] * glm::distance(target[i], colors[i]);
  return sum;
}

SampledWish sample_regions(const std::vector<StrokeRegion>& regions, const SurfaceBuffer& surface, const Target& target,
                           std::size_t per_region) {
  const std::vector<bool> edge = edge_pixels(surface);
  SampledWish wish;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    std::vector<std::uint32_t> changed, rest;
    for (const std::uint32_t pixel : regions[r].pixels) {
      const bool changes = glm::distance(target.color.rgb(pixel), target.before.rgb(pixel)) > kChange;
      (changes ? changed : rest).push_back(pixel);
    }
    const bool few = !changed.empty() && changed.size() < rest.size();
    const std::size_t half = std::min(per_region / 2, changed.size());
    if (few && half > 0) {
      add_samples(changed, half, edge, target, static_cast<int>(r), wish);
      add_samples(rest, per_region - half, edge, target, static_cast<int>(r), wish);
    } else {
      add_samples(regions[r].pixels, per_region, edge, target, static_cast<int>(r), wish);
    }
  }
  finish(wish);
  return wish;
}

SampledWish only_region(const SampledWish& wish, int region) {
  SampledWish part;
  for (std::size_t i = 0; i < wish.region.size(); ++i) {
    if (wish.region[i] != region) continue;
    part.samples.pixels.push_back(wish.samples.pixels[i]);
    part.target.push_back(wish.target[i]);
    part.weight.push_back(wish.weight[i]);
    part.region.push_back(region);
  }
  finish(part);
  return part;
}

}  // namespace luminist
