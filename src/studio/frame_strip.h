#pragma once
// studio/frame_strip.h -- small pictures of a shot's frames: a strip around the present one, and any while a hand drags
// through time.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "studio/frame_facts.h"
#include "studio/session.h"
#include "studio/studio_snapshot.h"

namespace luminist {

/// Draws frames beside the session, which stays where it is and records nothing. Each picture is one call, so that
/// whoever waits for something else never waits for more than one of them. Stages are kept while the strip needs them:
/// other lights cost only a small picture each. Path-traced pictures are smaller still, of few paths, and smoothed.
/// thread the device's.
class FrameStrip {
 public:
  /// device outlives it.
  FrameStrip(Device& device, AssetRoots roots) : device_(&device), roots_(std::move(roots)) {}

  /// How many pictures are wanted, every so many frames. 0: none.
  void want(int pictures, int step) { pictures_ = pictures, step_ = step; }
  /// Makes one that is missing or old, the nearest to the present frame first. lights: those shown.
  /// returns whether there was one to make. errors those of open_stage(), the renderer's: it is not tried again then.
  Result<bool> step(Session& session, const ParamState& lights);

  /// From now on the picture shown is that of another frame. errors as above.
  Result<void> preview(Session& session, const ParamState& lights, double frame);
  void leave_preview() { preview_.reset(); }
  /// The style was written anew: all of it is old.
  void forget() { shot_.clear(); }

  /// Adds what there is to say of the frames to a snapshot; a preview takes the place of its picture and lights.
  void tell(Session& session, StudioSnapshot& next) const;

 private:
  struct Kept {
    double frame = 0.0;
    std::unique_ptr<Stage> stage;
  };
  struct Drawn {
    double frame = 0.0;
    std::string lights;  ///< what it was drawn under
    std::shared_ptr<const Image> picture;
  };
  struct Preview {
    double frame = 0.0;
    ParamState lights;
    std::shared_ptr<const Image> picture;
  };
  void attend(const Session& session);
  Result<const Stage*> stage_at(Session& session, double frame);
  Result<Image> draw(Session& session, const ParamState& lights, double frame);
  [[nodiscard]] std::vector<double> wanted(const Session& session) const;

  Device* device_;
  AssetRoots roots_;
  int pictures_ = 0;
  int step_ = 1;
  std::string shot_;  ///< what the stages are of
  std::string lights_;
  std::string failed_;        ///< shot and lights of what could not be drawn
  std::vector<Kept> stages_;  ///< the last used one behind
  std::vector<Drawn> drawn_;
  std::optional<Preview> preview_;
};

/// From the first to the last frame of what moves, has keys or paint; two seconds at least. cost O(keys + entries).
FrameFacts frame_facts(Session& session);

}  // namespace luminist
