#include "studio/constraint_words.h"

#include "studio/session_fixture.h"

namespace luminist {
namespace {

/// A ball of radius 1 on a floor at height 0 (tests/support/ball_scene.h) and two lights.
class ConstraintWordsTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    rig_ = session_->state().rig;
    for (const char* name : {"key", "key light"}) {
      rig_->lights.push_back(*make_light(session_->stage().types, "cinematic", name, session_->stage().frame));
    }
    ParamBlock& key = rig_->lights[0].params;
    key.set_vec3(*key.schema().by_role("position"), Vec3(0.0F, 5.0F, 0.0F));
    key.set_vec3(*key.schema().by_role("direction"), Vec3(0.0F, -1.0F, 0.0F));
  }
  Result<Constraint> parse(const std::string& words) const {
    const Stage& stage = session_->stage();
    return parse_constraint(words, *rig_, stage.renderer->surface(), stage.bounds);
  }
  /// What the words become, in words without names of places.
  std::string resolved(const std::string& words) const {
    const auto constraint = parse(words);
    EXPECT_TRUE(constraint) << constraint.error().message();
    return constraint ? to_text(*constraint) : "";
  }

  std::optional<LightRig> rig_;
};

TEST_F(ConstraintWordsTest, WhatAConstraintSaysOfItselfReadsBack) {
  for (const char* words :
       {"lights/key on plane 0,2,0 0,-1,0", "lights/key at distance 1.5 from 0.1,1,0",
        "lights/key mirror of lights/key light across plane 1,2,3 4,5,6", "lights/key light same color as lights/key",
        "lights/key same color as lights/key light times 0.5"}) {
    EXPECT_EQ(resolved(words), words);
  }
}

TEST_F(ConstraintWordsTest, SidesOfTheSceneHaveNames) {
  EXPECT_EQ(resolved("lights/key on floor"), "lights/key on plane 0,0,0 0,1,0");
  EXPECT_EQ(resolved("lights/key on ceiling"), "lights/key on plane 0,2,0 0,-1,0");
  // The camera of a bare mesh looks from the front (+Z).
  EXPECT_EQ(resolved("lights/key on back wall"), "lights/key on plane 0,1,-3 0,0,1");
  EXPECT_EQ(resolved("lights/key on left wall"), "lights/key on plane -3,1,0 1,0,0");
  EXPECT_EQ(resolved("lights/key light mirror of lights/key across middle"),
            "lights/key light mirror of lights/key across plane 0,1,0 1,0,0");
}

TEST_F(ConstraintWordsTest, APlaneThatHasANameIsCalledByIt) {
  const Stage& stage = session_->stage();
  const auto words = [&](const std::string& text) {
    const auto constraint = parse(text);
    return constraint ? rule_words(*constraint, stage.renderer->surface(), stage.bounds) : constraint.error().message();
  };
  for (const char* name : kPlaneNames)
    EXPECT_EQ(words(std::string("lights/key on ") + name), std::string("on ") + name);
  EXPECT_EQ(words("lights/key light mirror of lights/key across middle"), "mirror of lights/key across middle");
  EXPECT_EQ(words("lights/key on plane 0,1.5,0 0,-1,0"), "on plane 0,1.5,0 0,-1,0") << "half way up there is no side";
  EXPECT_EQ(words("lights/key on plane 7,2,0 0,-1,0"), "on ceiling") << "any point of the plane will do";
}

TEST_F(ConstraintWordsTest, APlaneIsPickedFromThePicture) {  // left of the ball there is floor
  LUM_ASSERT_OK(const Constraint constraint, parse("lights/key on surface 0.35,0.52"));
  const Plane& plane = std::get<OnPlane>(constraint.rule).plane;
  EXPECT_NEAR(plane.point.y, 0.0F, 1e-4F);                                // unprojected from a depth in floats
  EXPECT_LT(glm::distance(plane.normal, Vec3(0.0F, 1.0F, 0.0F)), 1e-6F);  // drivers round otherwise
}

