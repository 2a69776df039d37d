#pragma once
// tests/studio/moving_session.h -- a session on a scene that moves.
#include "studio/session_fixture.h"

namespace luminist {

/// The ball rises by its diameter in one second.
class MovingSessionTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_ASSERT_OK(Scene scene, load_scene(folder_.file("ball.obj"), {}, diagnostics_));
    scene.animation.nodes.push_back({.name = "lift"});
    Track rise;
    rise.times = {0.0F, 1.0F};
    rise.values = {Vec4(0.0F), Vec4(0.0F, 2.0F, 0.0F, 0.0F)};
    scene.animation.tracks.push_back(std::move(rise));
    scene.objects[0].mount.node = 0;
    hang(scene);
    moving_ = shot();
    moving_.scene = folder_.file("rising.glb");
    LUM_EXPECT_OK(save_scene(scene, moving_.scene));
    auto session = Session::open(*device_, roots_, moving_, folder_.path(), diagnostics_);
    ASSERT_TRUE(session) << session.error().message();
    session_ = std::move(*session);
  }

  Shot moving_;
};

}  // namespace luminist
