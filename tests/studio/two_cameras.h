#pragma once
// tests/studio/two_cameras.h -- a scene that is seen from two sides.
#include <string>

#include "scene/scene.h"
#include "studio/free_view.h"
#include "support/fixtures.h"

namespace luminist {

inline constexpr const char* kFrontCamera = "front";
inline constexpr const char* kSideCamera = "100%/side";  ///< which no path can hold as it is

/// The scene of a file (ball_obj()), seen by kFrontCamera and kSideCamera. errors those of load_scene().
inline Result<Scene> two_cameras(const std::string& path, Diagnostics& diagnostics) {
  LUM_TRY(Scene scene, load_scene(path, {}, diagnostics));
  scene.cameras[0].name = kFrontCamera;
  Camera side = camera_at(Vec3(5.0F, 2.0F, 0.0F), Vec3(0.0F, 1.0F, 0.0F), 0.7F);
  side.name = kSideCamera;
  scene.cameras.push_back(side);
  return scene;
}

}  // namespace luminist
