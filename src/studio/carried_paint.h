#pragma once
// studio/carried_paint.h -- the strokes of one frame and camera for another one.
#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "paint/stroke.h"
#include "studio/shot.h"

namespace luminist {

/// What became of a stroke. All counts are of points along it, as close as it takes to follow the surface.
struct StrokeFate {
  std::string clip;     ///< the object it stays on; empty: all
  bool bucket = false;  ///< it fills its object, and has no points to follow
  bool copy = false;    ///< left out: a copied image lies on the picture and not on the surface
  int pieces = 0;       ///< strokes that it became; 0: it is left out
  int shown = 0;        ///< points that are carried
  int covered = 0;      ///< of them behind another object, where the clip cuts them
  int off_surface = 0;  ///< left out where they were painted: nothing is there
  int hidden = 0;       ///< left out: behind something, or on the side that faces away
  int outside = 0;      ///< left out: not on the other picture
};

struct CarriedPaint {
  StrokeFile strokes;             ///< nu and delta as before
  std::vector<StrokeFate> fates;  ///< [strokes of the file]
};

/// Strokes of `from` for `to`: the scene is that of `from`, only camera and frame of `to` count. Nothing is drawn. A
/// stroke that repeats the peak of one that is left out gets a peak of its own.
/// errors those of load_scene(), shot_camera() and anchored(), these with the stroke in the field; kUsage for frames
/// that are no numbers. cost reading the scene, two ray indices.
Result<CarriedPaint> carry_paint(const AssetRoots& roots, const StrokeFile& strokes, const Shot& from, const Shot& to,
                                 const std::filesystem::path& folder, Diagnostics& diagnostics);

/// "stroke 1 on jug: 12 of 40 points in 2 pieces (28 hidden)".
std::string fate_line(const StrokeFate& fate, std::size_t stroke);
/// {"strokes": [{"stroke": 1, "clip": "jug", "pieces": 2, "shown": 12, ...}]}
std::string fates_to_json(const std::vector<StrokeFate>& fates);

}  // namespace luminist
