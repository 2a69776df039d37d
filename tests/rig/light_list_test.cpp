#include "rig/light_list.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

/// A key, its mirror image on the other side, and a rim that has the key's colour.
class RigLightList : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    rig_ = empty_rig(types_, SceneFrame{});
    for (const char* name : {"key", "mirror", "rim"}) {
      rig_->lights.push_back(make_light(types_, "cinematic", name, SceneFrame{}).value());
    }
    rig_->constraints = {{"mirror", MirrorOf{"key", {Vec3(0.0F), Vec3(1.0F, 0.0F, 0.0F)}}},
                         {"rim", SameColor{"key", 0.5F}},
                         {"key", AtDistance{2.0F, Vec3(0.0F)}}};
    rig_->shadow_light = "key";
    const auto color = rig_->lights[0].params.schema().by_role("color");
    set_key(*rig_, {"key", *color}, 5.0, KeyInterpolation::kLinear);
  }
  LightTypes types_;
  std::optional<LightRig> rig_;
};

TEST_F(RigLightList, ANewNameIsKnownToAllThatNamedTheOldOne) {
  LUM_EXPECT_OK(rename_light(*rig_, "key", "sun"));
  EXPECT_EQ(rig_->lights[0].name, "sun");
  EXPECT_EQ(rig_->shadow_light, "sun");
  EXPECT_EQ(*leader(rig_->constraints[0]), "sun");
  EXPECT_EQ(*leader(rig_->constraints[1]), "sun");
  EXPECT_EQ(rig_->constraints[2].light, "sun");
  EXPECT_EQ(rig_->keys[0].light, "sun");
  EXPECT_FALSE(find_fault(*rig_));
}

TEST_F(RigLightList, ATakenNameABadOneAndAGroupAreErrors) {
  const std::string before = rig_to_toml(*rig_);
  EXPECT_EQ(error_of(rename_light(*rig_, "key", "rim")).field, "name");
  EXPECT_EQ(error_of(rename_light(*rig_, "key", "a/b")).field, "name");
  EXPECT_NE(error_of(rename_light(*rig_, "kye", "sun")).hint.find("key"), std::string::npos);
  LUM_EXPECT_OK(group_lights(*rig_, {"key"}, "warm"));
  EXPECT_EQ(error_of(rename_light(*rig_, "group:warm", "sun")).kind, ErrorKind::kUsage);
  LUM_EXPECT_OK(group_lights(*rig_, {"group:warm"}, ""));
  EXPECT_EQ(rig_to_toml(*rig_), before);
}

TEST_F(RigLightList, ACopyHasAllThatTheLightHasAndStandsBehindIt) {
  rig_->lights[0].group = "warm";
  LUM_ASSERT_OK(const std::string copy, duplicate_light(*rig_, "key", ""));
  EXPECT_EQ(copy, "key-2");
  ASSERT_EQ(rig_->lights.size(), 4U);
  EXPECT_EQ(rig_->lights[1].name, "key-2");
  EXPECT_EQ(rig_->lights[1].group, "warm");
  ASSERT_EQ(rig_->keys.size(), 2U);
  EXPECT_EQ(rig_->keys[1].light, "key-2");
  ASSERT_EQ(rig_->constraints.size(), 4U);
  EXPECT_EQ(to_text(rig_->constraints[3]), "lights/key-2 at distance 2 from 0,0,0");
  EXPECT_FALSE(find_fault(*rig_));
  EXPECT_EQ(error_of(duplicate_light(*rig_, "key", "rim")).field, "name");
}

TEST_F(RigLightList, GroupsAreMadeRenamedAndDissolved) {
  LUM_EXPECT_OK(group_lights(*rig_, {"mirror", "rim"}, "edges"));
  EXPECT_EQ(rig_->lights[0].group, "");
  EXPECT_EQ(rig_->lights[2].group, "edges");
  LUM_EXPECT_OK(group_lights(*rig_, {"group:edges", "key"}, "all"));
  for (const Light& light : rig_->lights) EXPECT_EQ(light.group, "all");
  LUM_EXPECT_OK(group_lights(*rig_, {"group:all"}, ""));
  for (const Light& light : rig_->lights) EXPECT_EQ(light.group, "");
}

TEST_F(RigLightList, AGroupIsMadeOfAllTheLightsOrOfNone) {
  EXPECT_EQ(error_of(group_lights(*rig_, {"key", "nobody"}, "warm")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(group_lights(*rig_, {"key"}, "a:b")).field, "group");
  EXPECT_EQ(rig_->lights[0].group, "");
}

}  // namespace
}  // namespace luminist
