#include "app/light_rows.h"

#include <gtest/gtest.h>

#include "support/fixtures.h"

namespace luminist {
namespace {

class LightRows : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    rig_ = empty_rig(types_, SceneFrame{});
    for (const auto& [name, group] : {std::pair("a", "warm"), {"b", ""}, {"c", "warm"}, {"d", "cold"}}) {
      rig_->lights.push_back(make_light(types_, "point", name, SceneFrame{}).value());
      rig_->lights.back().group = group;
    }
  }
  /// "[warm]" for a heading, the name for a light.
  std::vector<std::string> rows(const std::set<std::string>& folded) const {
    std::vector<std::string> words;
    for (const LightRow& row : light_rows(*rig_, folded)) {
      words.push_back(row.light != nullptr ? row.light->name : "[" + row.group + "]");
    }
    return words;
  }
  LightTypes types_;
  std::optional<LightRig> rig_;
  std::vector<std::string> objects_{"jug", "table", "wall"};
};

TEST_F(LightRows, AGroupStandsWhereItsFirstLightDoes) {
  EXPECT_EQ(rows({}), (std::vector<std::string>{"[warm]", "a", "c", "b", "[cold]", "d"}));
  EXPECT_EQ(rows({"warm"}), (std::vector<std::string>{"[warm]", "b", "[cold]", "d"}));
}

TEST_F(LightRows, ANewGroupTakesNoNameThatIsThere) {
  EXPECT_EQ(unused_group(*rig_), "group");
  rig_->lights[1].group = "group";
  EXPECT_EQ(unused_group(*rig_), "group-2");
  EXPECT_EQ(group_names(*rig_), (std::vector<std::string>{"warm", "group", "cold"}));
}

TEST_F(LightRows, AClickTakesAnObjectOutAndAnotherTakesItInAgain) {
  Light& light = rig_->lights[0];
  light.objects = toggled_link(light, objects_, "table");
  EXPECT_EQ(light.objects, (std::vector<std::string>{"jug", "wall"}));
  EXPECT_EQ(toggled_link(light, objects_, "table"), std::vector<std::string>{}) << "all of them is everything";
}

TEST_F(LightRows, AnOnlyObjectStays) {
  Light& light = rig_->lights[0];
  light.objects = {"ju*"};
  EXPECT_EQ(toggled_link(light, objects_, "jug"), std::vector<std::string>{"jug"});
  EXPECT_EQ(link_words(light), "ju*");
}

}  // namespace
}  // namespace luminist
