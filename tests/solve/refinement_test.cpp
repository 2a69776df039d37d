// Solves on estimates, of which more paths know more.
#include "solve/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "fake_renderer.h"
#include "render/metric.h"
#include "solve/random.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kSize = 48;

ParamSpec number(const std::string& name, double value, double most) {
  ParamSpec spec;
  spec.name = name;
  spec.role = name;
  spec.type = ParamType::kInt;
  spec.default_value = {value};
  spec.range_min = {0.0};
  spec.range_max = {most};
  return spec;
}

/// The fake's pictures with the noise of as many paths as the style keeps, chosen by its seed.
class NoisyRenderer final : public Renderer {
 public:
  explicit NoisyRenderer(bool counts_paths, int paths = 2, double spread = 1.5) : fake_(kSize, kSize), spread_(spread) {
    style_ = fake_.style();
    std::vector<ParamSpec> specs{number("kept", paths, 256)};
    if (counts_paths) specs.push_back(number("seed", 1, 1e6));
    auto schema = ParamSchema::create(std::move(specs), "noisy");
    EXPECT_TRUE(schema);
    style_.schema = *schema;
  }
  [[nodiscard]] FakeRenderer& exact() { return fake_; }
  [[nodiscard]] ParamState with_style(const ParamState& state) const {
    return {state.rig, ParamBlock(style_.schema, fake_.frame())};
  }
  [[nodiscard]] const SurfaceBuffer& surface() const override { return fake_.surface(); }
  [[nodiscard]] SceneFrame frame() const override { return fake_.frame(); }
  [[nodiscard]] const Style& style() const override { return style_; }
  [[nodiscard]] bool estimates() const override { return true; }
  [[nodiscard]] const WorkCount& work() const override { return fake_.work(); }
  Result<Image> render(const ParamState& state, const RenderOptions& options) override {
    LUM_TRY(Image picture, fake_.render(state, options));
    for (std::size_t i = 0; i < picture.pixels(); ++i) picture.set_rgb(i, picture.rgb(i) * noise(state, i));
    return picture;
  }
  using Renderer::error;
  Result<double> error(const ParamState& state, const Target& target) override {
    LUM_TRY(const Image picture, render(state, {}));
    return picture_error(picture, target, style_.metric);
  }
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out) override {
    LUM_TRY_VOID(fake_.evaluate(candidates, samples, softness, out));
    const std::size_t count = samples.pixels.size();
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      for (std::size_t i = 0; i < count; ++i) out[k * count + i] *= noise(*candidates[k].state, samples.pixels[i]);
    }
    return {};
  }

 private:
  [[nodiscard]] float noise(const ParamState& state, std::size_t pixel) const {
    const auto seed = state.style.schema().by_role("seed");
    Random random(1000003 * static_cast<std::uint64_t>(seed ? state.style.get(*seed) : 1.0) + pixel);
    const double spread = spread_ / std::sqrt(state.style.get(*state.style.schema().by_role("kept")));
    return static_cast<float>(1.0 + spread * random.uniform(-1.0, 1.0));
  }

  FakeRenderer fake_;
  double spread_;  ///< of one path
  Style style_;
};

class RefinementTest : public ::testing::Test {
 protected:
  /// A light that is to be found, and the same light elsewhere.
  void SetUp() override {
    const FakeRenderer fake(kSize, kSize);
    wanted_ = std::make_unique<ParamState>(fake.empty_state());
    wanted_->rig.lights.push_back(hidden_light(fake, "key", 5));
    start_ = std::make_unique<ParamState>(*wanted_);
    ParamBlock& params = start_->rig.lights.front().params;
    params.set_param_locked(-1, true);
    const int position = *params.schema().by_role("position");
    params.set_param_locked(position, false);
    params.set_vec3(position, params.vec3(position) + Vec3(0.4F, -0.3F, 0.2F));
  }
  Result<ParamState> solve(NoisyRenderer& renderer) {
    const Target target = painted(renderer);
    const SolveOptions options{.solver = SolverKind::kFast, .max_evals = most_evals_, .restarts = 0};
    LUM_TRY(SolveSession session, SolveSession::create(renderer, renderer.with_style(*start_), target, options));
    for (bool more = true; more;) {
      LUM_TRY(more, session.step());
    }
    report_ = session.report();
    return session.best();
  }
  /// The wanted light's picture, which counts in the square.
  Target painted(NoisyRenderer& renderer) {
    Target target = renderer.exact().target_of(*wanted_, *start_);
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const bool counts = std::max(std::abs(x - kSize / 2), std::abs(y - kSize / 2)) <= half_;
        target.importance.at(x, y, 0) = counts ? 1.0F : 0.0F;
      }
    }
    return target;
  }
  /// Without noise, of the whole picture.
  double true_error(NoisyRenderer& renderer, const ParamState& state) {
    const Target target = renderer.exact().target_of(*wanted_, *start_);
    auto error = renderer.exact().error(state, target);
    EXPECT_TRUE(error);
    return error ? *error : 0.0;
  }

  std::unique_ptr<ParamState> wanted_, start_;
  SolveReport report_;
  int half_ = kSize;  ///< of the square in the middle that counts, half its side; kSize: all of the picture
  int most_evals_ = SolveOptions{}.max_evals;
};