TEST_F(ConstraintWordsTest, ADistanceIsMeasuredFromWhatTheLightShinesOn) {
  // The scene reaches from 0 to 2, so that its centre is at 1 on the light's axis.
  EXPECT_EQ(resolved("lights/key at distance present from aim"), "lights/key at distance 4 from 0,1,0");
  ParamBlock& key = rig_->lights[0].params;
  key.set_vec3(*key.schema().by_role("direction"), Vec3(0.0F, 1.0F, 0.0F));
  const Error error = error_of(parse("lights/key at distance 2 from aim"));
  EXPECT_NE(error.what.find("does not shine towards"), std::string::npos) << error.message();
}

TEST_F(ConstraintWordsTest, SaysWhatItDoesNotUnderstand) {
  const std::vector<std::array<const char*, 2>> mistakes = {
      {"", "the path of a light"},
      {"key on floor", "the path of a light"},
      {"lights/kei on floor", "did you mean \"key\"?"},
      {"lights/key", "no constraint"},
      {"lights/key under floor", "no constraint"},
      {"lights/key on flor", "the name of a plane"},
      {"lights/key on floor today", "one word too many"},
      {"lights/key on plane 0,2 0,1,0", "three numbers"},
      {"lights/key on plane 0,2,0", "three numbers"},
      {"lights/key on surface 9,0.5", "nothing is visible there"},
      {"lights/key at distance far from aim", "give a number"},
      {"lights/key at distance 2", "measured from somewhere"},
      {"lights/key mirror of lights/kez light across floor", "there is no light \"kez\""},
      {"lights/key mirror of lights/key light", "needs a plane"},
      {"lights/key same color as lights/key light times x", "give a number"},
      {"lights/key barn between 0.1", "a range ends"},
      {"lights/key barn between 0.1 and most", "give a number"},
  };
  for (const auto& [words, says] : mistakes) {
    const Error error = error_of(parse(words));
    EXPECT_EQ(error.kind, ErrorKind::kUsage) << words;
    EXPECT_EQ(error.field, words);
    EXPECT_NE(error.message().find(says), std::string::npos) << error.message();
  }
}

TEST_F(ConstraintWordsTest, ANewConstraintReplacesThatOfItsKind) {
  const Stage& stage = session_->stage();
  const auto add = [&](const std::vector<std::string>& words) {
    return add_constraints(*rig_, words, stage.renderer->surface(), stage.bounds);
  };
  LUM_EXPECT_OK(add({"lights/key on floor", "lights/key light same color as lights/key"}));
  LUM_EXPECT_OK(add({"lights/key on ceiling"}));
  ASSERT_EQ(rig_->constraints.size(), 2U);
  EXPECT_EQ(rig_->lights[0].params.vec3(*rig_->lights[0].params.schema().by_role("position")), Vec3(0.0F, 2.0F, 0.0F));
  LUM_EXPECT_OK(add({"lights/key barn.x between 0.1 and 0.2", "lights/key barn.y between 0.3 and 0.4"}));
  LUM_EXPECT_OK(add({"lights/key barn.x between 0.2 and 0.25"}));
  ASSERT_EQ(rig_->constraints.size(), 4U) << "one range for each number";
  EXPECT_EQ(to_text(rig_->constraints[3]), "lights/key barn.x between 0.2 and 0.25");
  // All or none.
  EXPECT_EQ(error_of(add({"lights/key on floor", "lights/key same color as lights/key light"})).kind,
            ErrorKind::kUsage);
  EXPECT_EQ(to_text(rig_->constraints[1]), "lights/key on plane 0,2,0 0,-1,0");
}

/// Gestures of a session.
class ConstraintGestureTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    for (const char* name : {"key", "fill"}) {
      LUM_EXPECT_OK(session_->add_light({.name = name, .from_paint = false, .lock_others = false}));
    }
  }
  [[nodiscard]] Vec3 position(const char* name) const {
    const Light* light = session_->state().rig.find(name);
    return light->params.vec3(*light->params.schema().by_role("position"));
  }
};

