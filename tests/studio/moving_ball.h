#pragma once
// tests/studio/moving_ball.h -- a scene of which something moves.
#include <string>

#include "scene/scene.h"
#include "support/fixtures.h"

namespace luminist {

/// The scene of a file (ball_obj()), whose first object goes so far in one second. errors those of load_scene().
inline Result<Scene> moving_ball(const std::string& path, const Vec3& way, Diagnostics& diagnostics) {
  LUM_TRY(Scene scene, load_scene(path, {}, diagnostics));
  scene.animation.nodes.emplace_back().name = "lift";
  Track track;
  track.times = {0.0F, 1.0F};
  track.values = {Vec4(0.0F), Vec4(way, 0.0F)};
  scene.animation.tracks.push_back(std::move(track));
  scene.objects[0].mount.node = 0;
  hang(scene);
  return scene;
}

}  // namespace luminist
