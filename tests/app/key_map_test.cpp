#include "app/key_map.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace luminist {
namespace {

constexpr int kZ = 90;
constexpr int kY = 89;
constexpr int kShift = 1;
constexpr int kCtrl = 2;

TEST(KeyMap, UndoAndRedoAreWhereEachProgramHasThem) {
  for (const KeyMap& map : key_maps()) EXPECT_EQ(map.find(kZ, kCtrl), Deed::kUndo) << map.name;
  EXPECT_EQ(key_maps()[0].find(kZ, kCtrl | kShift), Deed::kRedo);
  EXPECT_EQ(key_maps()[2].find(kY, kCtrl), Deed::kRedo);
  EXPECT_EQ(key_maps()[2].find(kZ, kCtrl | kShift), Deed::kNone);
}

TEST(KeyMap, ModifiersMustFit) {
  EXPECT_EQ(key_maps()[0].find(kZ, 0), Deed::kNone);
}

TEST(KeyMap, EveryMapReachesTheSameDeeds) {
  std::map<std::string, std::set<Deed>> deeds;
  for (const KeyMap& map : key_maps()) {
    for (const KeyBinding& binding : map.bindings) deeds[map.name].insert(map.find(binding.key, binding.mods));
  }
  EXPECT_EQ(deeds["Krita"], deeds["Photoshop"]);
  EXPECT_EQ(deeds["Krita"], deeds["GIMP"]);
}

TEST(KeyMap, KeysHaveNamesThatCanBeRead) {
  EXPECT_EQ(key_maps()[0].key_of(Deed::kRedo), "Ctrl+Shift+Z");
  EXPECT_EQ(key_maps()[0].key_of(Deed::kKeys), "?");
  for (const KeyMap& map : key_maps()) {
    for (const KeyBinding& binding : map.bindings) {
      const std::string name = key_name(binding.key, binding.mods);
      EXPECT_TRUE(name == "?" || name.find('?') == std::string::npos) << binding.key;
      EXPECT_NE(std::string(name_of(binding.deed)), "");
    }
  }
}

}  // namespace
}  // namespace luminist
