#pragma once
// studio/session_data.h -- what a session is made of.
#include <filesystem>
#include <memory>
#include <optional>

#include "paint/canvas.h"
#include "project/frame_paint.h"
#include "project/project.h"
#include "solve/solve_session.h"
#include "studio/shot_camera.h"
#include "studio/solved.h"
#include "studio/stage.h"

namespace luminist {

class FreeView;
class LightList;
class PaintLayers;
class ShotView;

/// The project is the truth; the rest is made from it, or will be when it is needed.
struct SessionData {
  Device* device_;
  AssetRoots roots_;
  Diagnostics* diagnostics_;
  std::filesystem::path folder_;  ///< where the shot's paths are looked for first
  Project project_;
  Shot shot_;
  std::unique_ptr<Stage> stage_;
  ParamState state_;
  std::optional<Canvas> canvas_;  ///< empty: to be made from the document when it is needed
  std::optional<Image> picture_;  ///< empty: to be rendered when it is needed
  std::optional<SolveSession> solve_;
  std::optional<ParamState> proposed_;  ///< found elsewhere
  std::optional<Solved> solved_;
  std::size_t dropped_ = 0;  ///< proposals that are no more
  /// What is looked at.
  [[nodiscard]] Vantage vantage() const { return {camera_name(shot_.camera, stage_->camera_names), shot_.frame}; }
  bool locks_chosen_ = false;
  std::string layer_ = {};                    ///< that is painted on; one that is not there: the highest
  std::shared_ptr<FreeView> free_view_ = {};  ///< null: nobody looked yet
  std::uint64_t free_view_of_ = 0;            ///< id of the stage whose shot it shows
};

}  // namespace luminist
