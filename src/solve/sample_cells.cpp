#include "solve/sample_cells.h"

#include <array>
#include <cmath>

#include "solve/random.h"

namespace luminist {
namespace {

/// FNV-1a over the pixel indices: equal sets get equal ids, whoever made them.
std::uint64_t pixel_hash(std::span<const std::uint32_t> pixels) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const std::uint32_t pixel : pixels) {
    hash = (hash ^ pixel) * 0x100000001B3ULL;
  }
  return hash;
}

bool differ(const SurfaceBuffer& surface, std::size_t a, std::size_t b) {
  constexpr float kCrease = 0.85F;  // cosine: about 32 degrees from one pixel to the next
  constexpr float kAlbedoStep = 0.15F;
  constexpr float kDepthStep = 0.05F;  // of the distance to the eye
  if (surface.object[a] != surface.object[b]) return true;
  if (glm::dot(surface.normal[a], surface.normal[b]) < kCrease) return true;
  const Vec3 albedo = glm::abs(surface.albedo[a] - surface.albedo[b]);
  if (std::max({albedo.x, albedo.y, albedo.z}) > kAlbedoStep) return true;
  const float near = glm::distance(surface.position[a], surface.eye);
  const float far = glm::distance(surface.position[b], surface.eye);
  return std::abs(near - far) > kDepthStep * std::min(near, far);
}

double importance_at(const Target& target, std::size_t pixel) {
  return std::max(0.0, static_cast<double>(target.importance.data[pixel]));
}

}  // namespace

std::vector<bool> edge_pixels(const SurfaceBuffer& surface) {
  std::vector<bool> edge(surface.pixels(), false);
  const auto mark = [&](std::size_t a, std::size_t b) {
    if (surface.object[a] == 0 && surface.object[b] == 0) return;
    if (differ(surface, a, b)) edge[a] = edge[b] = true;
  };
  for (int y = 0; y < surface.height; ++y) {
    for (int x = 0; x < surface.width; ++x) {
      const std::size_t here = surface.index(x, y);
      if (x + 1 < surface.width) mark(here, surface.index(x + 1, y));
      if (y + 1 < surface.height) mark(here, surface.index(x, y + 1));
    }
  }
  return edge;
}

CellField SampleCells::average(std::span<const Vec3> values) const {
  CellField mean(target.size());
  for (std::size_t cell = 0; cell < mean.size(); ++cell) {
    Vec3 sum(0.0F);
    for (std::uint32_t i = first[cell]; i < first[cell + 1]; ++i) sum += values[i];
    mean[cell] = sum / static_cast<float>(first[cell + 1] - first[cell]);
  }
  return mean;
}

struct CellSampler::Rectangle {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // half open
};

CellSampler::CellSampler(const SurfaceBuffer& surface, const Target& target)
    : surface_(&surface), target_(&target), mass_(surface.pixels(), 0.0F), edge_(edge_pixels(surface)) {
  LUM_CHECK(target.importance.pixels() == surface.pixels(), "a target has the size of the surface it is painted on");
  std::vector<float> change(surface.pixels(), 0.0F);
  double change_sum = 0.0;
  const bool has_before = target.before.pixels() == surface.pixels();
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    const double importance = importance_at(target, i);
    importance_ += importance;
    if (surface.object[i] == 0) continue;
    visible_importance_ += importance;
    if (has_before) {
      change[i] = static_cast<float>(importance) * glm::length(target.color.rgb(i) - target.before.rgb(i));
      change_sum += change[i];
    }
  }
  if (visible_importance_ <= 0.0) return;
  const double change_share = change_sum > 0.0 ? 0.5 : 0.0;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == 0) continue;
    const double plain = importance_at(target, i) / visible_importance_;
    const double changed = change_sum > 0.0 ? change[i] / change_sum : 0.0;
    mass_[i] = static_cast<float>((1.0 - change_share) * plain + change_share * changed);
  }
}

