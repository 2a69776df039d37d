#pragma once
// studio/drag_goal.h -- a highlight, or the edge of a shadow, that is dragged: paint, and a solve, by one gesture.
#include <functional>
#include <string>

#include "studio/session.h"

namespace luminist {

/// A drag over the picture, in picture heights from its upper left corner, as strokes have it.
struct Drag {
  enum class What { kHighlight, kShadow };
  What what = What::kHighlight;
  Vec2 from{0.0F};
  Vec2 to{0.0F};
  std::string light;  ///< whose it is; "": the light that does most there
};

/// A bright spot on one object.
struct Highlight {
  Vec2 peak{0.0F};        ///< picture heights
  float diameter = 0.0F;  ///< of where it is brighter than half of what it adds
  Vec3 color{0.0F};       ///< of the brightest pixel at the peak
  Vec3 around{0.0F};      ///< mean radiance around it, divided by the albedo
};
/// The brightest spot near a place, on the object that is seen there. errors kNothingToDo: nothing is there, or
/// nothing that stands out by a tenth. cost O(pixels).
Result<Highlight> find_highlight(const Image& picture, const SurfaceBuffer& surface, const Vec2& near);

/// The strokes that say a drag, as if by hand. A highlight: its surroundings' light over where it was, its colour where
/// it shall be, fading as highlights do with the mirrored view of that place. A shadow: the shadow brush where it shall
/// grow to (over a lit place) or the shadow eraser where it shall shrink from (over a shadowed one); a shadow that is
/// grabbed in its middle is erased there and painted at the other place.
/// errors those of find_highlight(); kNothingToDo if a place shows nothing; the renderer's.
Result<StrokeFile> drag_strokes(Session& session, const Drag& drag);

/// The light whose highlight or shadow it is: of those that are on, the one that adds most at the place, or would
/// without shadows. errors kNothingToDo if none does, kCancelled if go_on says no, the renderer's. cost a picture a
/// light.
Result<std::string> dragged_light(Session& session, const Drag& drag, const std::function<bool()>& go_on = {});

/// Paints the strokes (one command) and begins a solve in which the place and the direction of that light alone are
/// free, also when it is accepted, and little counts but these strokes. A highlight starts where the mirrored view, or
/// the normal, says that the light should stand, if that is nearer to the paint than where it stands. returns the
/// light's name. errors as above, and those of Session::paint() and start_solve().
Result<std::string> start_drag(Session& session, const Drag& drag, const SolveOptions& options,
                               const std::function<bool()>& go_on = {});

/// How near a highlight came: of the peaks of what the light adds to the object at drag.to, those at least half as
/// bright as the brightest, the one that is nearest.
struct DragOutcome {
  Vec2 found{0.0F};       ///< picture heights
  float distance = 0.0F;  ///< from drag.to
  float reaches = 0.0F;   ///< how bright the light is at drag.to, as a share of its brightest spot on that object
};
/// Of the lights that the session shows. errors kNothingToDo if it adds nothing there, the renderer's.
Result<DragOutcome> highlight_outcome(Session& session, const Drag& drag, const std::string& light);

/// What there is to say when the solve of a drag is over: "" for a shadow, and for a highlight that came within 0.03
/// picture heights; else how far off it ended, and what would help. errors those of highlight_outcome().
Result<std::string> drag_words(Session& session, const Drag& drag, const std::string& light);

}  // namespace luminist
