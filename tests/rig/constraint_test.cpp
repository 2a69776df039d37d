#include "rig/constraint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "base/files.h"
#include "rig/constraint_fixture.h"

namespace luminist {
namespace {

constexpr float kRounding = 1e-6F;  // of numbers up to 3, stored in floats

TEST_F(ConstraintTest, OnAPlaneALightGoesToTheNearestPlaceOfIt) {
  put(light("key"), "position", Vec3(1.0F, 3.0F, -2.0F));
  rig_.constraints = {{"key", OnPlane{{Vec3(0.0F, 2.5F, 0.0F), Vec3(0.0F, -7.0F, 0.0F)}}}};
  keep_constraints(rig_);
  EXPECT_EQ(value(light("key"), "position"), Vec3(1.0F, 2.5F, -2.0F));
}

TEST_F(ConstraintTest, ALockedAxisIsNotMovedWhereTheOthersLeadToThePlane) {
  Light& key = light("key");
  put(key, "position", Vec3(1.0F, 3.0F, -2.0F));
  key.params.set_locked(key.params.schema()[param(key, "position")].first_dof + 1, true);
  rig_.constraints = {{"key", OnPlane{{Vec3(0.0F), Vec3(1.0F, 1.0F, 0.0F)}}}};
  keep_constraints(rig_);
  EXPECT_EQ(value(key, "position"), Vec3(-3.0F, 3.0F, -2.0F));
  rig_.constraints = {{"key", OnPlane{{Vec3(0.0F), Vec3(0.0F, 1.0F, 0.0F)}}}};  // only the locked axis leads there
  keep_constraints(rig_);
  EXPECT_EQ(value(key, "position"), Vec3(-3.0F, 0.0F, -2.0F));
}

TEST_F(ConstraintTest, AtADistanceALightKeepsItsWayFromThere) {
  put(light("bulb"), "position", Vec3(1.0F, 1.0F, 5.0F));
  rig_.constraints = {{"bulb", AtDistance{2.0F, Vec3(1.0F, 1.0F, 1.0F)}}};
  keep_constraints(rig_);
  EXPECT_EQ(value(light("bulb"), "position"), Vec3(1.0F, 1.0F, 3.0F));
}

TEST_F(ConstraintTest, InTheCentreOfItsSphereALightBacksUp) {
  put(light("key"), "position", Vec3(1.0F));
  put(light("key"), "direction", Vec3(0.0F, -1.0F, 0.0F));
  rig_.constraints = {{"key", AtDistance{2.0F, Vec3(1.0F)}}};
  keep_constraints(rig_);
  EXPECT_EQ(value(light("key"), "position"), Vec3(1.0F, 3.0F, 1.0F));
}

TEST_F(ConstraintTest, OnAPlaneAndAtADistanceALightStandsOnTheCircle) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    shuffle(seed);
    const Vec3 normal = glm::normalize(value(light("rim"), "direction"));
    const Vec3 from = value(light("rim"), "position");
    rig_.constraints = {{"key", AtDistance{2.0F, from}}, {"key", OnPlane{{from + 1.5F * normal, normal}}}};
    ASSERT_FALSE(find_fault(rig_));
    keep_constraints(rig_);
    const Vec3 place = value(light("key"), "position");
    EXPECT_NEAR(glm::distance(place, from), 2.0F, 5.0F * kRounding) << seed;
    EXPECT_NEAR(glm::dot(place - from, normal), 1.5F, 5.0F * kRounding) << seed;
  }
}

TEST_F(ConstraintTest, AMirrorImageIsReflectedAndEqualOtherwise) {
  shuffle(1);
  put(light("key"), "position", Vec3(3.0F, 2.0F, 1.0F));
  put(light("key"), "direction", Vec3(-0.6F, -0.8F, 0.0F));
  rig_.constraints = {{"fill", MirrorOf{"key", {Vec3(1.0F, 0.0F, 0.0F), Vec3(2.0F, 0.0F, 0.0F)}}}};
  keep_constraints(rig_);
  EXPECT_EQ(value(light("fill"), "position"), Vec3(-1.0F, 2.0F, 1.0F));
  EXPECT_EQ(value(light("fill"), "direction"), Vec3(0.6F, -0.8F, 0.0F));
  for (const ParamSpec& spec : light("key").params.schema().specs()) {
    if (spec.role == "position" || spec.role == "direction") continue;
    const int at = *light("key").params.schema().find(spec.name);
    for (int c = 0; c < spec.components(); ++c) {
      EXPECT_EQ(light("fill").params.get(at, c), light("key").params.get(at, c)) << spec.name;
    }
  }
}

