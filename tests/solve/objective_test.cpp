#include "solve/objective.h"

#include <gtest/gtest.h>

#include "solve/fake_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class ObjectiveTest : public testing::Test {
 protected:
  ObjectiveTest() : renderer_(32, 32), state_(renderer_.empty_state()) {
    state_.rig.lights.push_back(hidden_light(renderer_, "spot", 2));
    target_ = renderer_.target_of(renderer_.empty_state(), renderer_.empty_state());
  }
  FakeRenderer renderer_;
  ParamState state_;
  Target target_;
};

TEST_F(ObjectiveTest, IsTheErrorOfThePictureInsideTheUnitCube) {
  Objective objective(renderer_, state_, target_);
  LUM_ASSERT_OK(const double error, renderer_.error(state_, target_));
  LUM_ASSERT_OK(const double epsilon, objective.evaluate(objective.unit(state_)));
  EXPECT_NEAR(epsilon, error, 1e-6);  // values go through [0,1] and back into floats
}

TEST_F(ObjectiveTest, AddsThePenaltyOutside) {
  Objective objective(renderer_, state_, target_);
  std::vector<double> x = objective.unit(state_);
  x[0] = 1.5;
  LUM_ASSERT_OK(const double error, renderer_.error(objective.state(x), target_));
  LUM_ASSERT_OK(const double epsilon, objective.evaluate(x));
  EXPECT_NEAR(epsilon - error, penalty(1.5), 1e-9);
}

TEST_F(ObjectiveTest, GivesTheSameBitsForTheSamePoint) {
  Objective objective(renderer_, state_, target_);
  const std::vector<double> x(static_cast<std::size_t>(objective.dofs()), 0.4);
  LUM_ASSERT_OK(const double one, objective.evaluate(x));
  LUM_ASSERT_OK(const double other, objective.evaluate(x));
  EXPECT_EQ(one, other);
}

TEST_F(ObjectiveTest, RecentredItsDirectionsStartFromTheMiddle) {
  Objective objective(renderer_, state_, target_);
  ParamState turned = state_;
  ParamBlock& light = turned.rig.lights[0].params;
  const int direction = *light.schema().by_role("direction");
  light.set_vec3(direction, glm::normalize(light.vec3(direction) + Vec3(0.4F, 0.0F, 0.0F)));
  const auto direction_dof = [&] {
    for (std::size_t k = 0; k < objective.map().list().size(); ++k) {
      if (objective.map().list()[k].param == direction) return k;
    }
    return std::size_t{0};
  }();
  objective.recentre(turned);
  EXPECT_NEAR(objective.unit(turned)[direction_dof], 0.5, 1e-12);
}

}  // namespace
}  // namespace luminist
