#pragma once
// studio/quick_stage.h -- the same shot with fewer pixels, for pictures while a brush moves on a slow machine.
#include <memory>
#include <string>
#include <vector>

#include "studio/live_painting.h"
#include "studio/stage.h"

namespace luminist {

/// How many pixels a picture may have that is drawn and solved for while the brush moves: about 320 x 240.
inline constexpr double kQuickPixels = 80'000.0;

class QuickStage {
 public:
  /// Whether a shot has more pixels than can be followed without a graphics processor.
  static bool helps(const Shot& shot);
  /// device outlives it. errors those of open_stage(). cost seconds.
  static Result<std::unique_ptr<QuickStage>> open(Device& device, const AssetRoots& roots, const Shot& shot,
                                                  const std::filesystem::path& folder, Diagnostics& diagnostics);

  /// A painting that goes on from paint of any size and from those lights; its pictures are small.
  /// in_force: the lights whose picture is painted on, and whose shadows are copied.
  /// errors the renderer's. cost a small picture, O(pixels of the paint).
  Result<LivePainting> paint(const CanvasState& paint, const ParamState& in_force, const ParamState& start,
                             std::vector<std::string> new_lights) const;

 private:
  explicit QuickStage(std::unique_ptr<Stage> stage) : stage_(std::move(stage)) {}
  std::unique_ptr<Stage> stage_;
};

/// Paint at another size: colours are averaged, strokes are those at the pixels' centres. `fresh` is the state of an
/// unpainted canvas of that size.
CanvasState resized_paint(const CanvasState& paint, CanvasState fresh);

}  // namespace luminist