void CellSampler::split(const Rectangle& area, int cells, std::vector<Rectangle>& leaves) const {
  const int width = area.x1 - area.x0;
  const int height = area.y1 - area.y0;
  const bool by_columns = width >= height;
  std::vector<double> lines(static_cast<std::size_t>(by_columns ? width : height), 0.0);
  double total = 0.0;
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      const double mass = mass_[surface_->index(x, y)];
      lines[static_cast<std::size_t>(by_columns ? x - area.x0 : y - area.y0)] += mass;
      total += mass;
    }
  }
  if (total <= 0.0) return;
  if (cells <= 1 || lines.size() < 2) {
    leaves.push_back(area);
    return;
  }
  const int left_cells = cells / 2;
  const double wanted = total * left_cells / cells;
  double sum = lines[0];
  int cut = 1;  // at least one line on each side
  while (cut + 1 < static_cast<int>(lines.size()) && sum + 0.5 * lines[static_cast<std::size_t>(cut)] < wanted) {
    sum += lines[static_cast<std::size_t>(cut++)];
  }
  Rectangle left = area;
  Rectangle right = area;
  (by_columns ? left.x1 : left.y1) = (by_columns ? area.x0 : area.y0) + cut;
  (by_columns ? right.x0 : right.y0) = (by_columns ? area.x0 : area.y0) + cut;
  split(left, left_cells, leaves);
  split(right, cells - left_cells, leaves);
}

std::vector<std::uint32_t> CellSampler::draw(const Rectangle& area, int count, double offset) const {
  // Systematic sampling along the scan lines of the cell; edges only where there is nothing else.
  for (const bool with_edges : {false, true}) {
    std::vector<std::uint32_t> pixels;
    std::vector<double> sums;
    double sum = 0.0;
    for (int y = area.y0; y < area.y1; ++y) {
      for (int x = area.x0; x < area.x1; ++x) {
        const std::size_t pixel = surface_->index(x, y);
        if (mass_[pixel] <= 0.0F || (!with_edges && edge_[pixel])) continue;
        sum += importance_at(*target_, pixel);
        pixels.push_back(static_cast<std::uint32_t>(pixel));
        sums.push_back(sum);
      }
    }
    if (pixels.empty()) continue;
    if (static_cast<int>(pixels.size()) <= count) return pixels;
    std::vector<std::uint32_t> drawn;
    std::size_t i = 0;
    for (int k = 0; k < count; ++k) {
      const double at = sum * (k + offset) / count;
      while (i + 1 < sums.size() && sums[i] <= at) ++i;
      if (drawn.empty() || drawn.back() != pixels[i]) drawn.push_back(pixels[i]);
    }
    return drawn;
  }
  return {};
}

SampleCells CellSampler::cut(int cell_count, int per_cell, std::uint64_t seed) const {
  std::vector<Rectangle> leaves;
  if (!nothing_counts()) split({0, 0, surface_->width, surface_->height}, cell_count, leaves);
  Random random(seed);
  SampleCells cells;
  cells.first.push_back(0);
  for (const Rectangle& leaf : leaves) {
    const std::vector<std::uint32_t> drawn = draw(leaf, per_cell, random.uniform());
    double weight = 0.0;
    for (int y = leaf.y0; y < leaf.y1; ++y) {
      for (int x = leaf.x0; x < leaf.x1; ++x) {
        const std::size_t pixel = surface_->index(x, y);
        if (surface_->object[pixel] != 0) weight += importance_at(*target_, pixel);
      }
    }
    if (drawn.empty() || weight <= 0.0) continue;
    Vec3 target(0.0F);
    for (const std::uint32_t pixel : drawn) target += target_->color.rgb(pixel);
    cells.target.push_back(target / static_cast<float>(drawn.size()));
    cells.weight.push_back(weight / importance_);
    cells.position.push_back(surface_->position[drawn.front()]);
    cells.normal.push_back(surface_->normal[drawn.front()]);
    cells.samples.pixels.insert(cells.samples.pixels.end(), drawn.begin(), drawn.end());
    cells.first.push_back(static_cast<std::uint32_t>(cells.samples.pixels.size()));
  }
  cells.samples.id = pixel_hash(cells.samples.pixels);
  return cells;
}

}  // namespace luminist
