#pragma once
// studio/quick_stage.h -- the same shot with fewer pixels, for pictures while a brush moves on a slow machine.
#include <array>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "studio/live_painting.h"
#include "studio/stage.h"

namespace luminist {

/// How many pixels a picture may have that is drawn and solved for while the brush moves: as many as this machine
/// makes in time, by what rounds took. A round answers all that the hand did since the one before.
class QuickSize {
 public:
  static constexpr double kMost = 80'000.0;   ///< about 320 x 240
  static constexpr double kFirst = 32'000.0;  ///< before anything was measured: a quick answer first
  static constexpr double kLeast = 12'800.0;  ///< about 130 x 98
  /// What a round may take: two of them, the one that runs and the next, and what is not counted here are an answer
  /// within 0.15 s.
  static constexpr double kSeconds = 0.065;

  /// A round took `fixed` seconds for what is the same at any size, and `growing` for `pixels`.
  void note(double fixed, double growing, double pixels);
  /// As many as suit, by the last rounds.
  [[nodiscard]] double pixels() const { return best_; }

 private:
  struct Round {
    double seconds = 0.0;
    double pixels = 0.0;  ///< for which it would have taken kSeconds
  };
  double best_ = kFirst;
  std::deque<Round> rounds_;  ///< those of the hand's last seconds, of several strokes
};

class QuickStage {
 public:
  /// The sizes that are worth having, in the order in which they are opened.
  static constexpr std::array<double, 3> kSizes = {QuickSize::kFirst, QuickSize::kMost, QuickSize::kLeast};
  /// Whether a shot has more pixels than can be followed without a graphics processor.
  static bool helps(const Shot& shot);
  /// device outlives it. errors those of open_stage(). cost seconds.
  static Result<std::unique_ptr<QuickStage>> open(Device& device, const AssetRoots& roots, const Shot& shot,
                                                  double pixels, const std::filesystem::path& folder,
                                                  Diagnostics& diagnostics);
  [[nodiscard]] double pixels() const;

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
