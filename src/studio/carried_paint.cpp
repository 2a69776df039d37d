#include "studio/carried_paint.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "paint/anchored_stroke.h"
#include "studio/shot_camera.h"

namespace luminist {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The scene as the shot sees it, until it is posed again.
Result<PaintView> view_of(Scene& scene, const Shot& shot) {
  if (!std::isfinite(shot.frame)) return Error{ErrorKind::kUsage, "a frame is a number", "", "frame", ""};
  pose(scene, shot.seconds());
  LUM_TRY(const Camera camera, shot_camera(scene, shot.camera));
  return PaintView::create(scene, camera, static_cast<float>(shot.width) / static_cast<float>(shot.height));
}

Error of_stroke(Error error, std::size_t index) {
  error.field =
      error.field.empty() ? fmt::format("strokes[{}]", index) : fmt::format("strokes[{}].{}", index, error.field);
  return error;
}

/// Which strokes may go on repeating the peak of the one before them: peaks are those of the painting, as far as their
/// strokes are carried.
class PeakKeeper {
 public:
  /// Called with every stroke in order, the pieces that it became.
  void keep(const Brush& brush, std::vector<Stroke>& pieces) {
    if (!(brush.gradient > 0.0F) || brush.screen_gradient) return;
    const bool own = !brush.repeat_peak || !any_;
    any_ = true;
    if (pieces.empty()) {
      lost_ = lost_ || own;
      return;
    }
    if (lost_) pieces.front().brush.repeat_peak = false;
    lost_ = false;
  }

 private:
  bool any_ = false;   ///< a peak so far
  bool lost_ = false;  ///< the stroke that the last one came from was left out
};

}  // namespace

Result<CarriedPaint> carry_paint(const AssetRoots& roots, const StrokeFile& strokes, const Shot& from, const Shot& to,
                                 const std::filesystem::path& folder, Diagnostics& diagnostics) {
  LUM_TRY(const std::string path, find_input(from.scene, folder, roots));
  LUM_TRY(Scene scene, load_scene(path, from.scene_options, diagnostics));
  std::vector<AnchoredStroke> anchors;
  {
    LUM_TRY(const PaintView view, view_of(scene, from));
    for (std::size_t i = 0; i < strokes.strokes.size(); ++i) {
      auto stroke = anchored(strokes.strokes[i], view);
      if (!stroke) return of_stroke(std::move(stroke).error(), i);
      anchors.push_back(std::move(*stroke));
    }
  }
  LUM_TRY(const PaintView view, view_of(scene, to));
  CarriedPaint result{{strokes.nu, strokes.delta, {}}, {}};
  PeakKeeper peaks;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const Brush& brush = anchors[i].brush;
    CarriedStroke moved;
    const bool copy = brush.tool == PaintTool::kCopy;
    if (!copy) {
      auto seen = carried(anchors[i], view);
      if (!seen) return of_stroke(std::move(seen).error(), i);
      moved = std::move(*seen);
    }
    peaks.keep(brush, moved.pieces);
    result.fates.push_back({brush.clip, !anchors[i].follows_points(), copy, static_cast<int>(moved.pieces.size()),
                            moved.shown, moved.covered, anchors[i].off_surface, moved.hidden, moved.outside});
    for (Stroke& piece : moved.pieces) result.strokes.strokes.push_back(std::move(piece));
  }
  return result;
}

std::string fate_line(const StrokeFate& fate, std::size_t stroke) {
  std::string line = fmt::format("stroke {}{}: ", stroke, fate.clip.empty() ? "" : " on " + fate.clip);
  if (fate.copy) return line + "left out, the image that it copies belongs to its picture";
  if (fate.bucket) return line + "fills as before";
  const int all = fate.shown + fate.off_surface + fate.hidden + fate.outside;
  line += fate.pieces == 0 ? "left out" : fmt::format("{} of {} points", fate.shown, all);
  if (fate.pieces > 1) line += fmt::format(" in {} pieces", fate.pieces);
  std::vector<std::string> notes;
  if (fate.covered > 0) notes.push_back(fmt::format("{} of them behind others", fate.covered));
  if (fate.hidden > 0) notes.push_back(fmt::format("{} hidden", fate.hidden));
  if (fate.outside > 0) notes.push_back(fmt::format("{} outside of the picture", fate.outside));
  if (fate.off_surface > 0) notes.push_back(fmt::format("{} off the surface", fate.off_surface));
  return notes.empty() ? line : line + fmt::format(" ({})", fmt::join(notes, ", "));
}

std::string fates_to_json(const std::vector<StrokeFate>& fates) {
  OrderedJson list = OrderedJson::array();
  for (std::size_t i = 0; i < fates.size(); ++i) {
    const StrokeFate& fate = fates[i];
    list.push_back({{"stroke", i + 1},
                    {"clip", fate.clip},
                    {"pieces", fate.pieces},
                    {"shown", fate.shown},
                    {"covered", fate.covered},
                    {"hidden", fate.hidden},
                    {"outside", fate.outside},
                    {"off_surface", fate.off_surface}});
  }
  return OrderedJson{{"strokes", list}}.dump();
}

}  // namespace luminist