TEST_F(ConstraintGestureTest, ConstrainingIsOneGestureAndIsUndone) {
  const std::string before = hash();
  const Vec3 place = position("key");
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->constrain({"lights/key on ceiling", "lights/fill mirror of lights/key across middle"}));
  EXPECT_EQ(session_->project().undo_steps(), steps + 1);
  EXPECT_EQ(position("key").y, 2.0F);
  EXPECT_EQ(position("fill"), position("key") * Vec3(-1.0F, 1.0F, 1.0F));
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(position("key"), place);
  EXPECT_TRUE(session_->state().rig.constraints.empty());
  LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(session_->state().rig.constraints.size(), 2U);
  EXPECT_EQ(position("key").y, 2.0F);
}

TEST_F(ConstraintGestureTest, WhatIsSetByHandMovesWhatFollows) {
  LUM_EXPECT_OK(session_->constrain({"lights/key on ceiling", "lights/fill mirror of lights/key across middle"}));
  LUM_EXPECT_OK(session_->set({"lights/key/position=1.5,9,0.5", "lights/key/color=0.25,0.5,1"}));
  EXPECT_EQ(position("key"), Vec3(1.5F, 2.0F, 0.5F));
  EXPECT_EQ(position("fill"), Vec3(-1.5F, 2.0F, 0.5F));
  const ParamBlock& fill = session_->state().rig.find("fill")->params;
  EXPECT_EQ(fill.vec3(*fill.schema().by_role("color")), Vec3(0.25F, 0.5F, 1.0F));
  EXPECT_EQ(error_of(session_->set({"lights/fill/color=1,1,1"})).kind, ErrorKind::kUsage);
}

TEST_F(ConstraintGestureTest, ARemovedLightTakesItsConstraintsAlongWithAWarning) {
  LUM_EXPECT_OK(session_->constrain({"lights/fill mirror of lights/key across middle"}));
  const Vec3 place = position("fill");
  const std::size_t warnings = diagnostics_.warnings().size();
  LUM_EXPECT_OK(session_->remove_light("key"));
  ASSERT_EQ(diagnostics_.warnings().size(), warnings + 1);
  EXPECT_NE(diagnostics_.warnings().back().what.find("lights/fill mirror of lights/key"), std::string::npos);
  EXPECT_TRUE(session_->state().rig.constraints.empty());
  EXPECT_EQ(position("fill"), place);
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(session_->state().rig.constraints.size(), 1U);
}

TEST_F(ConstraintGestureTest, AnImpossibleConstraintChangesNothing) {
  const std::string before = hash();
  EXPECT_EQ(error_of(session_->constrain({"lights/key on ceiling", "lights/key same color as lights/key"})).kind,
            ErrorKind::kUsage);
  EXPECT_EQ(error_of(session_->set_constraints({{"ghost", OnPlane{}}})).kind, ErrorKind::kUsage);
  EXPECT_EQ(hash(), before);
}

TEST_F(ConstraintGestureTest, ConstraintsAreDroppedByReplacingThemWithNone) {
  LUM_EXPECT_OK(session_->constrain({"lights/fill same color as lights/key"}));
  LUM_EXPECT_OK(session_->set_constraints({}));
  LUM_EXPECT_OK(session_->set({"lights/fill/color=1,1,1"}));
}

TEST_F(ConstraintGestureTest, TheyComeBackWithTheProject) {
  LUM_EXPECT_OK(session_->constrain({"lights/key on ceiling", "lights/fill same color as lights/key times 0.5"}));
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "shot.lum"));
  const std::string saved = hash();
  session_.reset();  // lets go of the project
  session_ = open_project("shot.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(hash(), saved);
  EXPECT_EQ(session_->state().rig.constraints.size(), 2U);
  EXPECT_EQ(error_of(session_->set({"lights/fill/color=1,1,1"})).kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace luminist
