#include "render/param_state.h"

#include <gtest/gtest.h>

#include <set>

#include "support/fixtures.h"

namespace luminist {
namespace {

/// A rig of three lights, two in a group, and the toon style.
class ParamStateTest : public ::testing::Test {
 protected:
  ParamStateTest() : types_(load_types()), state_(initial_state(types_, load_toon(), frame_)) {
    add("key", "cinematic", "");
    add("fill-left", "point", "fill");
    add("fill-right", "point", "fill");
  }
  static LightTypes load_types() {
    auto types = LightTypes::load(AssetRoots::standard());
    EXPECT_TRUE(types) << (types ? "" : types.error().message());
    return *types;
  }
  static Style load_toon() {
    auto style = load_style(AssetRoots::standard(), "toon");
    EXPECT_TRUE(style) << (style ? "" : style.error().message());
    return *style;
  }
  void add(const std::string& name, const std::string& type, const std::string& group) {
    Light light = *make_light(types_, type, name, frame_);
    light.group = group;
    state_.rig.lights.push_back(std::move(light));
  }
  /// Locks everything, then unlocks a pattern; the names of what is free.
  std::vector<std::string> unlocked_by(const std::string& pattern) {
    LUM_EXPECT_OK(set_locked(state_, "*", true));
    const auto count = set_locked(state_, pattern, false);
    EXPECT_TRUE(count) << (count ? "" : count.error().message());
    const std::vector<std::string> names = free_names();
    if (count) {
      EXPECT_EQ(static_cast<std::size_t>(*count), names.size());
    }
    return names;
  }
  std::vector<std::string> free_names() const {
    const std::vector<const ParamBlock*> blocks = std::as_const(state_).blocks();
    return dof_names(state_, UnitMap::create(blocks, frame_));
  }

