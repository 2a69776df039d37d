#include "studio/light_kinds.h"

#include "studio/session_fixture.h"

namespace luminist {
namespace {

class LightKindsTest : public SessionTest {
 protected:
  /// The picture that a light makes is what is wanted; the light itself is gone.
  void want(const std::string& type, const std::vector<std::string>& values) {
    NewLight plain;
    plain.type = type;
    plain.from_paint = false;
    LUM_ASSERT_OK(const std::string name, session_->add_light(plain));
    LUM_EXPECT_OK(session_->set(values));
    const Image wanted = picture();
    LUM_EXPECT_OK(session_->remove_light(name));
    LUM_EXPECT_OK(session_->set_target(wanted, std::nullopt));
  }
  static SolveOptions some_evals() {
    SolveOptions options;
    options.max_evals = 60;
    return options;
  }
};

TEST_F(LightKindsTest, WhatASunMadeIsMadeByASun) {
  want("sun", {"lights/light/direction=-0.5,-0.7,-0.6", "lights/light/color=0.9,0.8,0.6"});
  NewLight any;
  any.type = "any:cinematic,sun";
  LUM_ASSERT_OK(const LightKinds kinds, add_light_of_any_kind(*session_, any, some_evals(), {}));
  ASSERT_EQ(kinds.tried.size(), 2U);
  EXPECT_EQ(kinds.tried[kinds.chosen].type, "sun");
  EXPECT_EQ(kinds.tried[0].dofs, 5);
  EXPECT_LT(kinds.tried[kinds.chosen].epsilon, 0.1 * kinds.epsilon_without);
  EXPECT_EQ(session_->state().rig.find(kinds.name)->type, "sun");
  LUM_EXPECT_OK(session_->undo());
  EXPECT_TRUE(session_->state().rig.lights.empty());
}

TEST_F(LightKindsTest, WhatOnlyANarrowSpotMakesIsMadeByASpot) {
  want("cinematic", {"lights/light/position=0,4,3", "lights/light/direction=0,-0.7,-0.7",
                     "lights/light/barn=0.08,0.08,0.02", "lights/light/color=1.5,1.2,1"});
  NewLight any;
  any.type = "any:sun,cinematic";
  LUM_ASSERT_OK(const LightKinds kinds, add_light_of_any_kind(*session_, any, some_evals(), {}));
  EXPECT_EQ(kinds.tried[kinds.chosen].type, "cinematic");
}

TEST_F(LightKindsTest, NamesAreChecked) {
  NewLight any;
  any.type = "any";
  EXPECT_EQ(error_of(add_light_of_any_kind(*session_, any, some_evals(), {})).kind, ErrorKind::kNothingToDo);
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  any.type = "any:son";
  EXPECT_EQ(error_of(add_light_of_any_kind(*session_, any, some_evals(), {})).hint, "did you mean \"sun\"?");
  any.type = "any:";
  EXPECT_EQ(error_of(add_light_of_any_kind(*session_, any, some_evals(), {})).kind, ErrorKind::kUsage);
  EXPECT_FALSE(is_any_kind("anything"));
  LUM_ASSERT_OK(const auto all, kinds_named("any", session_->stage().types));
  EXPECT_EQ(all, session_->stage().types.names());
}

}  // namespace
}  // namespace luminist
