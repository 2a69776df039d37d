#pragma once
// tests/studio/session_fixture.h -- a session on a ball.
#include <fstream>
#include <memory>

#include "studio/session.h"
#include "support/ball_scene.h"
#include "support/fixtures.h"

namespace luminist {

/// 48 x 36 pixels of a ball on a floor, without lights.
class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.file("ball.obj")) << ball_obj();
    std::ofstream(folder_.file("ball.mtl")) << ball_material();
    auto device = Device::create_headless();
    ASSERT_TRUE(device) << device.error().message();
    device_ = std::make_unique<Device>(std::move(*device));
    session_ = open();
    ASSERT_NE(session_, nullptr);
  }

  [[nodiscard]] Shot shot() const {
    Shot shot;
    shot.scene = "ball.obj";
    shot.width = 48;
    shot.height = 36;
    return shot;
  }
  std::unique_ptr<Session> open() { return open(shot()); }
  std::unique_ptr<Session> open(const Shot& shot) {
    auto session = Session::open(*device_, roots_, shot, folder_.path(), diagnostics_);
    EXPECT_TRUE(session) << session.error().message();
    return session ? std::move(*session) : nullptr;
  }
  std::unique_ptr<Session> open_project(const std::string& name, Project::Access access = Project::Access::kWrite) {
    auto session = Session::open_project(*device_, roots_, folder_.path() / name, access, diagnostics_);
    EXPECT_TRUE(session) << session.error().message();
    return session ? std::move(*session) : nullptr;
  }

  /// Light on the upper part of the ball.
  static StrokeFile light_strokes() {
    Stroke stroke;
    stroke.brush.color = Vec3(1.0F, 0.9F, 0.8F);
    stroke.brush.diameter = 0.5F;
    stroke.brush.gradient = 1.0F;
    stroke.brush.add_light = true;
    stroke.points = {{0.6F, 0.4F}, {0.7F, 0.5F}};
    return {0.1F, 0.5F, {stroke}};
  }
  static SolveOptions few_evals() {
    SolveOptions options;
    options.max_evals = 20;
    return options;
  }
  std::string hash() { return session_->project().document().hash(); }
  Image picture() {
    auto picture = session_->picture();
    EXPECT_TRUE(picture) << picture.error().message();
    return picture ? **picture : Image();
  }

  TemporaryFolder folder_;
  AssetRoots roots_ = AssetRoots::standard();
  Diagnostics diagnostics_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<Session> session_;
};

}  // namespace luminist