  SceneFrame frame_;
  LightTypes types_;
  ParamState state_;
};

TEST_F(ParamStateTest, ListsAmbientThenLightsThenStyle) {
  EXPECT_EQ(state_.block_paths(),
            (std::vector<std::string>{"ambient", "lights/key", "lights/fill-left", "lights/fill-right", "style"}));
  const std::vector<ParamBlock*> blocks = state_.blocks();
  ASSERT_EQ(blocks.size(), 5U);
  EXPECT_EQ(blocks[0], &state_.rig.ambient);
  EXPECT_EQ(blocks[static_cast<std::size_t>(light_block(1))], &state_.rig.lights[1].params);
  EXPECT_EQ(blocks[4], &state_.style);
}

TEST_F(ParamStateTest, MaterialsComeLastAndAreUnlockedByNameOnly) {
  LUM_ASSERT_OK(const auto schema, load_material_schema(AssetRoots::standard()));
  Material jug;
  jug.name = "jug";
  state_.materials = material_params({jug, Material{}}, *schema);
  EXPECT_EQ(state_.block_paths().back(), "materials/material");
  EXPECT_EQ(state_.blocks().back(), &state_.materials[1].params);
  EXPECT_EQ(material_of_block(state_, 4), -1) << "the style";
  EXPECT_EQ(material_of_block(state_, 6), 1);
  EXPECT_EQ(material_of_block(state_, 7), -1);
  for (const std::string& name : unlocked_by("*")) EXPECT_FALSE(name.starts_with("materials/")) << name;
  EXPECT_EQ(unlocked_by("materials/jug"),
            (std::vector<std::string>{"materials/jug/tint.r", "materials/jug/tint.g", "materials/jug/tint.b",
                                      "materials/jug/specular", "materials/jug/roughness"}));
  EXPECT_EQ(unlocked_by("materials/*/roughness").size(), 2U) << "\"*\" locks materials, too";
  LUM_EXPECT_OK(set_path(state_, "materials/jug/roughness=0.25"));
  EXPECT_EQ(state_.materials[0].params.scalar(*schema->find("roughness")), 0.25F);
  const Error error = error_of(set_path(state_, "materials/cup/roughness=0.25"));
  EXPECT_NE(error.what.find("no material \"cup\""), std::string::npos) << error.what;
}

TEST_F(ParamStateTest, StartsWithoutLightsAndLockedAsTheSchemasSay) {
  const ParamState start = initial_state(types_, load_toon(), frame_);
  EXPECT_TRUE(start.rig.lights.empty());
  for (const ParamBlock* block : start.blocks()) {
    for (const ParamSpec& spec : block->schema().specs()) {
      for (int c = 0; c < spec.dofs(); ++c) EXPECT_EQ(block->locked(spec.first_dof + c), !spec.solve) << spec.name;
    }
  }
}

TEST_F(ParamStateTest, SetsAParameterByItsPath) {
  LUM_EXPECT_OK(set_path(state_, "lights/key/barn=0.5,0.25,0.125"));
  const ParamBlock& key = state_.rig.lights[0].params;
  EXPECT_EQ(key.vec3(*key.schema().find("barn")), Vec3(0.5F, 0.25F, 0.125F));
  LUM_EXPECT_OK(set_path(state_, "ambient/color=#000000"));
  EXPECT_EQ(state_.rig.ambient.vec3(0), Vec3(0.0F));
  LUM_EXPECT_OK(set_path(state_, "style/threshold=0.75"));
  EXPECT_EQ(state_.style.scalar(*state_.style.schema().find("threshold")), 0.75F);
}

TEST_F(ParamStateTest, SaysWhatIsWrongWithAnAssignment) {
  const std::array<std::array<const char*, 3>, 8> mistakes = {{
      {"lights/key/barn", "lights/key/barn", "write PATH=VALUE"},
      {"lights/key/bran=1,1,1", "lights/key/bran", "did you mean \"lights/key/barn\""},
      {"lights/kez/barn=1,1,1", "lights/kez/barn", "did you mean \"lights/key/barn\""},
      {"style/treshold=1", "style/treshold", "did you mean \"style/threshold\""},
      {"barn=1,1,1", "barn", "write a path"},
      {"=1", "", "write a path"},
      {"lights/key/barn=1,1", "lights/key/barn", "give 3 numbers"},
      {"style/threshold=", "style/threshold", "give a number"},
  }};
  for (const auto& [assignment, field, says] : mistakes) {
    const Error error = error_of(set_path(state_, assignment));
    EXPECT_EQ(error.kind, ErrorKind::kUsage) << assignment;
    EXPECT_EQ(error.field, field);
    EXPECT_NE(error.hint.find(says), std::string::npos) << error.message();
  }
}

TEST_F(ParamStateTest, UnlocksOneParameterOrOneDegreeOfFreedom) {
  EXPECT_EQ(unlocked_by("lights/key/color"),
            (std::vector<std::string>{"lights/key/color.r", "lights/key/color.g", "lights/key/color.b"}));
  EXPECT_EQ(unlocked_by("lights/key/position.y"), (std::vector<std::string>{"lights/key/position.y"}));
  EXPECT_EQ(unlocked_by("lights/key/direction"),
            (std::vector<std::string>{"lights/key/direction.u", "lights/key/direction.v"}));
  EXPECT_EQ(unlocked_by("style/threshold"), (std::vector<std::string>{"style/threshold"}));
}

TEST_F(ParamStateTest, LetsAStarStandForAnyRunOfCharacters) {
  EXPECT_EQ(unlocked_by("lights/*/position.x"),
            (std::vector<std::string>{"lights/key/position.x", "lights/fill-left/position.x",
                                      "lights/fill-right/position.x"}));
  EXPECT_EQ(unlocked_by("lights/fill-*/color").size(), 6U);
  EXPECT_EQ(unlocked_by("*/color.r").size(), 4U);  // ambient and three lights
  EXPECT_EQ(unlocked_by("l*t/p*.z").size(), 2U);   // the positions of fill-left and fill-right
  EXPECT_EQ(unlocked_by("style/*").size(), static_cast<std::size_t>(state_.style.schema().dofs()));
  std::size_t all = 0;
  for (const ParamBlock* block : state_.blocks()) all += static_cast<std::size_t>(block->schema().dofs());
  EXPECT_EQ(unlocked_by("*").size(), all);
}

TEST_F(ParamStateTest, UnlocksTheLightsOfAGroup) {
  EXPECT_EQ(unlocked_by("group:fill/color.g"),
            (std::vector<std::string>{"lights/fill-left/color.g", "lights/fill-right/color.g"}));
  const std::vector<std::string> names = unlocked_by("group:f*/*");
  EXPECT_FALSE(names.empty());
  for (const std::string& name : names) EXPECT_EQ(name.rfind("lights/fill-", 0), 0U) << name;
}

TEST_F(ParamStateTest, ThePathOfABlockAloneIsAllOfIt) {
  EXPECT_EQ(unlocked_by("lights/key").size(), 18U);
  EXPECT_EQ(unlocked_by("group:fill"), unlocked_by("group:fill/*"));
  EXPECT_EQ(unlocked_by("style"), unlocked_by("style/*"));
  EXPECT_EQ(unlocked_by("ambient").size(), 3U);
}

TEST_F(ParamStateTest, WhatFollowsAnotherLightIsNotSetAndStaysNoDegreeOfFreedom) {
  state_.rig.constraints = {{"fill-right", SameColor{"key"}}};
  keep_constraints(state_.rig);
  const Error error = error_of(set_path(state_, "lights/fill-right/color=1,1,1"));
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_NE(error.message().find("follows another light"), std::string::npos) << error.message();
  LUM_EXPECT_OK(set_path(state_, "lights/fill-right/position=1,1,1"));
  LUM_EXPECT_OK(set_locked(state_, "*", true));
  LUM_EXPECT_OK(set_locked(state_, "lights/*/color.r", false));
  EXPECT_EQ(free_names(), (std::vector<std::string>{"lights/key/color.r", "lights/fill-left/color.r"}));
}

TEST_F(ParamStateTest, LocksAgain) {
  LUM_EXPECT_OK(set_locked(state_, "*", false));
  LUM_ASSERT_OK(const int count, set_locked(state_, "lights/key/barn.z", true));
  EXPECT_EQ(count, 1);
  const std::vector<std::string> names = free_names();
  EXPECT_EQ(std::count(names.begin(), names.end(), "lights/key/barn.z"), 0);
  EXPECT_EQ(std::count(names.begin(), names.end(), "lights/key/barn.y"), 1);
}

TEST_F(ParamStateTest, SaysWhyAPatternMatchesNothing) {
  const std::array<std::array<const char*, 2>, 5> mistakes = {{
      {"lights/key/colr", "did you mean \"lights/key/color\""},
      {"lights/key/position.w", "did you mean \"lights/key/position"},
      {"group:rim/color", "write a path"},
      {"key", "write a path"},
      {"", "write a path"},
  }};
  for (const auto& [pattern, says] : mistakes) {
    const Error error = error_of(set_locked(state_, pattern, false));
    EXPECT_EQ(error.kind, ErrorKind::kUsage) << pattern;
    EXPECT_NE(error.hint.find(says), std::string::npos) << error.message();
  }
  const Error quality = error_of(set_locked(state_, "lights/key/shadow_softness", false));
  EXPECT_NE(quality.what.find("has no degree of freedom"), std::string::npos) << quality.message();
}

TEST_F(ParamStateTest, NamesEveryDegreeOfFreedomDifferently) {
  const std::vector<std::string> names = unlocked_by("*");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

}  // namespace
}  // namespace luminist
