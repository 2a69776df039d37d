// Work that its asker gives up half-way.
#include <array>
#include <vector>

#include "raster/renderer_fixture.h"

namespace luminist {
namespace {

/// A picture of two parts, whose work ends when it was asked so many times whether to go on.
class GivenUpTest : public RendererTest {
 protected:
  void SetUp() override {
    RendererTest::SetUp();
    LUM_ASSERT_OK(style_, load_style(AssetRoots::standard(), "cinematic"));
    LUM_ASSERT_OK(renderer_, RasterRenderer::create(*device_, scene_, scene_.cameras[0], *types_, *style_,
                                                    AssetRoots::standard(), 440, 320));
    for (std::uint32_t i = 0; i < 440 * 320; i += 7) samples_.pixels.push_back(i);
    samples_.id = 78;
    states_.assign(2, small_state(*types_, *style_, renderer_->frame()));
    for (Light& light : states_[1].rig.lights) {
      light.params.set(param(light.params, "position"), 0, light.params.get(param(light.params, "position"), 0) + 0.3);
    }
  }
  Result<std::vector<Vec3>> batch(const ParamState& state) {
    std::vector<Vec3> colors(samples_.pixels.size());
    const Candidate candidate{&state, Candidate::kAllLights};
    LUM_TRY_VOID(renderer_->evaluate({&candidate, 1}, samples_, {}, colors));
    return colors;
  }
  Result<std::vector<Vec3>> without_the_first(const ParamState& state) {
    std::vector<Vec3> colors(samples_.pixels.size());
    LUM_TRY_VOID(renderer_->colors_at(state, kFirst, samples_.pixels, colors));
    return colors;
  }
  /// Beside the light that moves the others stand still.
  Result<std::vector<Vec3>> picture(const ParamState& state) {
    LUM_TRY(const Image image, renderer_->render(state, {.moving = kFirst}));
    std::vector<Vec3> colors;
    for (std::size_t i = 0; i < image.pixels(); ++i) colors.push_back(image.rgb(i));
    return colors;
  }
  Result<std::vector<Vec3>> all_of(const ParamState& state) {
    LUM_TRY(std::vector<Vec3> seen, batch(state));
    for (const auto make : {&GivenUpTest::without_the_first, &GivenUpTest::picture}) {
      LUM_TRY(const std::vector<Vec3> more, (this->*make)(state));
      seen.insert(seen.end(), more.begin(), more.end());
    }
    return seen;
  }

  inline static const std::vector<int> kFirst = {0};
  SampleSet samples_;
  std::vector<ParamState> states_;
};

TEST_F(GivenUpTest, AnythingIsGivenUpAtOnce) {
  renderer_->ask([] { return false; });
  EXPECT_EQ(error_of(batch(states_[0])).kind, ErrorKind::kCancelled);
  EXPECT_EQ(error_of(without_the_first(states_[0])).kind, ErrorKind::kCancelled);
  EXPECT_EQ(error_of(picture(states_[0])).kind, ErrorKind::kCancelled);
}

/// Whenever work is given up, what is made afterwards is as if it had never begun.
TEST_F(GivenUpTest, LeavesNothingHalfDone) {
  std::vector<std::vector<Vec3>> whole;
  for (const ParamState& state : states_) {
    LUM_ASSERT_OK(auto seen, all_of(state));
    whole.push_back(std::move(seen));
  }
  int questions = 0;
  for (bool done = false; !done; ++questions) {
    ASSERT_LT(questions, 50);
    for (const auto [before, given_up, after] : {std::array{0U, 1U, 0U}, {0U, 1U, 1U}}) {
      EXPECT_EQ(all_of(states_[before]).value(), whole[before]) << questions;
      int left = questions;
      renderer_->ask([&left] { return left-- > 0; });
      const auto seen = all_of(states_[given_up]);
      renderer_->ask({});
      done = seen.has_value();
      EXPECT_EQ(all_of(states_[after]).value(), whole[after]) << questions << " of " << given_up;
    }
  }
  EXPECT_GT(questions, 7) << "before each, after the shadows, and between two parts of each picture";
}

}  // namespace
}  // namespace luminist