TEST_F(ConstraintTest, AMirrorImageMayBeOfATypeThatWasReadAnotherTime) {
  const LightTypes again = load_types();
  light("fill") = *make_light(again, "cinematic", "fill", frame_);
  put(light("key"), "position", Vec3(3.0F, 2.0F, 1.0F));
  rig_.constraints = {{"fill", MirrorOf{"key", {Vec3(1.0F, 0.0F, 0.0F), Vec3(2.0F, 0.0F, 0.0F)}}}};
  keep_constraints(rig_);
  EXPECT_EQ(value(light("fill"), "position"), Vec3(-1.0F, 2.0F, 1.0F));
}

TEST_F(ConstraintTest, ATiedColourIsTheOtherTimesTheFactor) {
  put(light("key"), "color", Vec3(1.0F, 0.5F, 0.25F));
  rig_.constraints = {{"bulb", SameColor{"key", 0.5F}}};
  keep_constraints(rig_);
  EXPECT_EQ(value(light("bulb"), "color"), Vec3(0.5F, 0.25F, 0.125F));
}

TEST_F(ConstraintTest, WhatFollowsIsNoDegreeOfFreedomAndItsLockIsKept) {
  for (Light& each : rig_.lights) each.params.set_param_locked(-1, false);
  rig_.constraints = {{"fill", MirrorOf{"key", {}}}, {"bulb", SameColor{"key"}}};
  keep_constraints(rig_);
  EXPECT_EQ(free_dofs(light("key")), 18);
  EXPECT_EQ(free_dofs(light("fill")), 0);
  EXPECT_EQ(free_dofs(light("bulb")), light("bulb").params.schema().dofs() - 3);
  light("fill").params.set_param_locked(-1, false);
  EXPECT_EQ(free_dofs(light("fill")), 0) << "no lock unties what follows";
  rig_.constraints.clear();
  keep_constraints(rig_);
  EXPECT_EQ(free_dofs(light("fill")), 18);
}

TEST_F(ConstraintTest, TiesReachThroughChains) {
  rig_.constraints = {
      {"rim", MirrorOf{"fill", {}}}, {"fill", SameColor{"key", 0.5F}}, {"bulb", SameColor{"rim", 3.0F}}};
  const Light& key = light("key");
  const std::vector<Tie> colored = tied_to(rig_, 0, param(key, "color"));
  ASSERT_EQ(colored.size(), 4U);
  EXPECT_EQ(colored[1].light, 1U);
  EXPECT_EQ(colored[2].light, 2U);
  EXPECT_EQ(colored[2].factor, 0.5F);
  EXPECT_EQ(colored[3].light, 3U);
  EXPECT_EQ(colored[3].factor, 1.5F);
  EXPECT_EQ(tied_to(rig_, 0, param(key, "position")).size(), 1U);
  EXPECT_EQ(tied_to(rig_, 1, param(key, "position")).size(), 2U);
}

TEST_F(ConstraintTest, ALightIsFreeIfTheOneItFollowsIs) {
  for (Light& each : rig_.lights) each.params.set_param_locked(-1, true);
  rig_.constraints = {{"fill", MirrorOf{"key", {}}}, {"rim", SameColor{"fill"}}};
  keep_constraints(rig_);
  EXPECT_FALSE(may_change(rig_, light("rim")));
  light("key").params.set_locked(0, false);
  EXPECT_TRUE(may_change(rig_, light("fill")));
  EXPECT_TRUE(may_change(rig_, light("rim")));
  EXPECT_FALSE(may_change(rig_, light("bulb")));
}

TEST_F(ConstraintTest, ChainsHoldInWhateverOrderTheyStandAndKeepingTwiceIsKeepingOnce) {
  const std::vector<Constraint> all = {{"bulb", SameColor{"rim", 0.3F}},
                                       {"rim", MirrorOf{"fill", {Vec3(0.1F), Vec3(1.0F, 2.0F, 3.0F)}}},
                                       {"fill", MirrorOf{"key", {Vec3(0.7F), Vec3(-1.0F, 0.3F, 2.0F)}}},
                                       {"key", AtDistance{2.5F, Vec3(0.3F, 0.2F, 0.1F)}},
                                       {"key", OnPlane{{Vec3(0.0F, 1.1F, 0.3F), Vec3(0.2F, 1.0F, 0.1F)}}},
                                       {"bulb", OnPlane{{Vec3(0.4F), Vec3(0.0F, 0.3F, 1.0F)}}}};
  std::vector<std::size_t> order = {0, 1, 2, 3, 4, 5};
  std::mt19937 random(3);
  for (unsigned seed = 0; seed < 200; ++seed) {
    shuffle(seed);
    const LightRig before = rig_;
    rig_.constraints = all;
    ASSERT_FALSE(find_fault(rig_));
    keep_constraints(rig_);
    const std::vector<std::byte> once = bits();
    keep_constraints(rig_);
    EXPECT_EQ(bits(), once) << seed;
    EXPECT_NEAR(value(light("bulb"), "color").x, 0.3F * value(light("key"), "color").x, kRounding);
    std::shuffle(order.begin(), order.end(), random);
    rig_ = before;
    for (const std::size_t i : order) rig_.constraints.push_back(all[i]);
    keep_constraints(rig_);
    EXPECT_EQ(bits(), once) << seed;
  }
}

