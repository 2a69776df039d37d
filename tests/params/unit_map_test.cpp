#include "params/unit_map.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "support/fixtures.h"

namespace luminist {
namespace {

TEST(Penalty, IsZeroInsideTheUnitCubeAndClimbsOutside) {
  for (int i = 0; i <= 100; ++i) EXPECT_EQ(penalty(i / 100.0), 0.0);
  EXPECT_NEAR(penalty(-0.1), 0.44, 1e-12);  // (-1.2)^2 - 1, exact up to rounding
  EXPECT_NEAR(penalty(1.5), 3.0, 1e-12);
  EXPECT_GT(penalty(1.2), penalty(1.1));
}

TEST(Penalty, OfAPointIsTheSumOverItsCoordinates) {
  const std::array<double, 3> x = {-0.1, 0.5, 1.5};
  EXPECT_NEAR(penalty(x), 3.44, 1e-12);
  EXPECT_EQ(penalty(std::span<const double>()), 0.0);
}

constexpr const char* kMapManifest = R"(
[[param]]
name = "place"
type = "vec3"
default = [0, 0, 0]
range = [-4, 4]
scale = "scene"
role = "position"
solve = true
doc = "d"

[[param]]
name = "reach"
type = "float"
default = 1
range = [1, 3]
scale = "scene"
solve = true
doc = "d"

[[param]]
name = "soft"
type = "float"
default = 0.1
range = [0.01, 1]
scale = "log"
solve = true
doc = "d"

[[param]]
name = "aim"
type = "direction"
default = [0, 0, -1]
range = [-0.5, 1.5]
solve = true
doc = "d"

[[param]]
name = "tint"
type = "color"
default = [1, 1, 1]
range = [[0, 0, 0], [1, 2, 4]]
solve = true
doc = "d"
)";
constexpr int kPlace = 0;
constexpr int kReach = 1;
constexpr int kSoft = 2;
constexpr int kAim = 3;
constexpr int kTint = 4;

class UnitMapTest : public ::testing::Test {
 protected:
  UnitMapTest() : block_(schema(), frame_) {}
  static std::shared_ptr<const ParamSchema> schema() {
    auto schema = ParamSchema::parse(kMapManifest, "test.toml");
    EXPECT_TRUE(schema) << (schema ? "" : schema.error().message());
    return *schema;
  }
  UnitMap map() const { return UnitMap::create(std::array<const ParamBlock*, 1>{&block_}, frame_); }
  std::vector<double> to_unit(const UnitMap& map) const {
    return map.to_unit(std::array<const ParamBlock*, 1>{&block_});
  }
  void from_unit(const UnitMap& map, const std::vector<double>& x) {
    map.from_unit(x, std::array<ParamBlock*, 1>{&block_});
  }
  /// Everything locked but one parameter.
  UnitMap map_of(int param) {
    block_.set_param_locked(-1, true);
    block_.set_param_locked(param, false);
    return map();
  }

