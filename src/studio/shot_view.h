#pragma once
// studio/shot_view.h -- from where a shot is looked at: its own camera and size, and any place besides.
#include <string>

#include "studio/free_view.h"
#include "studio/session.h"

namespace luminist {

/// Obtained by Session::view(); the session outlives it.
class ShotView {
 public:
  explicit ShotView(Session& session) : session_(&session) {}

  /// Another camera ("": the scene's first) or size in pixels, as one command. The paint of the camera that is left
  /// stays with it. What is painted in another size, at any frame and by any camera, was made for the picture before
  /// and goes with it; undo brings both back. cost opening the shot. errors kUsage for an unknown camera (nearest name)
  /// or a bad size, kLimit.
  Result<void> reframe(const std::string& camera, int width, int height);

  /// Another camera ("": the scene's first) and frame, as one command; both keep their paint. cost as Session::go_to(),
  /// for another camera as reframe(). errors kUsage for an unknown camera (nearest name) or a number that is not
  /// finite.
  Result<void> look_through(const Vantage& at);

  /// The shot from anywhere, valid until the shot, its style or its frame is another. Nothing is recorded.
  /// errors FreeView::open()'s. cost reading the scene, once.
  Result<FreeView*> from_anywhere();
  /// FreeView::put_away(), where somebody looked.
  void put_away();

 private:
  /// Shows another shot of the same scene and style, as one command.
  Result<void> show(Shot shot, const std::string& label, const std::string& action);

  Session* session_;
};

}  // namespace luminist
