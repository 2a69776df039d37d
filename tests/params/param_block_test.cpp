#include "params/param_block.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr const char* kBlockManifest = R"(
[[param]]
name = "place"
type = "vec3"
default = [0.5, 1, -2]
range = [-4, 4]
scale = "scene"
role = "position"
solve = true
doc = "d"

[[param]]
name = "reach"
type = "vec2"
default = [1.5, 0.25]
range = [0, 4]
scale = "scene"
role = "cutoff"
doc = "d"

[[param]]
name = "aim"
type = "direction"
default = [0, 3, -4]
range = [-1, 1]
solve = true
doc = "d"

[[param]]
name = "on"
type = "bool"
default = true
doc = "d"

[[param]]
name = "count"
type = "int"
default = 3
range = [0, 9]
doc = "d"

[[param]]
name = "filter_kind"
type = "choice"
choices = ["box", "tent", "gauss"]
default = "tent"
doc = "d"
)";

class ParamBlockTest : public ::testing::Test {
 protected:
  ParamBlockTest() {
    auto schema = ParamSchema::parse(kBlockManifest, "test.toml");
    EXPECT_TRUE(schema) << (schema ? "" : schema.error().message());
    schema_ = *schema;
  }
  template <class T>
  T raw(const ParamBlock& block, std::size_t offset) const {
    T value;
    std::memcpy(&value, block.bytes().data() + offset, sizeof value);
    return value;
  }
  std::shared_ptr<const ParamSchema> schema_;
  SceneFrame frame_{Vec3(10.0F, 20.0F, 30.0F), 2.0F};
};

TEST_F(ParamBlockTest, StartsWithTheDefaultsInTheFrameOfTheScene) {
  const ParamBlock block(schema_, frame_);
  EXPECT_EQ(block.vec3(0), Vec3(11.0F, 22.0F, 26.0F));  // centre + radius * default
  EXPECT_EQ(block.vec2(1), Vec2(3.0F, 0.5F));           // a length has no centre
  EXPECT_EQ(block.vec3(2), Vec3(0.0F, 0.6F, -0.8F));    // normalized
  EXPECT_EQ(block.get(3), 1.0);
  EXPECT_EQ(block.get(4), 3.0);
  EXPECT_EQ(block.get(5), 1.0);
}

TEST_F(ParamBlockTest, HoldsItsValuesAsTheBytesOfTheStd140Struct) {
  ParamBlock block(schema_, frame_);
  ASSERT_EQ(block.bytes().size(), 64U);
  EXPECT_EQ(raw<float>(block, 8), 26.0F);        // place.z
  EXPECT_EQ(raw<float>(block, 16), 3.0F);        // reach.x, after the vec3's 12 bytes and 4 of padding
  EXPECT_EQ(raw<float>(block, 40), -0.8F);       // aim.z
  EXPECT_EQ(raw<std::uint32_t>(block, 44), 1U);  // on, in the fourth slot of aim
  EXPECT_EQ(raw<std::int32_t>(block, 48), 3);    // count
  EXPECT_EQ(raw<std::int32_t>(block, 52), 1);    // filter_kind
  block.set(4, 0, -2.6);
  EXPECT_EQ(raw<std::int32_t>(block, 48), -3);
}

TEST_F(ParamBlockTest, KeepsPaddingZeroSoThatEqualValuesHaveEqualBytes) {
  ParamBlock block(schema_, frame_);
  EXPECT_EQ(raw<std::uint32_t>(block, 12), 0U);
  ParamBlock other(schema_, frame_);
  other.set_locked(0, true);
  EXPECT_TRUE(block.same_values(other));
  other.set(1, 1, 0.75);
  EXPECT_FALSE(block.same_values(other));
}

TEST_F(ParamBlockTest, UnlocksWhatTheSchemaGivesToTheSolver) {
  ParamBlock block(schema_, frame_);
  ASSERT_EQ(schema_->dofs(), 7);
  const bool locked[] = {false, false, false, true, true, false, false};
  for (int dof = 0; dof < 7; ++dof) EXPECT_EQ(block.locked(dof), locked[dof]) << dof;
  block.set_param_locked(1, false);
  EXPECT_FALSE(block.locked(3));
  EXPECT_FALSE(block.locked(4));
  block.set_param_locked(-1, true);
  for (int dof = 0; dof < 7; ++dof) EXPECT_TRUE(block.locked(dof)) << dof;
}

TEST_F(ParamBlockTest, RoundsIntegersAndTakesAnyNumberForABool) {
  ParamBlock block(schema_, frame_);
  block.set(4, 0, 2.5);
  EXPECT_EQ(block.get(4), 3.0);
  block.set(4, 0, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(block.get(4), 0.0);
  block.set(4, 0, 1e300);
  EXPECT_EQ(block.get(4), 2147483647.0);
  block.set(3, 0, 0.0);
  EXPECT_EQ(block.get(3), 0.0);
  block.set(3, 0, 7.0);
  EXPECT_EQ(block.get(3), 1.0);
}

TEST_F(ParamBlockTest, TurnsWhatNoFloatHoldsIntoInfinity) {
  ParamBlock block(schema_, frame_);
  block.set(0, 0, -1e300);
  EXPECT_EQ(block.get(0, 0), -std::numeric_limits<double>::infinity());
}

using ParamBlockDeathTest = ParamBlockTest;

TEST_F(ParamBlockDeathTest, AbortsOnAChoiceThatDoesNotExist) {
  ParamBlock block(schema_, frame_);
  EXPECT_DEATH(block.set(5, 0, 3.0), "a choice's index exists");
  EXPECT_DEATH((void)block.get(1, 2), "the component exists");
}

TEST(UnitDirection, KeepsUnitVectorsToTheBitAndNormalizesOthers) {
  const Vec3 unit = glm::normalize(Vec3(0.3F, -0.5F, 0.9F));
  EXPECT_EQ(unit_direction(unit), unit);
  EXPECT_EQ(unit_direction(Vec3(0.0F, 3.0F, 4.0F)), Vec3(0.0F, 0.6F, 0.8F));
  EXPECT_EQ(unit_direction(Vec3(1e-20F, 0.0F, 0.0F)), Vec3(1.0F, 0.0F, 0.0F));
  EXPECT_EQ(unit_direction(Vec3(3e38F, 0.0F, 3e38F)), Vec3(std::sqrt(0.5F), 0.0F, std::sqrt(0.5F)));
  EXPECT_EQ(unit_direction(Vec3(0.0F)), std::nullopt);
  EXPECT_EQ(unit_direction(Vec3(0.0F, std::numeric_limits<float>::quiet_NaN(), 1.0F)), std::nullopt);
}

}  // namespace
}  // namespace luminist