TEST_F(ConstraintTest, StrangersCirclesAndMadNumbersArePassedOver) {
  shuffle(5);
  put(light("key"), "position", Vec3(std::nanf(""), 0.0F, 1.0F));
  rig_.constraints = {{"ghost", SameColor{"key"}},   {"bulb", SameColor{"ghost"}}, {"fill", SameColor{"rim"}},
                      {"rim", SameColor{"fill"}},    {"key", OnPlane{}},           {"bulb", MirrorOf{"key", {}}},
                      {"rim", AtDistance{-1.0F, {}}}};
  keep_constraints(rig_);  // no endless loop, no crash
  EXPECT_TRUE(std::isnan(value(light("key"), "position").x));
}

TEST_F(ConstraintTest, SaysWhatCannotBeKept) {
  const Plane floor;
  const Constraint mirror{"fill", MirrorOf{"key", floor}};
  const Plane none{Vec3(0.0F), Vec3(0.0F)};
  struct Case {
    std::vector<Constraint> constraints;
    std::size_t index;
    const char* field;
    const char* says;
  };
  const std::vector<Case> cases = {
      {{mirror, {"kee", OnPlane{floor}}}, 1, "light", "did you mean \"key\""},
      {{{"key", SameColor{"fil"}}}, 0, "same_color", "did you mean \"fill\""},
      {{{"key", MirrorOf{"key", floor}}}, 0, "mirror_of", "cannot follow itself"},
      {{mirror, {"key", SameColor{"fill"}}}, 0, "mirror_of", "in a circle"},
      {{mirror, {"fill", MirrorOf{"rim", floor}}}, 1, "mirror_of", "two constraints of this kind"},
      {{mirror, {"fill", SameColor{"rim"}}}, 1, "same_color", "is a mirror image"},
      {{{"fill", OnPlane{floor}}, mirror}, 1, "mirror_of", "is a mirror image"},
      {{{"key", OnPlane{none}}}, 0, "on_plane", "no plane"},
      {{{"fill", MirrorOf{"key", none}}}, 0, "mirror_of", "no plane"},
      {{{"key", AtDistance{0.0F, Vec3(0.0F)}}}, 0, "at_distance", "no distance"},
      {{{"key", SameColor{"rim", -1.0F}}}, 0, "same_color", "no factor"},
      {{{"bulb", MirrorOf{"key", floor}}}, 0, "mirror_of", "no mirror image of one of type cinematic"},
      {{{"key", OnPlane{floor}}, {"key", AtDistance{1.0F, Vec3(0.0F, 1.5F, 0.0F)}}}, 1, "at_distance", "1.5 or more"},
  };
  for (const Case& each : cases) {
    rig_.constraints = each.constraints;
    const auto fault = find_fault(rig_);
    ASSERT_TRUE(fault) << each.says;
    EXPECT_EQ(fault->index, each.index) << each.says;
    EXPECT_EQ(fault->field, each.field) << each.says;
    EXPECT_NE((fault->what + "; " + fault->hint).find(each.says), std::string::npos)
        << fault->what << "; " << fault->hint;
    EXPECT_EQ(error_of(check_constraints(rig_)).kind, ErrorKind::kUsage);
  }
}

TEST_F(ConstraintTest, ALightThatGoesTakesItsConstraintsAlong) {
  rig_.shadow_light = "key";
  rig_.constraints = {{"key", OnPlane{}}, {"fill", MirrorOf{"key", {}}}, {"bulb", SameColor{"rim"}}};
  keep_constraints(rig_);
  const Vec3 place = value(light("fill"), "position");
  const std::vector<Constraint> gone = remove_light(rig_, "key");
  ASSERT_EQ(gone.size(), 2U);
  EXPECT_EQ(to_text(gone[0]), "lights/key on plane 0,0,0 0,1,0");
  EXPECT_EQ(to_text(gone[1]), "lights/fill mirror of lights/key across plane 0,0,0 0,1,0");
  ASSERT_EQ(rig_.constraints.size(), 1U);
  EXPECT_EQ(rig_.lights.size(), 3U);
  EXPECT_EQ(rig_.shadow_light, "");
  EXPECT_EQ(value(light("fill"), "position"), place);
  EXPECT_GT(free_dofs(light("fill")), 0);
}

