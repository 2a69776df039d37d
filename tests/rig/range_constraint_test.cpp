// Numbers of lights that stay in a range (rig/constraint.h).
#include <array>
#include <cmath>

#include "params/unit_map.h"
#include "rig/constraint_fixture.h"

namespace luminist {
namespace {

using RangeConstraintTest = ConstraintTest;

TEST_F(RangeConstraintTest, ANumberGoesIntoItsRangeAndIsSolvedForInIt) {
  Light& key = light("key");
  const int shape = param(key, "shape");
  const int first = key.params.schema()[shape].first_dof;
  rig_.constraints = {{"key", Between{"barn", 0.25F, 0.5F}}, {"key", Between{"position.x", -1.0F, 2.0F}}};
  ASSERT_FALSE(find_fault(rig_));
  key.params.set_vec3(shape, Vec3(0.1F, 0.3F, 0.9F));
  put(key, "position", Vec3(7.0F, 7.0F, 7.0F));
  keep_constraints(rig_);
  EXPECT_EQ(value(key, "shape"), Vec3(0.25F, 0.3F, 0.5F));
  EXPECT_EQ(value(key, "position"), Vec3(2.0F, 7.0F, 7.0F));
  EXPECT_EQ(key.params.range(shape, 0, frame_).high, 0.5);
  key.params.set_param_locked(-1, true);
  key.params.set_locked(first, false);
  const std::array<const ParamBlock*, 1> readable{&key.params};
  const std::array<ParamBlock*, 1> blocks{&key.params};
  const UnitMap map = UnitMap::create(readable, frame_);
  EXPECT_DOUBLE_EQ(map.to_unit(readable)[0], 0.0);
  map.from_unit(std::array{0.6}, blocks);
  EXPECT_NEAR(key.params.get(shape, 0), 0.4, 1e-7);
  rig_.constraints.clear();
  keep_constraints(rig_);
  EXPECT_GT(key.params.range(shape, 0, frame_).high, 1.0) << "the declared one again";
}

TEST_F(RangeConstraintTest, OnAPlaneALightStaysInTheRangeOfACoordinate) {
  const Plane slope{Vec3(0.0F, 2.0F, 0.0F), Vec3(1.0F, 2.0F, 0.0F)};
  rig_.constraints = {{"key", Between{"position.x", -1.0F, 1.0F}}, {"key", OnPlane{slope}}};
  ASSERT_FALSE(find_fault(rig_));
  for (unsigned seed = 0; seed < 50; ++seed) {
    shuffle(seed);
    keep_constraints(rig_);
    const Vec3 place = value(light("key"), "position");
    EXPECT_LE(std::abs(place.x), 1.0F);
    EXPECT_NEAR(glm::dot(place - slope.point, slope.normal), 0.0F, 4e-6F);
    const std::vector<std::byte> once = bits();
    keep_constraints(rig_);
    EXPECT_EQ(bits(), once) << seed;
  }
}

TEST_F(RangeConstraintTest, ADarkLightWaitsForPaintWhateverTheRangeOfItsColour) {
  Light& key = light("key");
  rig_.constraints = {{"key", Between{"color", 0.2F, 1.0F}}};
  put(key, "color", Vec3(0.0F));
  keep_constraints(rig_);
  EXPECT_EQ(value(key, "color"), Vec3(0.0F));
  EXPECT_NE(key.params.limits(key.params.schema()[param(key, "color")].first_dof), nullptr);
  put(key, "color", Vec3(0.0F, 0.5F, 3.0F));
  keep_constraints(rig_);
  EXPECT_EQ(value(key, "color"), Vec3(0.2F, 0.5F, 1.0F));
}

TEST_F(RangeConstraintTest, SaysWhatCannotBeKept) {
  const Plane floor;
  const Plane slope{Vec3(0.0F, 2.0F, 0.0F), Vec3(1.0F, 2.0F, 0.0F)};
  struct Case {
    std::vector<Constraint> constraints;
    const char* field;  ///< of the last constraint
    const char* says;
  };
  const std::vector<Case> cases = {
      {{{"key", Between{"barns", 0.0F, 1.0F}}}, "between", "did you mean \"barn\""},
      {{{"key", Between{"barn.w", 0.0F, 1.0F}}}, "between", "did you mean \"barn"},
      {{{"key", Between{"direction", 0.0F, 1.0F}}}, "between", "no number \"direction\""},
      {{{"key", Between{"barn", 1.0F, 1.0F}}}, "between", "a lock holds one value"},
      {{{"key", Between{"barn", 0.0F, std::nanf("")}}}, "between", "no range"},
      {{{"key", Between{"barn", 0.1F, 1.0F}}, {"key", Between{"barn.y", 0.1F, 1.0F}}}, "between", "two ranges"},
      {{{"key", Between{"color", 0.1F, 1.0F}}, {"key", SameColor{"rim"}}}, "same_color", "colour of another"},
      {{{"key", AtDistance{1.0F, {}}}, {"key", Between{"position.x", 0.0F, 1.0F}}}, "between", "or a distance"},
      {{{"key", Between{"position.y", 0.0F, 1.0F}}, {"key", OnPlane{floor}}}, "on_plane", "the plane decides"},
      {{{"key", OnPlane{slope}},
        {"key", Between{"position.x", 0.0F, 1.0F}},
        {"key", Between{"position.y", 0.0F, 1.0F}}},
       "between",
       "the plane decides"},
      {{{"fill", MirrorOf{"key", floor}}, {"fill", Between{"barn", 0.1F, 1.0F}}}, "between", "is a mirror image"},
  };
  for (const Case& each : cases) {
    rig_.constraints = each.constraints;
    const auto fault = find_fault(rig_);
    ASSERT_TRUE(fault) << each.says;
    EXPECT_EQ(fault->index, each.constraints.size() - 1) << each.says;
    EXPECT_EQ(fault->field, each.field) << each.says;
    EXPECT_NE((fault->what + "; " + fault->hint).find(each.says), std::string::npos)
        << fault->what << "; " << fault->hint;
  }
}

}  // namespace
}  // namespace luminist
