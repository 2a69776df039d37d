#include "solve/aim_map.h"

#include <gtest/gtest.h>

#include "solve/fake_renderer.h"

namespace luminist {
namespace {

class AimMapTest : public testing::Test {
 protected:
  AimMapTest() : renderer_(16, 16), state_(renderer_.empty_state()) {
    state_.rig.lights.push_back(hidden_light(renderer_, "spot", 3));
  }
  [[nodiscard]] const ParamBlock& params(const ParamState& state) const { return state.rig.lights[0].params; }
  [[nodiscard]] Vec3 vec3(const ParamState& state, const char* role) const {
    return params(state).vec3(*params(state).schema().by_role(role));
  }
  FakeRenderer renderer_;
  ParamState state_;
};

TEST_F(AimMapTest, ItsOriginIsTheStateItself) {
  const AimMap map(state_, renderer_.frame(), Vec3(0.0F));
  EXPECT_EQ(map.dofs(), 18);
  const ParamState same = map.at(map.origin());
  EXPECT_LT(glm::distance(vec3(same, "position"), vec3(state_, "position")), 1e-5F);  // through [0,1] in double
  EXPECT_LT(glm::distance(vec3(same, "direction"), vec3(state_, "direction")), 1e-5F);
}

TEST_F(AimMapTest, ALightThatMovesStillShinesOnTheSamePlaceWithTheSameWidth) {
  const AimMap map(state_, renderer_.frame(), Vec3(0.0F, 0.5F, 0.0F));
  const Vec3 place = vec3(state_, "position");
  const Vec3 way = vec3(state_, "direction");
  const float distance = glm::dot(Vec3(0.0F, 0.5F, 0.0F) - place, way);
  std::vector<double> x = map.origin();
  for (std::size_t k = 0; k < x.size(); ++k) {
    const ParamSpec& spec = params(state_).schema()[map.units().list()[k].param];
    if (spec.role == "position") x[k] += 0.05;
  }
  const ParamState moved = map.at(x);
  const Vec3 aim = place + distance * way;
  const Vec3 to_aim = aim - vec3(moved, "position");
  EXPECT_GT(glm::distance(vec3(moved, "position"), place), 0.5F);
  EXPECT_LT(glm::distance(glm::normalize(to_aim), vec3(moved, "direction")), 1e-4F);
  const float before = distance * vec3(state_, "shape").x;
  EXPECT_NEAR(glm::length(to_aim) * vec3(moved, "shape").x, before, 1e-3F * before);
}

TEST_F(AimMapTest, ALockedDirectionOrShapeStays) {
  ParamBlock& block = state_.rig.lights[0].params;
  block.set_param_locked(*block.schema().by_role("direction"), true);
  const AimMap map(state_, renderer_.frame(), Vec3(0.0F));
  std::vector<double> x = map.origin();
  x[0] += 0.1;
  EXPECT_EQ(vec3(map.at(x), "direction"), vec3(state_, "direction"));
  EXPECT_LT(glm::distance(vec3(map.at(x), "shape"), vec3(state_, "shape")), 1e-6F);
}

TEST_F(AimMapTest, ItsOriginIsMovedIntoTheRanges) {
  ParamBlock& block = state_.rig.lights[0].params;
  block.set(*block.schema().by_role("color"), 0, 9.0);
  const AimMap map(state_, renderer_.frame(), Vec3(0.0F));
  EXPECT_EQ(penalty(map.origin()), 0.0);
  EXPECT_NEAR(vec3(map.at(map.origin()), "color").x, 4.0, 1e-5);
}

TEST(RotateBetween, TakesOneUnitVectorToTheOther) {
  const Vec3 a = glm::normalize(Vec3(1.0F, 2.0F, 3.0F));
  const Vec3 b = glm::normalize(Vec3(-1.0F, 0.5F, 0.2F));
  EXPECT_LT(glm::distance(rotate_between(a, b, a), b), 1e-6F);
  const Vec3 axis = glm::normalize(glm::cross(a, b));
  EXPECT_LT(glm::distance(rotate_between(a, b, axis), axis), 1e-6F);
}

}  // namespace
}  // namespace luminist
