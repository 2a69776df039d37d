// Lights that are linked to objects, in every style, in pictures and in a solver's batches.
#include "rig/light_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "raster/link_table.h"
#include "raster/renderer_fixture.h"

namespace luminist {
namespace {

constexpr std::uint32_t kBall = 1;
constexpr std::uint32_t kFloor = 2;

class LinkedLights : public RendererTest {
 protected:
  void link(const std::vector<std::string>& words) {
    const std::array<std::string, 2> objects{"ball", "floor"};
    LUM_EXPECT_OK(link_lights(state_->rig, words, objects));
  }
  Image picture(const RenderOptions& options = {}) {
    auto picture = renderer_->render(*state_, options);
    EXPECT_TRUE(picture) << picture.error().message();
    return picture ? std::move(*picture) : Image();
  }
  std::vector<Vec3> samples() { return evaluate({&*state_, Candidate::kAllLights}, all_pixels()); }
  [[nodiscard]] std::uint32_t object(std::size_t pixel) const { return renderer_->surface().object[pixel]; }
  /// Whether all pixels around show the same object, so that antialiasing mixes nothing into it.
  [[nodiscard]] bool is_inside(std::size_t pixel) const {
    const auto x = static_cast<int>(pixel % kWidth);
    const auto y = static_cast<int>(pixel / kWidth);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int u = std::clamp(x + dx, 0, kWidth - 1);
        const int v = std::clamp(y + dy, 0, kHeight - 1);
        if (object(renderer_->surface().index(u, v)) != object(pixel)) return false;
      }
    }
    return true;
  }
};

TEST_F(LinkedLights, LightInEveryStyleOnlyWhatTheyAreLinkedTo) {
  for (const std::string& name : style_names(AssetRoots::standard())) {
    LUM_ASSERT_OK(const Style style, load_style(AssetRoots::standard(), name));
    // Strokes need charts, and read lights as the others do; another engine has a test of its own.
    if (!style.shades() || style.strokes || style.engine != StyleEngine::kRaster) continue;
    use_style(style);
    const std::vector<Vec3> all = samples();
    const Image all_picture = picture();
    state_->rig.lights[0].muted = true;
    const std::vector<Vec3> without = samples();
    const Image picture_without = picture();
    state_->rig.lights[0].muted = false;
    link({"key=ball"});
    const std::vector<Vec3> linked = samples();
    const Image linked_picture = picture();
    std::array<int, 3> changed{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      // A light that adds black costs no bit: the sum with it and without it is the same.
      ASSERT_EQ(linked[i], object(i) == kBall ? all[i] : without[i]) << name << " pixel " << i;
      if (is_inside(i)) {
        ASSERT_EQ(linked_picture.rgb(i), (object(i) == kBall ? all_picture : picture_without).rgb(i)) << name;
      }
      changed[object(i)] += all[i] != without[i] ? 1 : 0;
    }
    EXPECT_GT(changed[kBall], 100) << name;
    EXPECT_GT(changed[kFloor], 100) << name;
  }
}

TEST_F(LinkedLights, TermsOfSingleLightsAreLinkedToo) {
  use_style("cinematic");
  link({"fill=floor"});
  const std::vector<Vec3> term = evaluate({&*state_, 1}, all_pixels());
  int lit = 0;
  for (std::size_t i = 0; i < term.size(); ++i) {
    if (object(i) == kBall) {
      ASSERT_EQ(term[i], Vec3(0.0F));
    }
    lit += object(i) == kFloor && term[i] != Vec3(0.0F) ? 1 : 0;
  }
  EXPECT_GT(lit, 100);
}

TEST_F(LinkedLights, WhatIsKeptOfLightsThatStandStillFollowsTheirLinks) {
  use_style("cinematic");
  const std::array<int, 1> moving{0};
  const Image before = picture({.moving = moving});
  link({"fill=floor"});
  const Image kept = picture({.moving = moving});
  EXPECT_NE(before.data, kept.data);
  const Image whole = picture();
  for (std::size_t i = 0; i < whole.data.size(); ++i) ASSERT_NEAR(kept.data[i], whole.data[i], 1e-6F);  // sums' order
}