TEST_F(RefinementTest, FindsWhatTheNoiseOfFewPathsHides) {
  half_ = 4;
  NoisyRenderer few(false);
  LUM_ASSERT_OK(const ParamState coarse, solve(few));
  NoisyRenderer more(true);
  LUM_ASSERT_OK(const ParamState fine, solve(more));
  EXPECT_LT(true_error(more, fine), 0.8 * true_error(few, coarse));
}

TEST_F(RefinementTest, DoesNoMoreWhereALookAheadGainsNothing) {
  constexpr int kMany = 16;
  NoisyRenderer alone(false, kMany);
  LUM_ASSERT_OK([[maybe_unused]] const ParamState coarse, solve(alone));
  const SolveReport without = report_;
  NoisyRenderer renderer(true, kMany);
  LUM_ASSERT_OK(const ParamState found, solve(renderer));
  EXPECT_EQ(report_.evals, without.evals) << "no picture is compared for it";
  EXPECT_EQ(report_.epsilon, without.epsilon);
  EXPECT_LT(true_error(renderer, found), 0.02 * true_error(renderer, renderer.with_style(*start_)));
}

TEST_F(RefinementTest, GoesOnWhereALookAheadGains) {
  constexpr int kPaths = 16;
  constexpr double kSpread = 12.0;
  // Fewer pixels than a look ahead takes, and more; noise hides less among more.
  for (const auto& [half, share] : {std::pair(12, 0.8), std::pair(20, 1.0)}) {
    half_ = half;
    NoisyRenderer alone(false, kPaths, kSpread);
    LUM_ASSERT_OK(const ParamState coarse, solve(alone));
    const int evals = report_.evals;
    NoisyRenderer renderer(true, kPaths, kSpread);
    LUM_ASSERT_OK(const ParamState fine, solve(renderer));
    EXPECT_GE(report_.evals, evals + Refinement::kPictures) << half;
    EXPECT_LT(true_error(renderer, fine), share * true_error(alone, coarse)) << half;
  }
}

TEST_F(RefinementTest, LeavesTheUsersPathsAndTellsTheirErrors) {
  NoisyRenderer renderer(true);
  const ParamState start = renderer.with_style(*start_);
  LUM_ASSERT_OK(const ParamState found, solve(renderer));
  EXPECT_TRUE(found.style.same_values(start.style));
  const Target target = renderer.exact().target_of(*wanted_, *start_);
  LUM_ASSERT_OK(const double few, renderer.error(start, target));
  EXPECT_NEAR(report_.epsilon_start, few, 1e-9);
  LUM_ASSERT_OK(const double left, renderer.error(found, target));
  EXPECT_NEAR(report_.epsilon, left, 1e-6);
  EXPECT_LT(report_.epsilon, report_.epsilon_start);
  EXPECT_EQ(report_.termination, Termination::kConverged);
}

TEST_F(RefinementTest, NeverEndsWorseThanItsStartNorComparesMoreThanItMay) {
  for (std::uint64_t light = 1; light <= 3; ++light) {
    const FakeRenderer fake(kSize, kSize);
    wanted_->rig.lights.front() = hidden_light(fake, "key", light);
    start_->rig = wanted_->rig;  // nothing is to be gained but noise
    ParamBlock& params = start_->rig.lights.front().params;
    params.set_param_locked(-1, true);
    params.set_param_locked(*params.schema().by_role("position"), false);
    NoisyRenderer renderer(true, light == 2 ? 16 : 2);
    for (const int most : {8, 200}) {
      most_evals_ = most;
      LUM_ASSERT_OK([[maybe_unused]] const ParamState found, solve(renderer));
      EXPECT_LE(report_.epsilon, report_.epsilon_start) << light;
      EXPECT_LE(report_.evals, most) << light;
    }
  }
}

TEST_F(RefinementTest, HasNothingToDoWhereOnlyColoursTurn) {
  NoisyRenderer renderer(true);
  ParamState state = renderer.with_style(*start_);
  const Target target = renderer.exact().target_of(*wanted_, *start_);
  Progress progress(renderer, state, {});
  EXPECT_NE(Refinement::create(renderer, target, progress, state, nullptr), nullptr);
  ParamBlock& params = state.rig.lights.front().params;
  params.set_param_locked(-1, true);
  params.set_param_locked(*params.schema().by_role("color"), false);
  EXPECT_EQ(Refinement::create(renderer, target, progress, state, nullptr), nullptr);
}

}  // namespace
}  // namespace luminist