/// Rig files.
class ConstraintFileTest : public ConstraintTest {
 protected:
  Result<LightRig> parse(const std::string& constraints) const {
    return parse_rig(lights() + constraints, "a.toml", types_, frame_);
  }
  static std::string lights() {  // 6 lines
    return "[[light]]\nname = \"key\"\ntype = \"cinematic\"\n[[light]]\nname = \"fill\"\ntype = \"cinematic\"\n";
  }
};

TEST_F(ConstraintFileTest, AreReadAndHoldInWhatIsRead) {
  LUM_ASSERT_OK(const LightRig rig, parse(R"(
[[constraint]]
light = "key"
on_plane = { point = [0, 2.5, 0], normal = [0, -1, 0] }

[[constraint]]
light = "fill"
mirror_of = { light = "key", point = [1, 0, 0], normal = [1, 0, 0] }
)"));
  ASSERT_EQ(rig.constraints.size(), 2U);
  EXPECT_EQ(value(*rig.find("key"), "position").y, 2.5F);
  EXPECT_EQ(value(*rig.find("fill"), "position").y, 2.5F);
  EXPECT_EQ(free_dofs(*rig.find("fill")), 0);
}

TEST_F(ConstraintFileTest, AreWrittenAndReadBackToTheSameBits) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    shuffle(seed);
    const Plane plane{value(light("bulb"), "position"), value(light("bulb"), "color")};
    const Vec3 from = value(light("rim"), "color");
    rig_.constraints = {{"key", OnPlane{plane}},
                        {"key", AtDistance{glm::length(plane.point - from) + 0.1F, from}},
                        {"fill", MirrorOf{"key", plane}},
                        {"bulb", SameColor{"rim", 0.1F}},
                        {"rim", Between{"barn.y", 0.1F, 0.1F + std::abs(from.x)}}};
    ASSERT_FALSE(find_fault(rig_));
    keep_constraints(rig_);
    light("fill").params.set_locked(3, true);
    LUM_ASSERT_OK(const LightRig read, parse_rig(rig_to_toml(rig_), "a.toml", types_, frame_));
    const std::vector<std::byte> written = bits();
    EXPECT_EQ(rig_to_toml(read), rig_to_toml(rig_));
    rig_ = read;
    EXPECT_EQ(bits(), written) << seed;
  }
}

TEST_F(ConstraintFileTest, ReportMistakesAtTheirPlace) {
  const std::string head = "[[constraint]]\nlight = \"key\"\n";  // lines 7 and 8
  const std::vector<std::array<std::string, 3>> mistakes = {
      {"[[constrain]]\n", "a.toml:7:3", "did you mean \"constraint\""},
      {"[[constraint]]\nlight = \"kee\"\nsame_color = { light = \"fill\" }\n", "a.toml:8:9", "did you mean \"key\""},
      {head, "a.toml:8:9", "nothing is said"},
      {head + "on_plan = { }\n", "a.toml:9:1", "did you mean \"on_plane\""},
      {head + "on_plane = 2\n", "a.toml:9:12", "a table is wanted"},
      {head + "on_plane = { point = [0, 0], normal = [0, 1, 0] }\n", "a.toml:9:22", "give three numbers"},
      {head + "on_plane = { point = [0, 0, 0], normal = [0, 0, 0] }\n", "a.toml:9:12", "no plane"},
      {head + "on_plane = { point = [0, 0, 0], norml = [0, 1, 0] }\n", "a.toml:9:33", "did you mean \"normal\""},
      {head + "at_distance = { from = [0, 0, 0] }\n", "a.toml:9:15", "\"distance\" is missing"},
      {head + "mirror_of = { light = \"fil\", point = [0, 0, 0], normal = [1, 0, 0] }\n", "a.toml:9:13",
       "did you mean \"fill\""},
      {head + "between = { param = \"barn\", low = 1, high = 0.5 }\n", "a.toml:9:11", "no range"},
      {head + "between = { low = 0, high = 0.5 }\n", "a.toml:9:11", "\"param\" is missing"},
      {head + "same_color = { light = \"fill\", factor = -1 }\n", "a.toml:9:14", "no factor"},
      {head + "same_color = { light = \"fill\" }\nat_distance = { distance = 1, from = [0, 0, 0] }\n", "a.toml:9:14",
       "there is at_distance already"},
  };
  for (const auto& [toml, where, says] : mistakes) {
    const Error error = error_of(parse(toml));
    EXPECT_EQ(error.kind, ErrorKind::kBadContent) << toml;
    EXPECT_EQ(error.where, where) << error.message();
    EXPECT_NE(error.message().find(says), std::string::npos) << error.message();
  }
}

}  // namespace
}  // namespace luminist
