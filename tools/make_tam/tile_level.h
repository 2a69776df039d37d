#pragma once
// make_tam/tile_level.h -- one level of a tonal art map while it is drawn.
#include <array>
#include <vector>

#include "make_tam/tonal_art_map.h"

namespace luminist {

class TileLevel {
 public:
  /// size in texels, a power of two.
  TileLevel(const StrokeKind& kind, int size);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] double ink() const { return ink_; }  ///< share of the texels that the strokes so far cover
  /// How much ink of strokes that go its way lies where the stroke would, from near and from farther away; less is
  /// better.
  [[nodiscard]] double crowding(const Stroke& stroke) const;
  void draw(const Stroke& stroke);
  /// Evenly distributed thresholds in (0, 1]; what no stroke covers comes last, from the strokes outwards.
  [[nodiscard]] Image thresholds() const;

 private:
  template <class Visit>
  void for_texels(const Stroke& stroke, Visit&& visit) const;
  void cover(int x, int y, bool crosses);

  const StrokeKind* kind_;
  int size_;
  double ink_ = 0.0;
  std::vector<float> order_;   ///< [texels] the tone at which it is inked; infinite: not yet
  std::vector<bool> covered_;  ///< [texels] half or more of a stroke's growth
  using Crowds = std::vector<std::vector<float>>;
  std::array<Crowds, 2> crowds_;  ///< of strokes along and across: ink in cells of 1, 2, 4... texels
};

}  // namespace luminist
