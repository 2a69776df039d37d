#include "solve/sample_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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
  if (largest(albedo) > kAlbedoStep) return true;
  const float near = glm::distance(surface.position[a], surface.eye);
  const float far = glm::distance(surface.position[b], surface.eye);
  return std::abs(near - far) > kDepthStep * std::min(near, far);
}

double importance_at(const Target& target, std::size_t pixel) {
  return std::max(0.0, static_cast<double>(target.importance.data[pixel]));
}

}  // namespace

EdgeMask edge_pixels(const SurfaceBuffer& surface) {
  EdgeMask edge(surface.pixels(), false);
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

CellSampler::CellSampler(const SurfaceBuffer& surface, const Target& target, std::shared_ptr<const EdgeMask> edges)
    : surface_(&surface),
      target_(&target),
      edges_(edges ? std::move(edges) : std::make_shared<const EdgeMask>(edge_pixels(surface))),
      change_(surface.pixels(), 0.0F),
      sums_(static_cast<std::size_t>(surface.width + 1) * static_cast<std::size_t>(surface.height + 1)),
      rows_(static_cast<std::size_t>(surface.height), 0.0) {
  LUM_CHECK(target.importance.pixels() == surface.pixels(), "a target has the size of the surface it is painted on");
  LUM_CHECK(edges_->size() == surface.pixels(), "edges and surface are of one shot");
  update({0, 0, surface.width, surface.height});
}

void CellSampler::update(const PixelBox& box) {
  const bool has_before = target_->before.pixels() == surface_->pixels();
  for (int y = box.y0; y < box.y1 && has_before; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t i = surface_->index(x, y);
      change_[i] =
          static_cast<float>(importance_at(*target_, i)) * glm::length(target_->color.rgb(i) - target_->before.rgb(i));
    }
  }
  if (!box.empty()) sum_rows(box.y0);
}

void CellSampler::sum_rows(int from) {
  const auto stride = static_cast<std::size_t>(surface_->width) + 1;
  for (int y = from; y < surface_->height; ++y) {
    const std::size_t above = static_cast<std::size_t>(y) * stride;
    Sum row;
    double all = 0.0;
    for (int x = 0; x < surface_->width; ++x) {
      const std::size_t i = surface_->index(x, y);
      const double importance = importance_at(*target_, i);
      all += importance;
      if (surface_->object[i] != 0) {
        row.importance += importance;
        row.change += change_[i];
      }
      const auto column = static_cast<std::size_t>(x) + 1;
      sums_[above + stride + column] = {sums_[above + column].importance + row.importance,
                                        sums_[above + column].change + row.change};
    }
    rows_[static_cast<std::size_t>(y)] = all;
  }
}

const CellSampler::Sum& CellSampler::corner(int x, int y) const {
  return sums_[static_cast<std::size_t>(y) * (static_cast<std::size_t>(surface_->width) + 1) +
               static_cast<std::size_t>(x)];
}

CellSampler::Sum CellSampler::sum(const PixelBox& area) const {
  const auto difference = [&](double Sum::*what) {
    return (corner(area.x1, area.y1).*what - corner(area.x0, area.y1).*what) -
           (corner(area.x1, area.y0).*what - corner(area.x0, area.y0).*what);
  };
  return {difference(&Sum::importance), difference(&Sum::change)};
}

double CellSampler::mass(const PixelBox& area) const {
  const Sum part = sum(area);
  const Sum& all = sums_.back();
  const double plain = part.importance / all.importance;
  return all.change > 0.0 ? 0.5 * plain + 0.5 * part.change / all.change : plain;
}

void CellSampler::split(const PixelBox& area, int cells, std::vector<PixelBox>& leaves) const {
  constexpr double kNothing = 1e-9;  // of all mass: what rounding leaves of differences of sums
  const double total = mass(area);
  if (total <= kNothing) return;
  const bool by_columns = area.width() >= area.height();
  const int lines = by_columns ? area.width() : area.height();
  if (cells <= 1 || lines < 2) {
    leaves.push_back(area);
    return;
  }
  PixelBox left = area;
  int& end = by_columns ? left.x1 : left.y1;
  const int first = by_columns ? area.x0 : area.y0;
  const auto up_to = [&](int line) {
    end = first + line;
    return mass(left);
  };
  const int left_cells = cells / 2;
  const double wanted = total * left_cells / cells;
  int cut = 1;  // at least one line on each side
  while (cut + 1 < lines && 0.5 * (up_to(cut) + up_to(cut + 1)) < wanted) ++cut;
  end = first + cut;
  PixelBox right = area;
  (by_columns ? right.x0 : right.y0) = end;
  split(left, left_cells, leaves);
  split(right, cells - left_cells, leaves);
}

std::vector<std::uint32_t> CellSampler::draw(const PixelBox& area, int count, double offset) const {
  // Systematic sampling along the scan lines of the cell; edges only where there is nothing else.
  for (const bool with_edges : {false, true}) {
    std::vector<std::uint32_t> pixels;
    std::vector<double> sums;
    double sum = 0.0;
    for (int y = area.y0; y < area.y1; ++y) {
      for (int x = area.x0; x < area.x1; ++x) {
        const std::size_t pixel = surface_->index(x, y);
        const double importance = importance_at(*target_, pixel);
        if (importance <= 0.0 || surface_->object[pixel] == 0 || (!with_edges && (*edges_)[pixel])) continue;
        sum += importance;
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

Vec3 CellSampler::target_mean(std::span<const std::uint32_t> pixels) const {
  Vec3 mean(0.0F);
  for (const std::uint32_t pixel : pixels) mean += target_->color.rgb(pixel);
  return mean / static_cast<float>(pixels.size());
}

SampleCells CellSampler::cut(int cell_count, int per_cell, std::uint64_t seed) const {
  std::vector<PixelBox> leaves;
  if (!nothing_counts()) split({0, 0, surface_->width, surface_->height}, cell_count, leaves);
  Random random(seed);
  SampleCells cells;
  cells.first.push_back(0);
  for (const PixelBox& leaf : leaves) {
    const std::vector<std::uint32_t> drawn = draw(leaf, per_cell, random.uniform());
    if (drawn.empty()) continue;
    cells.target.emplace_back(0.0F);
    cells.weight.push_back(0.0);
    cells.area.push_back(leaf);
    cells.share.push_back(mass(leaf));
    cells.position.push_back(surface_->position[drawn.front()]);
    cells.normal.push_back(surface_->normal[drawn.front()]);
    cells.samples.pixels.insert(cells.samples.pixels.end(), drawn.begin(), drawn.end());
    cells.first.push_back(static_cast<std::uint32_t>(cells.samples.pixels.size()));
  }
  cells.samples.id = pixel_hash(cells.samples.pixels);
  refresh(cells);
  return cells;
}

double CellSampler::refresh(SampleCells& cells) const {
  if (nothing_counts()) return 1.0;
  const double importance = std::accumulate(rows_.begin(), rows_.end(), 0.0);
  double covered = 0.0;
  double moved = 0.0;
  for (std::size_t c = 0; c < cells.target.size(); ++c) {
    const auto samples = std::span(cells.samples.pixels).subspan(cells.first[c], cells.first[c + 1] - cells.first[c]);
    cells.target[c] = target_mean(samples);
    cells.weight[c] = std::max(0.0, sum(cells.area[c]).importance) / importance;
    const double share = mass(cells.area[c]);
    moved += std::abs(share - cells.share[c]);
    covered += share;
  }
  return 0.5 * (moved + std::max(0.0, 1.0 - covered));
}

}  // namespace luminist
