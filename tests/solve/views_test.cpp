#include "render/views.h"

#include <gtest/gtest.h>

#include "render/metric.h"
#include "solve/fake_renderer.h"
#include "solve/solve_session.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// One light, seen matte, in two tones and in dots, each view with the picture of that light as its target.
class ViewsTest : public testing::Test {
 protected:
  static constexpr int kSize = 48;

  ViewsTest() : wanted_(matte_.empty_state().rig) { wanted_.lights.push_back(hidden_light(matte_, "spot", 6)); }
  View view(FakeRenderer& renderer) {
    ParamState wanted = renderer.empty_state();
    wanted.rig = wanted_;
    ParamState before = wanted;
    before.rig.lights.clear();
    return {&renderer, renderer.target_of(wanted, before), wanted.style};
  }
  std::unique_ptr<Views> views(std::vector<View> list) {
    auto all = Views::create(std::move(list));
    EXPECT_TRUE(all) << (all ? "" : all.error().message());
    return std::move(*all);
  }
  std::unique_ptr<Views> all_views() { return views({view(matte_), view(two_tone_), view(dotted_)}); }
  [[nodiscard]] LightRig moved(const Vec3& by) const {
    LightRig rig = wanted_;
    ParamBlock& light = rig.lights[0].params;
    const int position = *light.schema().by_role("position");
    light.set_vec3(position, light.vec3(position) + by);
    return rig;
  }

  FakeRenderer matte_{kSize, kSize};
  FakeRenderer two_tone_{kSize, kSize, FakeStyle::kTwoTone};
  FakeRenderer dotted_{kSize, kSize, FakeStyle::kDotted};
  LightRig wanted_;
};

TEST_F(ViewsTest, TheirPictureIsOfAllViewsOneAboveTheOtherAsTheyAreCompared) {
  const auto all = all_views();
  const ParamState state = all->joint(wanted_);
  LUM_ASSERT_OK(const Image picture, all->render(state, {}));
  ASSERT_EQ(picture.height, 3 * kSize);
  LUM_ASSERT_OK(const Image matte, matte_.render(all->state_of(state, 0), {}));
  LUM_ASSERT_OK(const Image dots, dotted_.render(all->state_of(state, 2), {}));
  const Image blurred = as_compared(dots, dotted_.style().metric);
  const std::size_t rest = 2 * matte.data.size();
  EXPECT_TRUE(std::equal(matte.data.begin(), matte.data.end(), picture.data.begin()));
  EXPECT_TRUE(std::equal(blurred.data.begin(), blurred.data.end(), picture.data.begin() + static_cast<long>(rest)));
}

TEST_F(ViewsTest, TheirErrorIsTheMeanOfTheViewsErrorsHoweverMuchIsPainted) {
  View first = view(matte_);
  for (std::size_t i = 0; i < first.target.importance.data.size() / 2; ++i) first.target.importance.data[i] = 0.0F;
  const auto all = views({first, view(two_tone_), view(dotted_)});
  const ParamState state = all->joint(moved(Vec3(0.2F, 0.1F, -0.1F)));
  double mean = 0.0;
  for (int k = 0; k < 3; ++k) {
    LUM_ASSERT_OK(const double epsilon, all->error_of(state, k));
    EXPECT_GT(epsilon, 0.0);
    mean += epsilon / 3.0;
  }
  LUM_ASSERT_OK(const double joint, all->error(state, all->target()));
  EXPECT_NEAR(joint, mean, 1e-6 * mean);  // importance is scaled in floats
}

TEST_F(ViewsTest, SamplesAreThoseOfTheViewsTheyLieIn) {
  const auto all = all_views();
  const ParamState state = all->joint(wanted_);
  const SampleSet samples{7, {100, 100 + 2 * kSize * kSize, 40, 100 + kSize * kSize}};
  const Candidate candidate{&state, 0};
  std::vector<Vec3> out(4);
  LUM_EXPECT_OK(all->evaluate({&candidate, 1}, samples, {}, out));
  for (int k = 0; k < 3; ++k) {
    FakeRenderer& one = k == 0 ? matte_ : k == 1 ? two_tone_ : dotted_;
    const ParamState seen = all->state_of(state, k);
    const Candidate alone{&seen, 0};
    std::vector<Vec3> wanted(1);
    LUM_EXPECT_OK(one.evaluate({&alone, 1}, {1, {100}}, {}, wanted));
    EXPECT_EQ(out[k == 0 ? 0U : k == 1 ? 3U : 1U], wanted[0]);
  }
}

TEST_F(ViewsTest, EachStyleHasItsOwnParametersAndViewsOfOneStyleShareThem) {
  const auto all = views({view(matte_), view(two_tone_), view(two_tone_)});
  const ParamSchema& schema = *all->style().schema;
  EXPECT_EQ(schema.size(), 2 + 4);
  ParamState state = all->joint(wanted_);
  ASSERT_TRUE(schema.find("two_tone_bright"));
  state.style.set_vec3(*schema.find("two_tone_bright"), Vec3(0.3F, 0.4F, 0.5F));
  for (const int k : {1, 2}) EXPECT_EQ(all->state_of(state, k).style.vec3(2), Vec3(0.3F, 0.4F, 0.5F));
}

TEST_F(ViewsTest, ASolveFindsOneRigForAllViewsAndEachStylesColours) {
  const auto all = all_views();
  ParamState start = all->joint(moved(Vec3(0.3F, 0.2F, -0.2F)));
  const int bright = *all->style().schema->find("two_tone_bright");
  start.style.set_vec3(bright, Vec3(0.3F, 1.8F, 0.6F));
  LUM_ASSERT_OK(SolveSession solve, SolveSession::create(*all, start, all->target(), {.seed = 3}));
  for (bool more = true; more;) {
    LUM_ASSERT_OK(more, solve.step());
  }
  EXPECT_LT(solve.report().epsilon, 0.1 * solve.report().epsilon_start);  // all targets can be met at once
  for (int k = 0; k < 3; ++k) {
    LUM_ASSERT_OK(const double before, all->error_of(start, k));
    LUM_ASSERT_OK(const double after, all->error_of(solve.best(), k));
    EXPECT_LT(after, 0.3 * before);
  }
}

TEST_F(ViewsTest, PicturesOfDifferentWidthsAreRefused) {
  FakeRenderer wide(64, kSize);
  EXPECT_EQ(error_of(Views::create({view(matte_), view(wide)})).kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace luminist
