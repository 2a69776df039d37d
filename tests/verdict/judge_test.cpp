#include "verdict/judge.h"

#include <numeric>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "solve/fake_renderer.h"
#include "support/fixtures.h"
#include "verdict/known_case.h"

namespace luminist {
namespace {

/// A locked light from the front and paint on the first sphere.
class JudgeTest : public testing::Test {
 protected:
  JudgeTest() {
    state_.rig.ambient.set_vec3(0, Vec3(0.05F));
    Light key = fake_.cinematic("key");
    const Vec3 place(-1.0F, 3.0F, 4.0F);
    key.params.set_vec3(param(key, "position"), place);
    key.params.set_vec3(param(key, "direction"), glm::normalize(Vec3(0.0F, 0.5F, 0.0F) - place));
    key.params.set_vec3(param(key, "color"), Vec3(0.8F));
    key.params.set_param_locked(-1, true);
    state_.rig.lights = {std::move(key)};
  }
  void paint(const ParamState& wanted) {
    target_ = fake_.target_of(state_, state_);
    const Image picture = *fake_.render(wanted, {});
    for (std::size_t i = 0; i < target_.stroke.size(); ++i) {
      target_.importance.data[i] = 0.02F;
      if (fake_.surface().object[i] != 3) continue;
      target_.stroke[i] = 1;
      target_.importance.data[i] = 1.0F;
      target_.color.set_rgb(i, picture.rgb(i));
    }
  }
  StrokeVerdict judged(const ParamState& state) {
    const Image picture = *fake_.render(state, {});
    auto verdict = judge(fake_, state, target_, picture);
    EXPECT_TRUE(verdict) << verdict.error().message();
    verdict_ = std::move(*verdict);
    EXPECT_EQ(verdict_.strokes.size(), 1U);
    return verdict_.strokes.at(0);
  }
  ParamState brighter() {
    ParamState wanted = state_;
    wanted.rig.lights[0].params.set_vec3(param(wanted.rig.lights[0], "color"), Vec3(2.0F, 1.6F, 1.2F));
    return wanted;
  }
  void unlock(const char* name) {
    state_.rig.lights[0].params.set_param_locked(param(state_.rig.lights[0], name), false);
  }

