#pragma once
// make_tam/tonal_art_map.h -- strokes for every tone and scale, as thresholds.
#include <cstdint>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/result.h"

namespace luminist {

/// How the strokes of a map look. Lengths in texels are the same at every level; angles are from the way of u.
struct StrokeKind {
  std::string name;
  double width = 2.0;      ///< texels, of a full stroke
  double shortest = 60.0;  ///< texels
  double longest = 160.0;
  double longest_share = 0.8;   ///< of the tile, for levels on which the above is too long
  double turn = 0.05;           ///< deviation of a stroke's angle, radians
  double wobble = 0.8;          ///< texels, of a stroke to either side
  double taper = 0.2;           ///< share of the length over which an end gets thin
  double swelling = 0.1;        ///< tone over which a stroke grows from its core to its width
  double grain = 0.0;           ///< tone by which the paper's grain breaks strokes up
  double crossing_from = 0.5;   ///< tone from which strokes cross
  double crossing_angle = 1.4;  ///< radians
  int candidates = 150;         ///< of which the one in the emptiest place is drawn
};

/// "pencil", "ink" or "stipple". errors kUsage with the nearest name.
Result<StrokeKind> stroke_kind(const std::string& name);

/// A stroke of the tile, which repeats: places are in tiles, [0, 1).
struct Stroke {
  double x = 0.0;  ///< of its middle
  double y = 0.0;
  double angle = 0.0;
  double length = 0.0;  ///< tiles; 0: a dot
  bool crosses = false;
  std::uint64_t seed = 0;
  int level = 0;  ///< the coarsest on which it is drawn; finer ones have it too
};

/// Thresholds of a tile at several levels of detail. A texel is inked at darkness d in (0, 1] if its threshold is <= d.
///
/// Strokes nest both ways: what is drawn at some darkness is drawn at all that are darker, and what a coarser level has
/// a finer one has too, with the same width in texels. On each level the thresholds are evenly distributed, so that the
/// share of inked texels is the darkness. source: Praun, Hoppe, Webb and Finkelstein 2001; Webb et al. 2002.
struct TonalArtMap {
  static constexpr int kLevels = 5;
  static constexpr int kSize = 512;  ///< texels of the finest level; each other has half of the one before

  std::vector<Image> levels;    ///< [kLevels] one channel, the finest first; thresholds in (0, 1]
  std::vector<Stroke> strokes;  ///< in the order in which they were drawn

  /// All levels one below the other, white beside: the file that the engine reads.
  [[nodiscard]] Image strip() const;
  /// Bilinear in a level, linear between two, as the engine samples; u and v in tiles, lod from 0 to kLevels - 1.
  [[nodiscard]] float threshold(double u, double v, double lod) const;
};

/// Draws a map. Same kind and seed, same bits. cost seconds.
TonalArtMap make_tonal_art_map(const StrokeKind& kind, std::uint64_t seed);

/// What undoes that interpolation draws thresholds together: [8 * (kLevels - 1) + 1] rows for lod = row / 8, 256
/// columns: the threshold that is exceeded by all but a share column / 255 of the tile. A place is inked at a darkness
/// if its threshold is at most the table's, and mean ink is the darkness at every lod.
Image tone_table(const TonalArtMap& map);

/// Up to which threshold a darkness inks, as the engine reads it: bilinear.
float inked_to(const Image& table, double darkness, double lod);

/// Tones from white to black beside each other, levels of detail below each other, as they look in use.
Image contact_sheet(const TonalArtMap& map, const Image& table);

}  // namespace luminist
