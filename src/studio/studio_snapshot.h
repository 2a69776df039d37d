#pragma once
// studio/studio_snapshot.h -- what a window shows of a session: plain values that nobody changes any more.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "paint/layer_stack.h"
#include "render/param_state.h"
#include "render/surface_buffer.h"
#include "scene/scene.h"
#include "solve/solve_session.h"
#include "studio/frame_facts.h"
#include "studio/shot.h"
#include "verdict/verdict.h"

namespace luminist {

/// What is painted. All of one size.
struct PaintedPictures {
  Image color;                        ///< the target, linear RGB
  Image importance;                   ///< 1 channel
  std::vector<std::uint32_t> stroke;  ///< [pixels] number of the last stroke that touched it; 0: unpainted
};

/// What the last event of the hand took, in seconds.
struct EventCost {
  double paint = 0.0;     ///< the stroke on the full canvas
  double preview = 0.0;   ///< and on the small one
  double retarget = 0.0;  ///< the solver takes the new target
  double solve = 0.0;
  double picture = 0.0;
  double snapshot = 0.0;  ///< of the event before
  [[nodiscard]] double total() const { return paint + preview + retarget + solve + picture + snapshot; }
};

/// The shot itself; another one after opening, restyling and undoing that.
struct ShotFacts {
  Shot shot;
  Camera camera;
  SceneFrame frame;
  SurfaceBuffer surface;
  std::string style_doc;
  StyleMetric metric;
  std::vector<std::string> styles;       ///< all that can be a picture of their own
  std::vector<std::string> light_types;  ///< that a new light can have
  std::vector<std::string> cameras;      ///< of the scene
  Box bounds;                            ///< of the scene without backdrops
};

struct HistoryFacts {
  std::vector<std::string> labels;  ///< of the last commands, oldest first: in force, then those that can be redone
  std::size_t first = 0;            ///< index of labels.front() among all commands
  std::size_t undo_steps = 0;
  std::size_t redo_steps = 0;
  std::filesystem::path folder;  ///< where the log is
  bool unsaved = false;          ///< it has no name yet; what was done is kept all the same
  bool writable = true;
};

/// Lights that were found beyond one solve, for the lighter to choose from.
struct Offer {
  std::string title;
  std::shared_ptr<const Image> picture;  ///< small
  ParamState lights;
  SolveReport report;
};

struct StudioSnapshot {
  std::uint64_t version = 0;  ///< grows
  std::shared_ptr<const ShotFacts> facts;
  std::shared_ptr<const Image> picture;  ///< of the lights shown, linear RGB
  std::shared_ptr<const PaintedPictures> painted;
  /// Strokes from this id on are not in the picture yet: no solve has answered them. 0: all are.
  std::uint32_t unanswered = 0;
  std::uint64_t strokes_taken = 0;  ///< gestures of the hand that `painted` holds, since the thread began
  std::size_t points_taken = 0;     ///< of the stroke under the hand
  EventCost cost;
  std::shared_ptr<const LayerStack> layers;  ///< without pixels: what can be changed of the paint; never null
  bool ground = false;                       ///< there is paint whose strokes are not known
  std::shared_ptr<const ParamState> shown;
  std::vector<std::string> solo;     ///< lights that alone are in the picture; none: all
  std::vector<std::string> waiting;  ///< lights that begin where the paint will say
  int free_dofs = 0;
  float nu = 0.1F;
  float delta = 0.5F;
  bool any_paint = false;
  bool proposal = false;  ///< the lights shown are a solve's, not those in force
  bool solving = false;
  bool live = true;  ///< the lights follow the brush
  std::optional<SolveReport> report;
  std::optional<Verdict> verdict;
  std::shared_ptr<const std::vector<Offer>> offers;  ///< null: nothing was looked for
  HistoryFacts history;
  std::shared_ptr<const FrameFacts> frames;  ///< null without a session
};

}  // namespace luminist