  FakeRenderer fake_{64, 48};
  ParamState state_ = fake_.empty_state();
  Target target_;
  Verdict verdict_;
};

TEST_F(JudgeTest, APictureAsPaintedIsMet) {
  unlock("color");
  paint(brighter());
  const StrokeVerdict stroke = judged(brighter());
  EXPECT_EQ(stroke.outcome, StrokeOutcome::kMet);
  EXPECT_EQ(verdict_line(stroke), "stroke 1 on sphere 1: met");
  EXPECT_FALSE(verdict_.least_epsilon);
}

TEST_F(JudgeTest, ALockedColourIsNamedAndUnlockingItIsAdvised) {
  unlock("shadow_density");
  paint(brighter());
  const StrokeVerdict stroke = judged(state_);
  EXPECT_EQ(stroke.outcome, StrokeOutcome::kImpossible);
  EXPECT_EQ(stroke.cause, Cause::kLockedParameter);
  ASSERT_EQ(stroke.remedy.patterns.size(), 1U);
  EXPECT_EQ(stroke.remedy.patterns[0], "lights/key/color");
}

TEST_F(JudgeTest, WhatTheSearchLeftUndoneIsMissedAndTheBetterLightsAreAtHand) {
  unlock("color");
  paint(brighter());
  const StrokeVerdict stroke = judged(state_);
  EXPECT_EQ(stroke.outcome, StrokeOutcome::kMissed);
  ASSERT_TRUE(stroke.remedy.state);
  EXPECT_LT(fake_.error(*stroke.remedy.state, target_).value(), 0.97 * fake_.error(state_, target_).value());
}

TEST_F(JudgeTest, DarkerThanTheAmbientIsImpossibleWithACertificate) {
  state_.rig.ambient.set_vec3(0, Vec3(0.6F));
  unlock("color");
  ParamState wanted = state_;
  wanted.rig.ambient.set_vec3(0, Vec3(0.1F));
  // The search has turned the light off, which is all that it can do.
  state_.rig.lights[0].params.set_vec3(param(state_.rig.lights[0], "color"), Vec3(0.0F));
  wanted.rig.lights[0] = state_.rig.lights[0];
  paint(wanted);
  const StrokeVerdict stroke = judged(state_);
  EXPECT_EQ(stroke.outcome, StrokeOutcome::kImpossible);
  EXPECT_EQ(stroke.cause, Cause::kTooDark);
  EXPECT_EQ(stroke.remedy.patterns, std::vector<std::string>{"ambient/color"});
  ASSERT_TRUE(stroke.least_missed);
  EXPECT_NEAR(*stroke.least_missed, stroke.missed, 1e-6);  // all of it
  ASSERT_TRUE(verdict_.least_epsilon);
  EXPECT_LE(*verdict_.least_epsilon, verdict_.epsilon);
}

TEST_F(JudgeTest, NothingFreeAndNoPaintAreJudgedToo) {
  paint(brighter());
  EXPECT_EQ(judged(state_).outcome, StrokeOutcome::kImpossible);
  std::fill(target_.stroke.begin(), target_.stroke.end(), 0U);
  LUM_ASSERT_OK(const Verdict verdict, judge(fake_, state_, target_, *fake_.render(state_, {})));
  EXPECT_TRUE(verdict.strokes.empty());
}

TEST_F(JudgeTest, StylesThatJoinTheirLightsAreJudgedWithoutACertificate) {
  FakeRenderer toon(64, 48, FakeStyle::kToon);
  unlock("shadow_density");
  target_ = toon.target_of(state_, state_);
  const Image picture = *toon.render(brighter(), {});
  for (std::size_t i = 0; i < target_.stroke.size(); ++i) {
    target_.importance.data[i] = 0.02F;
    if (toon.surface().object[i] != 3) continue;
    target_.stroke[i] = 1;
    target_.importance.data[i] = 1.0F;
    target_.color.set_rgb(i, picture.rgb(i));
  }
  LUM_ASSERT_OK(const Verdict verdict, judge(toon, state_, target_, *toon.render(state_, {})));
  ASSERT_EQ(verdict.strokes.size(), 1U);
  EXPECT_EQ(verdict.strokes[0].cause, Cause::kLockedParameter);
  EXPECT_FALSE(verdict.strokes[0].least_missed);
  EXPECT_FALSE(verdict.least_epsilon);
}

TEST_F(JudgeTest, PaintWithoutDotsIsMetByDotsOfItsToneWhereTheMetricBlurs) {
  FakeRenderer dotted(192, 144, FakeStyle::kDotted);
  unlock("color");
  target_ = dotted.target_of(state_, state_);
  SampleSet all{1, std::vector<std::uint32_t>(target_.stroke.size())};
  std::iota(all.pixels.begin(), all.pixels.end(), 0U);
  std::vector<Vec3> tones(all.pixels.size());
  const ParamState wanted = brighter();
  const Candidate candidate{&wanted, Candidate::kAllLights};
  ASSERT_TRUE(dotted.evaluate({&candidate, 1}, all, {}, tones));
  for (std::size_t i = 0; i < target_.stroke.size(); ++i) {
    target_.importance.data[i] = 0.02F;
    if (dotted.surface().object[i] != 3) continue;
    target_.stroke[i] = 1;
    target_.importance.data[i] = 1.0F;
    target_.color.set_rgb(i, tones[i]);
  }
  LUM_ASSERT_OK(const Verdict there, judge(dotted, wanted, target_, *dotted.render(wanted, {})));
  ASSERT_EQ(there.strokes.size(), 1U);
  EXPECT_EQ(there.strokes[0].outcome, StrokeOutcome::kMet);
  LUM_ASSERT_OK(const Verdict short_of, judge(dotted, state_, target_, *dotted.render(state_, {})));
  ASSERT_EQ(short_of.strokes.size(), 1U);
  EXPECT_EQ(short_of.strokes[0].outcome, StrokeOutcome::kMissed);
}

TEST_F(JudgeTest, TheSameSolveGetsTheSameVerdict) {
  unlock("shadow_density");
  paint(brighter());
  judged(state_);
  const std::string first = verdict_to_json(verdict_).dump();
  judged(state_);
  EXPECT_EQ(first, verdict_to_json(verdict_).dump());
}

}  // namespace
}  // namespace luminist
