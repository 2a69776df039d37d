#include "rig/light_links.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

class LightLinks : public testing::Test {
 protected:
  void SetUp() override { LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard())); }

  Light& add(LightRig& rig, const std::string& name, const std::string& group, std::vector<std::string> objects) {
    Light light = make_light(types_, "point", name, SceneFrame{}).value();
    light.group = group;
    light.objects = std::move(objects);
    return rig.lights.emplace_back(std::move(light));
  }
  [[nodiscard]] LightRig rig() const { return empty_rig(types_, SceneFrame{}); }

  LightTypes types_;
  std::vector<std::string> objects_{"head", "wing_left", "wing_right", "ground"};
};

TEST_F(LightLinks, ALightWithoutPatternsLightsEverything) {
  LightRig rig = this->rig();
  const Light& light = add(rig, "sun", "", {});
  EXPECT_TRUE(lights_object(light, "head"));
  EXPECT_EQ(key_light(rig, "head"), 0);
}

TEST_F(LightLinks, ALightWithPatternsLightsWhatOneOfThemMatches) {
  LightRig rig = this->rig();
  const Light& light = add(rig, "rim", "", {"wing_*", "head"});
  EXPECT_TRUE(lights_object(light, "wing_left"));
  EXPECT_TRUE(lights_object(light, "head"));
  EXPECT_FALSE(lights_object(light, "ground"));
  EXPECT_FALSE(lights_object(light, "headless"));
  EXPECT_EQ(key_light(rig, "ground"), -1);
}

TEST_F(LightLinks, TheKeyIsOfTheKeyGroupThenLinkedByNameThenFirst) {
  LightRig rig = this->rig();
  add(rig, "fill", "fill", {"ground", "head"});
  add(rig, "second fill", "fill", {});
  EXPECT_EQ(key_light(rig, "head"), 0) << "linked by name before one that lights everything";
  EXPECT_EQ(key_light(rig, "wing_left"), 1);
  add(rig, "sun", "key", {});
  EXPECT_EQ(key_light(rig, "head"), 2) << "the group key before others";
  add(rig, "hero", "key", {"head"});
  add(rig, "late", "key", {"head"});
  EXPECT_EQ(key_light(rig, "head"), 3) << "among equals the first";
  EXPECT_EQ(key_light(rig, "wing_left"), 2);
}

TEST_F(LightLinks, MutingALightMakesNoOtherTheKey) {
  LightRig rig = this->rig();
  add(rig, "hero", "key", {}).muted = true;
  add(rig, "fill", "fill", {});
  EXPECT_EQ(key_light(rig, "head"), 0);
}

TEST_F(LightLinks, APatternThatMatchesNothingIsAnErrorWithTheNearestName) {
  LightRig rig = this->rig();
  add(rig, "rim", "", {"wing_*", "haed"});
  const auto checked = check_links(rig, objects_, "rig.toml");
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().where, "rig.toml");
  EXPECT_NE(checked.error().message().find("\"rim\" is linked to \"haed\""), std::string::npos);
  EXPECT_NE(checked.error().hint.find("head"), std::string::npos);
}

TEST_F(LightLinks, WordsLinkALightOrAGroupAndStarUnlinks) {
  LightRig rig = this->rig();
  add(rig, "sun", "key", {});
  add(rig, "left", "rim", {});
  add(rig, "right", "rim", {});
  LUM_EXPECT_OK(link_lights(rig, {"sun=head,ground", "group:rim=wing_*"}, objects_));
  EXPECT_EQ(rig.lights[0].objects, (std::vector<std::string>{"head", "ground"}));
  EXPECT_EQ(rig.lights[1].objects, (std::vector<std::string>{"wing_*"}));
  EXPECT_EQ(rig.lights[2].objects, (std::vector<std::string>{"wing_*"}));
  LUM_EXPECT_OK(link_lights(rig, {"sun=*"}, objects_));
  EXPECT_TRUE(rig.lights[0].objects.empty());
}

TEST_F(LightLinks, WordsThatAreWrongChangeNothing) {
  LightRig rig = this->rig();
  add(rig, "sun", "key", {});
  for (const char* words : {"sun", "sun=", "=head", "son=head", "group:kay=head", "sun=hed"}) {
    const auto linked = link_lights(rig, {"sun=head", words}, objects_);
    ASSERT_FALSE(linked) << words;
    EXPECT_EQ(linked.error().kind, ErrorKind::kUsage);
    EXPECT_FALSE(linked.error().hint.empty()) << words;
    EXPECT_TRUE(rig.lights[0].objects.empty()) << words;
  }
}

TEST_F(LightLinks, RigsThatAreLinkedOtherwiseHaveOtherSignatures) {
  LightRig one = this->rig();
  add(one, "a", "", {"x"});
  add(one, "b", "", {});
  LightRig other = this->rig();
  add(other, "a", "", {});
  add(other, "b", "", {"x"});
  EXPECT_NE(link_signature(one), link_signature(other));
  other = one;
  EXPECT_EQ(link_signature(one), link_signature(other));
  other.lights[0].objects = {"x", ""};
  EXPECT_NE(link_signature(one), link_signature(other));
  other = one;
  other.lights[1].group = "key";
  EXPECT_NE(link_signature(one), link_signature(other));
}

}  // namespace
}  // namespace luminist
