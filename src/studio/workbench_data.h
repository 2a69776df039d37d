#pragma once
// studio/workbench_data.h -- what a workbench is made of.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "studio/live_painting.h"
#include "studio/painted_buffers.h"
#include "studio/quick_stage.h"
#include "studio/session.h"
#include "studio/studio_snapshot.h"
#include "studio/style_reload.h"

namespace luminist {

/// A stroke under the hand.
struct HeldStroke {
  Stroke stroke;
  std::filesystem::path folder;
  bool live = false;   ///< goes to live_painting_, else to canvas_
  bool quick = false;  ///< and to quick_painting_
};

/// Lights that were proposed at a place of the history, so that undo and redo bring them back.
struct KeptProposal {
  ParamState lights;
  SolveOptions options;
  SolveReport report;
  std::string label;
  std::vector<SolvedFrame> frames;
  /// The search for it was not at its end.
  [[nodiscard]] bool goes_on() const {
    return report.solver == "live" &&
           (report.termination == Termination::kStopped || report.termination == Termination::kRunning);
  }
};

struct WorkbenchData {
  Device* device_ = nullptr;
  AssetRoots roots_{std::vector<std::filesystem::path>{}};
  std::filesystem::path unsaved_;
  Diagnostics diagnostics_;
  std::size_t warnings_told_ = 0;
  std::unique_ptr<Session> session_;
  std::optional<LivePainting> live_painting_;
  std::optional<Canvas> canvas_;                           ///< for strokes that no light follows, or only a quick one
  std::vector<std::unique_ptr<QuickStage>> quick_stages_;  ///< those that are ready, the largest first
  QuickSize quick_size_;
  std::optional<LivePainting> quick_painting_;  ///< goes on from stroke to stroke
  const QuickStage* quick_of_ = nullptr;        ///< its stage
  std::optional<HeldStroke> stroke_;
  std::optional<ParamState> trial_;  ///< of preview()
  std::vector<std::string> solo_;
  std::shared_ptr<const std::vector<Offer>> offers_;
  std::optional<StyleFiles> style_files_;
  bool live_ = true;
  bool follow_again_ = false;  ///< the paint waits for lights that follow
  bool resting_ = false;       ///< live_painting_ has more to gain
  bool solving_ = false;
  bool proposal_put_ = false;                  ///< the session's proposal is what live_painting_ shows
  std::map<std::size_t, std::string> labels_;  ///< of commands, by index
  std::map<std::size_t, KeptProposal> kept_;   ///< by the number of commands that were in force
  std::size_t undo_seen_ = 0;
  double error_before_ = 0.0;  ///< of what is painted on, without penalty
  std::uint32_t unanswered_ = 0;
  std::uint64_t strokes_taken_ = 0, version_ = 0;
  std::shared_ptr<const ShotFacts> facts_;
  /// Ids of stages: the facts', one that was tried to be had small, one whose shadow brushes have nothing to copy.
  std::uint64_t facts_of_ = 0, unprepared_ = 0, unshadowed_ = 0;
  std::shared_ptr<const Image> picture_;
  PaintedBuffers painted_buffers_;
  std::shared_ptr<const PaintedPictures> painted_;
  std::shared_ptr<const LayerStack> layers_;  ///< without pixels
  EventCost cost_;
  std::chrono::steady_clock::time_point solve_shown_;
  std::function<bool()> undisturbed_;                  ///< empty: nobody ever waits
  std::function<Result<void>(Session&)> after_solve_;  ///< empty: nothing waits for the solve
};

}  // namespace luminist
