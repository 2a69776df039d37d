#include "app/orbit_eye.h"

#include <gtest/gtest.h>

#include "app/light_pose.h"

namespace luminist {
namespace {

const ScreenRect kRect{Vec2(100.0F, 50.0F), Vec2(740.0F, 530.0F)};

TEST(OrbitEye, LooksAtItsCenterFromItsDistance) {
  const OrbitEye eye{Vec3(1.0F, 2.0F, 3.0F), 0.8F, 0.3F, 5.0F};
  const Camera camera = eye.camera(0.7F);
  EXPECT_NEAR(glm::length(camera.position() - eye.center), 5.0F, 1e-5F);
  const auto at = project(camera, eye.center, 640, 480);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x, 320.0F, 1e-2F);
  EXPECT_NEAR(at->y, 240.0F, 1e-2F);
}

TEST(OrbitEye, StandsWhereACameraStands) {
  const OrbitEye there{Vec3(0.5F, -1.0F, 2.0F), -2.0F, 0.4F, 3.0F};
  const Camera camera = there.camera(0.7F);
  const OrbitEye eye = orbit_from(camera, there.center);
  EXPECT_NEAR(glm::length(eye.camera(0.7F).position() - camera.position()), 0.0F, 1e-4F);
  EXPECT_NEAR(glm::length(eye.center - there.center), 0.0F, 1e-4F);
}

TEST(OrbitEye, WhatLiesInTheCenterFollowsAPan) {
  OrbitEye eye{Vec3(0.0F), 0.3F, 0.2F, 4.0F};
  const Vec3 before = eye.center;
  eye.pan_by(Vec2(40.0F, -10.0F), 0.7F, 480);
  const auto at = project(eye.camera(0.7F), before, 640, 480);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->x, 360.0F, 1e-1F);
  EXPECT_NEAR(at->y, 230.0F, 1e-1F);
}

TEST(OrbitEye, AWayThroughThePictureMeetsWhatIsSeenThere) {
  const Camera camera = OrbitEye{Vec3(0.0F), 0.3F, 0.2F, 4.0F}.camera(0.7F);
  const Vec3 point(0.3F, -0.2F, 0.4F);
  const auto at = project(camera, point, 640, 480);
  ASSERT_TRUE(at);
  const Vec3 way = way_through(camera, kRect, kRect.lo + *at);
  EXPECT_NEAR(glm::length(glm::cross(way, glm::normalize(point - camera.position()))), 0.0F, 1e-4F);
}

TEST(OrbitEye, NeverTurnsOverThePole) {
  OrbitEye eye;
  eye.turn_by(Vec2(0.0F, 1e5F));
  EXPECT_LT(eye.height, 1.5707F);
}

}  // namespace
}  // namespace luminist