  SceneFrame frame_{Vec3(10.0F, 20.0F, 30.0F), 2.0F};
  ParamBlock block_;
};

TEST_F(UnitMapTest, MeasuresPositionsFromTheCentreInSceneRadii) {
  const UnitMap map = map_of(kPlace);
  EXPECT_EQ(to_unit(map), (std::vector{0.5, 0.5, 0.5}));
  from_unit(map, {0.0, 0.25, 1.0});
  EXPECT_EQ(block_.vec3(kPlace), Vec3(2.0F, 16.0F, 38.0F));  // centre - 4 radii, - 2 radii, + 4 radii
}

TEST_F(UnitMapTest, MeasuresLengthsInSceneRadiiFromZero) {
  const UnitMap map = map_of(kReach);
  from_unit(map, {0.5});
  EXPECT_EQ(block_.scalar(kReach), 4.0F);  // twice the radius
}

TEST_F(UnitMapTest, GoesGeometricallyThroughALogarithmicRangeAndBeyondIt) {
  const UnitMap map = map_of(kSoft);
  EXPECT_NEAR(to_unit(map)[0], 0.5, 1e-7);  // 0.1 as a float
  from_unit(map, {0.0});
  EXPECT_EQ(block_.scalar(kSoft), 0.01F);
  from_unit(map, {1.5});
  EXPECT_FLOAT_EQ(block_.scalar(kSoft), 10.0F);
  EXPECT_NEAR(to_unit(map)[0], 1.5, 1e-7);
  block_.set(kSoft, 0, -1.0);
  EXPECT_TRUE(std::isfinite(to_unit(map)[0]));
  EXPECT_LT(to_unit(map)[0], 0.0);
}

TEST_F(UnitMapTest, TakesTheRangeOfEachComponent) {
  const UnitMap map = map_of(kTint);
  EXPECT_EQ(to_unit(map), (std::vector{1.0, 0.5, 0.25}));
  from_unit(map, {-1.0, 0.25, 2.0});
  EXPECT_EQ(block_.vec3(kTint), Vec3(-1.0F, 0.5F, 8.0F));  // nothing is clamped
}

TEST_F(UnitMapTest, ChartsADirectionAroundItsValue) {
  const Vec3 base = glm::normalize(Vec3(0.3F, -0.8F, 0.2F));
  block_.set_vec3(kAim, base);
  const UnitMap map = map_of(kAim);
  EXPECT_EQ(to_unit(map), (std::vector{0.5, 0.5}));
  from_unit(map, {0.5, 0.5});
  EXPECT_EQ(block_.vec3(kAim), base);  // to the bit

  from_unit(map, {0.5 + 0.3, 0.5});  // 0.3 of a range of 2 radians
  const Vec3 along_u = block_.vec3(kAim);
  EXPECT_NEAR(std::acos(glm::dot(base, along_u)), 0.6, 1e-6);  // float rounding
  from_unit(map, {0.5, 0.5 + 0.3});
  const Vec3 along_v = block_.vec3(kAim);
  EXPECT_NEAR(std::acos(glm::dot(base, along_v)), 0.6, 1e-6);
  const Vec3 u = along_u - glm::dot(along_u, base) * base;
  const Vec3 v = along_v - glm::dot(along_v, base) * base;
  EXPECT_NEAR(glm::dot(u, v), 0.0F, 1e-6F);  // the axes are perpendicular
}

TEST_F(UnitMapTest, GoesOnAlongTheGreatCircleWhereverTheSolverSteps) {
  const UnitMap map = map_of(kAim);
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  from_unit(map, {0.5 + kPi / 2.0, 0.5});  // half a turn
  EXPECT_NEAR(block_.vec3(kAim).z, 1.0F, 1e-6F);
  for (const double x : {-1e9, 1e200, 1e308, inf, -inf, nan, 0.5 + 1e-300}) {
    from_unit(map, {x, 0.7});
    EXPECT_TRUE(is_finite(block_.vec3(kAim))) << x;
    EXPECT_NEAR(glm::length(block_.vec3(kAim)), 1.0F, 1e-6F) << x;
  }
}

TEST_F(UnitMapTest, KeepsALockedAxisOfADirectionAtItsBase) {
  block_.set_param_locked(-1, true);
  const ParamSpec& aim = block_.schema()[kAim];
  block_.set_locked(aim.first_dof + 1, false);
  const UnitMap map = this->map();
  ASSERT_EQ(map.dofs(), 1);
  EXPECT_EQ(map.list()[0].component, 1);
  from_unit(map, {0.7});
  EXPECT_NEAR(to_unit(map)[0], 0.7, 1e-6);
  block_.set_locked(aim.first_dof, false);
  block_.set_vec3(kAim, Vec3(0.0F, 0.0F, -1.0F));
  const UnitMap both = this->map();
  from_unit(both, {0.5, 0.7});
  EXPECT_NEAR(to_unit(map)[0], 0.7, 1e-6);  // the same direction: the first axis stayed at 0
}

TEST_F(UnitMapTest, StartsAChartFromAStoredVectorThatIsNoDirection) {
  block_.set_vec3(kAim, Vec3(0.0F));
  const UnitMap map = map_of(kAim);
  from_unit(map, {0.6, 0.6});
  EXPECT_NEAR(glm::length(block_.vec3(kAim)), 1.0F, 1e-6F);
}

TEST_F(UnitMapTest, LeavesLockedValuesAlone) {
  block_.set_locked(block_.schema()[kPlace].first_dof + 1, true);
  block_.set_param_locked(kTint, true);
  const ParamBlock before = block_;
  const UnitMap map = this->map();
  EXPECT_EQ(map.dofs(), 6);  // place.x, place.z, reach, soft, aim twice
  from_unit(map, std::vector<double>(6, 0.9));
  EXPECT_EQ(block_.get(kPlace, 1), before.get(kPlace, 1));
  EXPECT_EQ(block_.vec3(kTint), before.vec3(kTint));
  EXPECT_NE(block_.get(kPlace, 0), before.get(kPlace, 0));
}

TEST_F(UnitMapTest, ReturnsToTheSamePointFromAnywhereInTheCube) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<float> gauss;
  for (int trial = 0; trial < 1000; ++trial) {
    block_.set_vec3(kAim, glm::normalize(Vec3(gauss(random), gauss(random), gauss(random))));
    const UnitMap map = this->map();
    std::vector<double> x(static_cast<std::size_t>(map.dofs()));
    for (double& coordinate : x) coordinate = unit(random);
    from_unit(map, x);
    const std::vector<double> back = to_unit(map);
    // Stored floats have 24 bits; positions up to 38 in a range of 16 lose the most of them.
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(back[i], x[i], 1e-6) << trial << " " << i;
  }
}

