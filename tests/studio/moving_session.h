#pragma once
// tests/studio/moving_session.h -- a session on a scene that moves.
#include "studio/moving_ball.h"
#include "studio/session_fixture.h"

namespace luminist {

/// The ball rises by its diameter in one second.
class MovingSessionTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    LUM_ASSERT_OK(const Scene scene, moving_ball(folder_.file("ball.obj"), {0.0F, 2.0F, 0.0F}, diagnostics_));
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
