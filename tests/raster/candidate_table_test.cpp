#include "raster/candidate_table.h"

#include <gtest/gtest.h>

#include <cstring>

#include "raster/small_scene.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

class CandidateTableTest : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    LUM_ASSERT_OK(style_, load_style(AssetRoots::standard(), "cinematic"));
    state_.emplace(small_state(*types_, *style_, SceneFrame{}));
  }

  [[nodiscard]] CandidateTable make_table(std::int64_t block_bytes = 65536) const {
    return CandidateTable(relight_layout(block_bytes, *types_, *style_), *types_, {"", "ball", "floor"});
  }
  /// Every light's column is 10 + its place in the rig.
  static std::uint32_t column(const LightRig&, int light) { return 10 + static_cast<std::uint32_t>(light); }

  std::optional<LightTypes> types_;
  std::optional<Style> style_;
  std::optional<ParamState> state_;
};

TEST_F(CandidateTableTest, ListsTheLightsOfARigWithTheirTypeBlockAndColumn) {
  CandidateTable table = make_table();
  ASSERT_TRUE(table.add({&*state_, Candidate::kAllLights}, column));
  const auto type = static_cast<std::uint32_t>(types_->index("cinematic"));
  EXPECT_EQ(table.candidates().at(0), (CandidateTable::Row{0, 2, 0, 0}));
  EXPECT_EQ(table.lights().at(0), (CandidateTable::Row{type, 0, 10, LinkTable::kKeyOfAll}));
  EXPECT_EQ(table.lights().at(1), (CandidateTable::Row{type, 1, 11, LinkTable::kEverything}));
  const auto fill = state_->rig.lights[1].params.bytes();
  const auto stored = table.light_type(type).subspan(fill.size(), fill.size());
  EXPECT_EQ(std::memcmp(stored.data(), fill.data(), fill.size()), 0);
}

TEST_F(CandidateTableTest, ATermHasOneLightAndNoAmbient) {
  CandidateTable table = make_table();
  ASSERT_TRUE(table.add({&*state_, 1}, column));
  EXPECT_EQ(table.candidates().at(0), (CandidateTable::Row{0, 1, kNone, 0}));
  EXPECT_EQ(table.lights().at(0)[2], 11U);
}

TEST_F(CandidateTableTest, MutedLightsAndNoLightsLeaveOnlyTheRest) {
  CandidateTable table = make_table();
  state_->rig.lights[0].muted = true;
  ASSERT_TRUE(table.add({&*state_, Candidate::kAllLights}, column));
  ASSERT_TRUE(table.add({&*state_, Candidate::kNoLights}, column));
  ASSERT_TRUE(table.add({&*state_, 0}, column));
  EXPECT_EQ(table.candidates().at(0)[1], 1U);
  EXPECT_EQ(table.lights().at(0)[2], 11U);
  EXPECT_EQ(table.candidates().at(2), (CandidateTable::Row{1, 0, 0, 0}));
  EXPECT_EQ(table.candidates().at(4), (CandidateTable::Row{1, 0, kNone, 0}));
}

TEST_F(CandidateTableTest, StoresWhatCandidatesShareOnce) {
  CandidateTable table = make_table();
  ParamState changed = *state_;
  changed.rig.lights[1].params.set_vec3(*changed.rig.lights[1].params.schema().by_role("color"), Vec3(0.1F));
  ASSERT_TRUE(table.add({&*state_, Candidate::kAllLights}, column));
  ASSERT_TRUE(table.add({&changed, Candidate::kAllLights}, column));
  const auto type = static_cast<std::size_t>(types_->index("cinematic"));
  const std::size_t block = types_->all()[type].schema->byte_size();
  EXPECT_EQ(table.light_type(type).size(), 3 * block) << "the key light is stored once, the fill light twice";
  EXPECT_EQ(table.ambient().size(), types_->ambient()->byte_size());
}

TEST_F(CandidateTableTest, RefusesWhatDoesNotFitAndStaysAsItWas) {
  const auto type = static_cast<std::size_t>(types_->index("cinematic"));
  const auto block = static_cast<std::int64_t>(types_->all()[type].schema->byte_size());
  CandidateTable table = make_table(3 * block);
  ASSERT_TRUE(table.add({&*state_, Candidate::kAllLights}, column));
  EXPECT_FALSE(table.add({&*state_, Candidate::kAllLights}, column)) << "two more could be needed, one is free";
  EXPECT_EQ(table.size(), 1U);
  EXPECT_TRUE(table.add({&*state_, 0}, column));
  table.clear();
  EXPECT_EQ(table.size(), 0U);
  EXPECT_TRUE(table.add({&*state_, Candidate::kAllLights}, column));
}

}  // namespace
}  // namespace luminist