TEST_F(LinkedLights, InToonEachObjectShowsTheBandsOfItsOwnKey) {
  use_style("toon");
  const std::vector<Vec3> key = evaluate({&*state_, 0}, all_pixels());
  const std::vector<Vec3> fill = evaluate({&*state_, 1}, all_pixels());
  LUM_EXPECT_OK(set_path(*state_, "ambient/color=0,0,0"));
  LUM_EXPECT_OK(set_path(*state_, "style/combine=key"));
  state_->rig.lights[0].group = "key";
  state_->rig.lights[1].group = "key";
  link({"key=ball", "fill=floor"});
  const std::vector<Vec3> keyed = samples();
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (object(i) != 0) {
      ASSERT_EQ(keyed[i], object(i) == kBall ? key[i] : fill[i]);
    }
  }
  LUM_EXPECT_OK(set_path(*state_, "lights/fill/position=-1,6,2"));
  LUM_EXPECT_OK(set_path(*state_, "lights/fill/color=3,0.5,2"));
  const std::vector<Vec3> turned = samples();
  int moved = 0;
  for (std::size_t i = 0; i < key.size(); ++i) {
    if (object(i) == kBall) {
      ASSERT_EQ(turned[i], keyed[i]) << "the other object's key does not touch it";
    }
    moved += object(i) == kFloor && turned[i] != keyed[i] ? 1 : 0;
  }
  EXPECT_GT(moved, 100);
}

TEST_F(LinkedLights, InToonLightsBesideTheKeyAddNoBandsEvenWhereItDoesNotReach) {
  use_style("toon");
  LUM_EXPECT_OK(set_path(*state_, "style/combine=key"));
  const std::vector<Vec3> keyed = samples();
  const std::vector<Vec3> term = evaluate({&*state_, 1}, all_pixels());
  EXPECT_TRUE(std::ranges::all_of(term, [](const Vec3& color) { return color == Vec3(0.0F); }));
  EXPECT_EQ(style_->combination(state_->style), LightCombination::kSum);
  state_->rig.lights[1].muted = true;
  EXPECT_EQ(samples(), keyed);
}

TEST(LinkTable, HasNoBitsForARigWithoutLinks) {
  LUM_ASSERT_OK(const LightTypes types, LightTypes::load(AssetRoots::standard()));
  LightRig rig = empty_rig(types, SceneFrame{});
  for (const char* name : {"a", "b"}) rig.lights.push_back(make_light(types, "point", name, SceneFrame{}).value());
  rig.lights[1].group = "key";
  LinkTable table({"", "ball"});
  const auto entries = table.entries(rig);
  EXPECT_EQ(entries[0], LinkTable::kEverything);
  EXPECT_EQ(entries[1], LinkTable::kKeyOfAll);
  EXPECT_TRUE(table.words().empty());
}

TEST(LinkTable, HasABitForEveryObjectOfManyAndOneSetForEqualRigs) {
  LUM_ASSERT_OK(const LightTypes types, LightTypes::load(AssetRoots::standard()));
  LightRig rig = empty_rig(types, SceneFrame{});
  for (const char* name : {"a", "b"}) rig.lights.push_back(make_light(types, "point", name, SceneFrame{}).value());
  std::vector<std::string> names{""};
  for (int i = 1; i <= 70; ++i) names.push_back("object " + std::to_string(i));
  rig.lights[1].objects = {"object *5"};
  LinkTable table(names);
  const std::vector<std::uint32_t> entries(table.entries(rig).begin(), table.entries(rig).end());
  EXPECT_EQ(table.words().size(), 2 * 2 * table.row_words());
  const auto bit = [&](std::size_t row, std::size_t object) {
    return table.words()[row + object / 32] >> object % 32 & 1U;
  };
  for (std::size_t i = 1; i <= 70; ++i) {
    const bool linked = i % 10 == 5;
    EXPECT_EQ(bit(entries[0], i), 1U);
    EXPECT_EQ(bit(entries[1], i), linked ? 1U : 0U) << i;
    EXPECT_EQ(bit(entries[0] + table.row_words(), i), linked ? 0U : 1U) << i;
    EXPECT_EQ(bit(entries[1] + table.row_words(), i), linked ? 1U : 0U) << i;
  }
}

}  // namespace
}  // namespace luminist
