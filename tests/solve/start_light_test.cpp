#include "solve/start_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/fake_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A dark picture of the fake scene on which a directional Lambert light is painted, where it shines on `object` (0:
/// all).
Target lambert_paint(const FakeRenderer& renderer, const Vec3& to_light, const Vec3& light, std::uint32_t object) {
  const SurfaceBuffer& surface = renderer.surface();
  Target target;
  target.before = Image(surface.width, surface.height, 3, 0.05F);
  target.color = target.before;
  target.importance = Image(surface.width, surface.height, 1, 0.1F);
  target.stroke.assign(surface.pixels(), 0);
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    const float facing = glm::dot(surface.normal[i], to_light);
    if (surface.object[i] == 0 || facing <= 0.0F || (object != 0 && surface.object[i] != object)) continue;
    target.color.set_rgb(i, target.before.rgb(i) + surface.albedo[i] * light * facing);
    target.importance.data[i] = 1.0F;
    target.stroke[i] = 1;
  }
  return target;
}

TEST(StartLight, RecoversDirectionAndIntensityOfALambertPainting) {
  const FakeRenderer renderer(96, 96);
  const Vec3 to_light = glm::normalize(Vec3(0.5F, 0.7F, 0.8F));
  const Vec3 light(1.2F, 0.8F, 0.4F);
  LUM_ASSERT_OK(
      const StartLight start,
      estimate_start_light(renderer.surface(), lambert_paint(renderer, to_light, light, 3), renderer.frame()));
  EXPECT_FALSE(start.ill_conditioned);
  EXPECT_LT(glm::distance(start.direction, -to_light), 1e-3F);  // float normals
  EXPECT_LT(glm::distance(start.intensity, light), 1e-3F);
  EXPECT_LT(glm::distance(start.position, start.hot_spot + 2.0F * renderer.frame().radius * to_light), 1e-2F);
}

TEST(StartLight, FallsBackToAverageNormalAndColourOnAFlatWall) {
  const FakeRenderer renderer(96, 96);
  const Target target = lambert_paint(renderer, glm::normalize(Vec3(1.0F, 0.0F, 1.0F)), Vec3(0.7F), 2);
  LUM_ASSERT_OK(const StartLight start, estimate_start_light(renderer.surface(), target, renderer.frame()));
  EXPECT_TRUE(start.ill_conditioned);
  EXPECT_LT(glm::distance(start.direction, Vec3(0.0F, 0.0F, -1.0F)), 1e-5F);
  EXPECT_NEAR(start.intensity.x, 0.7 / std::sqrt(2.0), 1e-3);  // what the wall shows, over its albedo
}

TEST(StartLight, FallsBackWhereLeastSquaresWouldShineFromBehind) {
  const FakeRenderer renderer(96, 96);
  const SurfaceBuffer& surface = renderer.surface();
  Target target = lambert_paint(renderer, Vec3(0.0F, 0.0F, 1.0F), Vec3(1.0F), 3);
  for (std::size_t i = 0; i < surface.pixels(); ++i) {  // brightest at the rim, as no light in front can make it
    if (target.stroke[i] == 0) continue;
    const float rim = 1.0F - std::min(1.0F, glm::dot(surface.normal[i], glm::normalize(surface.eye)));
    target.color.set_rgb(i, target.before.rgb(i) + Vec3(0.02F + rim * rim));
  }
  LUM_ASSERT_OK(const StartLight start, estimate_start_light(surface, target, renderer.frame()));
  float facing = 0.0F;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (target.stroke[i] != 0) facing -= glm::dot(surface.normal[i], start.direction);
  }
  EXPECT_GT(facing, 0.0F);
}

TEST(StartLight, SaysSoWhenNothingWasLightened) {
  const FakeRenderer renderer(32, 32);
  Target target = lambert_paint(renderer, Vec3(0.0F, 1.0F, 0.0F), Vec3(1.0F), 0);
  target.color = target.before;
  EXPECT_EQ(error_of(estimate_start_light(renderer.surface(), target, renderer.frame())).kind, ErrorKind::kNothingToDo);
  EXPECT_EQ(error_of(estimate_start_lights(3, renderer.surface(), target, renderer.frame())).kind,
            ErrorKind::kNothingToDo);
}

TEST(StartLight, BrightensWhatWasPainted) {
  FakeRenderer renderer(64, 64);
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const ParamState empty = renderer.empty_state();
    ParamState wanted = empty;
    wanted.rig.lights.push_back(hidden_light(renderer, "hidden", seed));
    const Target target = renderer.target_of(wanted, empty);
    LUM_ASSERT_OK(const StartLight start, estimate_start_light(renderer.surface(), target, renderer.frame()));
    ParamState state = empty;
    state.rig.lights.push_back(renderer.cinematic("new"));
    apply_start_light(start, state.rig.lights[0]);
    LUM_ASSERT_OK(const Image picture, renderer.render(state, {}));
    const std::vector<float> painted = lightening(renderer.surface(), target);
    double added = 0.0;
    for (std::size_t i = 0; i < painted.size(); ++i) {
      if (painted[i] > 0.0F) added += glm::dot(picture.rgb(i) - target.before.rgb(i), Vec3(1.0F));
    }
    EXPECT_GT(added, 0.0) << seed;
  }
}

TEST(StartLight, StaysWithinTheRangesOfTheLight) {
  const FakeRenderer renderer(48, 48);
  StartLight start;
  start.frame = renderer.frame();
  start.hot_spot = Vec3(5.0F, 0.5F, 0.0F);
  start.direction = Vec3(-1.0F, 0.0F, 0.0F);
  start.position = Vec3(50.0F, 0.5F, 0.0F);
  start.intensity = Vec3(100.0F, 1.0F, 0.0F);
  start.half_angle = 1.5F;
  Light light = renderer.cinematic("new");
  apply_start_light(start, light);
  const std::vector<const ParamBlock*> blocks{&light.params};
  const UnitMap map = UnitMap::create(blocks, renderer.frame());
  EXPECT_NEAR(penalty(map.to_unit(blocks)), 0.0, 1e-5);  // values are floats
  EXPECT_LT(light.params.vec3(*light.params.schema().by_role("direction")).x, -0.99F);
}

TEST(StartLight, TwoPaintedPlacesOfTwoColoursBecomeTwoLights) {
  const FakeRenderer renderer(96, 96);
  Target target = lambert_paint(renderer, glm::normalize(Vec3(-0.5F, 0.5F, 1.0F)), Vec3(1.5F, 0.5F, 0.1F), 3);
  const Target other = lambert_paint(renderer, glm::normalize(Vec3(0.7F, 0.5F, 1.0F)), Vec3(0.1F, 0.4F, 1.0F), 6);
  for (std::size_t i = 0; i < other.stroke.size(); ++i) {
    if (other.stroke[i] == 0) continue;
    target.color.set_rgb(i, other.color.rgb(i));
    target.stroke[i] = 2;
    target.importance.data[i] = 1.0F;
  }
  LUM_ASSERT_OK(const std::vector<StartLight> starts,
                estimate_start_lights(2, renderer.surface(), target, renderer.frame()));
  ASSERT_EQ(starts.size(), 2U);
  EXPECT_LT(glm::distance(starts[0].intensity, Vec3(1.5F, 0.5F, 0.1F)), 0.01F);  // the larger sphere comes first
  EXPECT_LT(glm::distance(starts[1].intensity, Vec3(0.1F, 0.4F, 1.0F)), 0.01F);
  EXPECT_GT(starts[1].hot_spot.x, starts[0].hot_spot.x);
}

}  // namespace
}  // namespace luminist
