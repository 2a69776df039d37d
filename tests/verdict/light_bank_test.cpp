#include "verdict/light_bank.h"

#include <gtest/gtest.h>

#include "solve/fake_renderer.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

TEST(LightBank, FindsAboutTheLightThatIsMissing) {
  FakeRenderer fake(64, 48);
  const ParamState before = fake.empty_state();
  Light light = fake.cinematic("missing");
  const int position = *light.params.schema().by_role("position");
  const int direction = *light.params.schema().by_role("direction");
  const Vec3 place(3.0F, 3.0F, 3.0F);
  light.params.set_vec3(position, place);
  light.params.set_vec3(direction, glm::normalize(Vec3(0.0F, 0.5F, 0.0F) - place));
  ParamState wanted = before;
  wanted.rig.lights = {light};
  Target target = fake.target_of(wanted, before);
  for (std::size_t i = 0; i < target.stroke.size(); ++i) target.stroke[i] = fake.surface().object[i] == 3 ? 1 : 0;
  const std::vector<StrokeRegion> regions = stroke_regions(fake.surface(), target);
  const SampledWish wish = only_region(sample_regions(regions, fake.surface(), target, 100), 1);
  std::vector<Vec3> now;
  for (const std::uint32_t pixel : wish.samples.pixels) now.push_back(target.before.rgb(pixel));
  const BankFocus focus = focus_of(wish, 1, now, fake.surface());
  LUM_ASSERT_OK(const LightBank bank, LightBank::create(fake, before, wish, {&focus, 1}, fake.cinematic("bank")));
  const LightBank::Pick pick = bank.best(wish.weight);
  // Sides are about 30 degrees apart, and Lambert's law is flat around the best one.
  EXPECT_GT(glm::dot(-pick.light.direction, glm::normalize(place - focus.position)), 0.8F);
  EXPECT_LT(wish.error(bank.fitted()), 0.3 * wish.error(bank.colors()));
  EXPECT_GT(pick.gain, 0.0);
}

TEST(LightBank, AddsNothingWhereNothingIsMissing) {
  FakeRenderer fake(48, 36);
  ParamState state = fake.empty_state();
  state.rig.lights = {hidden_light(fake, "key", 4)};
  const Target target = fake.target_of(state, state);
  const SampledWish wish = sample_regions(stroke_regions(fake.surface(), target), fake.surface(), target, 64);
  const BankFocus focus{{0.0F, 0.5F, 0.0F}, {0.0F, 0.3F, 0.9F}, 0.5F};
  LUM_ASSERT_OK(const LightBank bank, LightBank::create(fake, state, wish, {&focus, 1}, fake.cinematic("bank")));
  EXPECT_LE(wish.error(bank.fitted()), wish.error(bank.colors()));
  EXPECT_LE(bank.best(wish.weight).gain, 1e-6);
}

}  // namespace
}  // namespace luminist
