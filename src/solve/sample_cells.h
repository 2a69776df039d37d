#pragma once
// solve/sample_cells.h -- a few hundred samples that stand for the picture while its lights are searched for.
#include <cstdint>
#include <span>
#include <vector>

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

  [[nodiscard]] int size() const { return static_cast<int>(target.size()); }
  /// Means over the cells. samples [samples.pixels.size()], result [size()].
  [[nodiscard]] CellField average(std::span<const Vec3> values) const;
};

/// Cuts one target into cells, as coarse or fine as asked. The surface and the target must outlive it.
///
/// Cells come of a median cut: a rectangle is cut at the middle of its mass, and again. Half of the mass is the
/// importance, half the importance times how much paint changes the pixel, so a small painted place gets as many cells
/// as a large unpainted one. Within a cell, pixels are drawn in proportion to their importance. Pixels beside a
/// silhouette, a crease or an edge of the texture are not drawn where there are others: the picture is antialiased
/// there and a sample is not. Nothing visible, importance zero: never drawn.
class CellSampler {
 public:
  CellSampler(const SurfaceBuffer& surface, const Target& target);

  /// At most cell_count cells of at most per_cell samples. cost O(pixels log cells). Same arguments, same cells.
  [[nodiscard]] SampleCells cut(int cell_count, int per_cell, std::uint64_t seed) const;

  /// True if no visible pixel counts.
  [[nodiscard]] bool nothing_counts() const { return visible_importance_ <= 0.0; }

 private:
  struct Rectangle;
  void split(const Rectangle& area, int cells, std::vector<Rectangle>& leaves) const;
  [[nodiscard]] std::vector<std::uint32_t> draw(const Rectangle& area, int count, double offset) const;

  const SurfaceBuffer* surface_;
  const Target* target_;
  std::vector<float> mass_;          ///< [pixels] what the cut balances; 0 where nothing is drawn
  std::vector<bool> edge_;           ///< [pixels]
  double importance_ = 0.0;          ///< sum over all pixels
  double visible_importance_ = 0.0;  ///< sum over pixels that show something
};

/// [pixels] true beside a change of object, a crease, a step in depth or an edge of the texture.
std::vector<bool> edge_pixels(const SurfaceBuffer& surface);

}  // namespace luminist
