#pragma once
// solve/sample_cells.h -- a few hundred samples that stand for the picture while its lights are searched for.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "paint/coverage.h"
#include "render/renderer.h"
#include "render/surface_buffer.h"
#include "render/target.h"

namespace luminist {

/// One value per cell.
using CellField = std::vector<Vec3>;

/// The picture cut into cells of about equal say; a few samples speak for each.
struct SampleCells {
  SampleSet samples;                 ///< cell by cell; the id is a hash of the pixels
  std::vector<std::uint32_t> first;  ///< [cells + 1] cell c owns samples first[c] .. first[c + 1]
  CellField target;                  ///< [cells] mean of the target over the cell's samples
  std::vector<double> weight;        ///< [cells] the cell's share of all importance; sums to at most 1
  CellField position;                ///< [cells] world position of the first sample
  CellField normal;                  ///< [cells] its normal
  std::vector<PixelBox> area;        ///< [cells] what the cell stands for
  std::vector<double> share;         ///< [cells] of the mass that the cut balanced

  [[nodiscard]] int size() const { return static_cast<int>(target.size()); }
  /// Means over the cells. samples [samples.pixels.size()], result [size()].
  [[nodiscard]] CellField average(std::span<const Vec3> values) const;
};

/// [pixels] true beside a change of object, a crease, a step in depth or an edge of the texture. It depends on the
/// surface alone: whoever solves on one surface again and again makes it once.
using EdgeMask = std::vector<bool>;
EdgeMask edge_pixels(const SurfaceBuffer& surface);

/// Cuts one target into cells, as coarse or fine as asked. The surface and the target must outlive it.
///
/// Cells come of a median cut: a rectangle is cut at the middle of its mass, and again. Half of the mass is the
/// importance, half the importance times how much paint changes the pixel, so a small painted place gets as many cells
/// as a large unpainted one. Within a cell, pixels are drawn in proportion to their importance. Pixels beside a
/// silhouette, a crease or an edge of the texture are not drawn where there are others: the picture is antialiased
/// there and a sample is not. Nothing visible, importance zero: never drawn.
class CellSampler {
 public:
  /// edges: edge_pixels(surface), null to have it made. cost O(pixels).
  CellSampler(const SurfaceBuffer& surface, const Target& target, std::shared_ptr<const EdgeMask> edges = nullptr);

  /// The target has changed there. cost that of the pixels changed and a sum over the rows from there on.
  void update(const PixelBox& box);

  /// At most cell_count cells of at most per_cell samples. cost O(pixels). Same arguments, same cells.
  [[nodiscard]] SampleCells cut(int cell_count, int per_cell, std::uint64_t seed) const;

  /// Brings targets and weights of cells that were cut earlier up to date; their samples stay. returns how far their
  /// shares of the mass are from those they were cut for: 0 not at all, 1 altogether elsewhere. cost O(samples).
  double refresh(SampleCells& cells) const;

  /// True if no visible pixel counts.
  [[nodiscard]] bool nothing_counts() const { return sums_.back().importance <= 0.0; }

 private:
  /// What counts in a part of the picture.
  struct Sum {
    double importance = 0.0;
    double change = 0.0;  ///< importance times how much paint changes the pixel
  };
  void sum_rows(int from);
  [[nodiscard]] const Sum& corner(int x, int y) const;
  [[nodiscard]] Sum sum(const PixelBox& area) const;
  [[nodiscard]] double mass(const PixelBox& area) const;
  void split(const PixelBox& area, int cells, std::vector<PixelBox>& leaves) const;
  [[nodiscard]] std::vector<std::uint32_t> draw(const PixelBox& area, int count, double offset) const;
  [[nodiscard]] Vec3 target_mean(std::span<const std::uint32_t> pixels) const;

  const SurfaceBuffer* surface_;
  const Target* target_;
  std::shared_ptr<const EdgeMask> edges_;
  std::vector<float> change_;  ///< [pixels] as in Sum
  std::vector<Sum> sums_;      ///< [(width + 1) x (height + 1)] of the visible pixels above and to the left
  std::vector<double> rows_;   ///< [height] importance of all pixels
};

}  // namespace luminist
