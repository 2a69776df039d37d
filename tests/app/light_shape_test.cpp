#include "app/light_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/fixtures.h"

namespace luminist {
namespace {

class LightShapes : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    light_ = make_light(types_, "cinematic", "key", SceneFrame{}).value();
    pose_ = {Vec3(0.0F, 0.0F, 4.0F), Vec3(0.0F, 0.0F, -1.0F)};
    shape_ = {Vec3(0.5F, 0.25F, 0.1F), Vec2(1.0F, 0.5F), Vec2(6.0F, 2.0F)};
  }
  [[nodiscard]] ShapeHandle handle(ShapePart part, float reach) const {
    for (const ShapeHandle& each : shape_handles(pose_, shape_, reach)) {
      if (each.part == part) return each;
    }
    ADD_FAILURE() << "there is no such handle";
    return {};
  }
  LightTypes types_;
  std::optional<Light> light_;
  LightPose pose_;
  LightShape shape_;
};

TEST_F(LightShapes, AreFoundByTheRolesOfParameters) {
  const LightShape shape = shape_of(*light_);
  ASSERT_TRUE(shape.barn && shape.near_cutoff && shape.far_cutoff);
  EXPECT_LT(shape.near_cutoff->x, shape.far_cutoff->x);
  const Light point = make_light(types_, "point", "lamp", SceneFrame{}).value();
  EXPECT_FALSE(shape_of(point).barn);
}

TEST_F(LightShapes, OnlyWhatWasTurnedIsAssigned) {
  const LightShape before = shape_of(*light_);
  EXPECT_TRUE(shape_assignments(*light_, before, before).empty());
  LightShape now = before;
  now.far_cutoff->x = 3.0F;
  const std::vector<std::string> turned = shape_assignments(*light_, now, before);
  ASSERT_EQ(turned.size(), 1U);
  EXPECT_EQ(turned.front(), "lights/key/far_cutoff=3,2");
}

TEST_F(LightShapes, TheFourSidesAreHeldOnTheEdgeOfTheLight) {
  const std::vector<Vec3> ring = barn_ring(pose_, shape_, 4.0F);
  for (const ShapePart part : {ShapePart::kRight, ShapePart::kLeft, ShapePart::kUp, ShapePart::kDown}) {
    float nearest = 1e9F;
    for (const Vec3& place : ring) nearest = std::min(nearest, glm::length(place - handle(part, 4.0F).at));
    EXPECT_LT(nearest, 3e-3F) << static_cast<int>(part) << ": the root of what the sine of pi is rounded to";
  }
}

TEST_F(LightShapes, ASideThatIsDraggedOutwardsWidensBoth) {
  const LightShape wider = dragged_shape(shape_, ShapePart::kLeft, 0.8F, 4.0F);
  EXPECT_FLOAT_EQ(wider.barn->x, 0.7F);
  EXPECT_FLOAT_EQ(wider.barn->y, 0.25F);
  EXPECT_GT(dragged_shape(shape_, ShapePart::kUp, -50.0F, 4.0F).barn->y, 0.0F) << "it never turns inside out";
}

TEST_F(LightShapes, ACutoffIsHeldWhereItLiesUnlessThatIsFarOff) {
  EXPECT_NEAR(glm::length(handle(ShapePart::kNear, 4.0F).at - pose_.position), 1.0F, 1e-6F);
  EXPECT_NEAR(glm::length(handle(ShapePart::kFar, 4.0F).at - pose_.position), 6.0F, 1e-5F);
  EXPECT_NEAR(glm::length(handle(ShapePart::kFar, 1.0F).at - pose_.position), kFarthest, 1e-5F);
  // From there a drag goes on: the light ends where its handle is.
  EXPECT_NEAR(dragged_shape(shape_, ShapePart::kFar, -0.6F, 1.0F).far_cutoff->x, kFarthest - 0.6F, 1e-5F);
  EXPECT_EQ(dragged_shape(shape_, ShapePart::kNear, -9.0F, 4.0F).near_cutoff->x, 0.0F);
}

TEST_F(LightShapes, ACutoffRingLiesAtItsDistanceFromTheLight) {
  for (const Vec3& place : cutoff_ring(pose_, shape_, 2.5F)) {
    EXPECT_NEAR(glm::length(place - pose_.position), 2.5F, 1e-5F);
  }
}

TEST_F(LightShapes, ADragAlongAWayLeadsAsFarAsThePointerGoes) {
  Camera camera;
  camera.fov_y = 1.0F;
  camera.world_from_camera[3] = Vec4(0.0F, 0.0F, 5.0F, 1.0F);
  const Vec3 point(0.2F, 0.1F, 0.0F);
  const Vec3 way(1.0F, 0.0F, 0.0F);
  const auto from = project(camera, point, 640, 480);
  const auto to = project(camera, point + 0.3F * way, 640, 480);
  ASSERT_TRUE(from && to);
  const auto length = slid(camera, point, way, *to - *from, 640, 480);
  ASSERT_TRUE(length);
  EXPECT_NEAR(*length, 0.3F, 1e-3F);
  EXPECT_FALSE(slid(camera, Vec3(0.0F), Vec3(0.0F, 0.0F, 1.0F), Vec2(10.0F, 0.0F), 640, 480)) << "towards the eye";
}

}  // namespace
}  // namespace luminist