TEST_F(UnitMapTest, ReturnsToTheSameDirectionAlsoNearTheFarSide) {
  std::mt19937 random(11);
  std::normal_distribution<float> gauss;
  const UnitMap map = map_of(kAim);
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 wanted = glm::normalize(Vec3(gauss(random), gauss(random), gauss(random)));
    block_.set_vec3(kAim, wanted);
    const std::vector<double> x = to_unit(map);
    block_.set_vec3(kAim, Vec3(0.0F, 1.0F, 0.0F));
    from_unit(map, x);
    EXPECT_NEAR(glm::distance(block_.vec3(kAim), wanted), 0.0F, 1e-6F) << trial;  // float rounding
  }
}

TEST_F(UnitMapTest, ListsSeveralBlocksInTheirOrder) {
  ParamBlock other = block_;
  other.set_param_locked(-1, true);
  other.set_param_locked(kSoft, false);
  block_.set_param_locked(-1, true);
  block_.set_param_locked(kReach, false);
  const std::array<const ParamBlock*, 2> blocks = {&block_, &other};
  const UnitMap map = UnitMap::create(blocks, frame_);
  ASSERT_EQ(map.dofs(), 2);
  EXPECT_EQ(map.list()[0].block, 0);
  EXPECT_EQ(map.list()[0].param, kReach);
  EXPECT_EQ(map.list()[1].block, 1);
  EXPECT_EQ(map.list()[1].param, kSoft);
}

TEST_F(UnitMapTest, OfLockedBlocksIsEmpty) {
  block_.set_param_locked(-1, true);
  const UnitMap map = this->map();
  EXPECT_EQ(map.dofs(), 0);
  EXPECT_TRUE(to_unit(map).empty());
  from_unit(map, {});
}

TEST_F(UnitMapTest, GivesTheSameBitsForTheSamePoint) {
  const UnitMap map = this->map();
  const std::vector<double> x(static_cast<std::size_t>(map.dofs()), 0.37);
  from_unit(map, x);
  const ParamBlock first = block_;
  from_unit(map, std::vector<double>(x.size(), 0.9));
  from_unit(map, x);
  EXPECT_TRUE(block_.same_values(first));
}

}  // namespace
}  // namespace luminist
