#include <gtest/gtest.h>

#include <array>

#include "solve/degenerate_problem.h"
#include "solve/fake_renderer.h"
#include "solve/live_solve.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kShards = 20;
constexpr int kProblemsAShard = static_cast<int>(fewer_sanitized(500));

class DegenerateProblems : public testing::TestWithParam<int> {
 protected:
  FakeRenderer& renderer_of(std::uint64_t seed) { return renderers_[seed % 16 == 15 ? 3 : seed % 3]; }
  static DegenerateProblem problem_of(FakeRenderer& renderer, std::uint64_t seed) {
    auto problem = degenerate_problem(renderer, renderer.empty_state(), renderer.cinematic("light"), seed);
    EXPECT_TRUE(problem.has_value()) << seed;
    return std::move(*problem);
  }

  std::array<FakeRenderer, 4> renderers_{FakeRenderer(8, 8), FakeRenderer(9, 6, FakeStyle::kToon),
                                         FakeRenderer(7, 7, FakeStyle::kTinted), FakeRenderer(1, 3)};
};

TEST_P(DegenerateProblems, EndWithNothingWorseThanTheirStart) {
  for (int i = 0; i < kProblemsAShard; ++i) {
    const auto seed = static_cast<std::uint64_t>(GetParam() * kProblemsAShard + i);
    FakeRenderer& renderer = renderer_of(seed);
    const DegenerateProblem problem = problem_of(renderer, seed);
    SCOPED_TRACE(std::to_string(seed) + ": " + problem.what);
    solve_degenerate(renderer, problem);
    if (HasFatalFailure()) return;
  }
}

TEST_P(DegenerateProblems, ShownLiveNeverGetWorseWhileTheyStandStill) {
  for (int i = 0; i < kProblemsAShard / 20; ++i) {
    const auto seed = static_cast<std::uint64_t>(GetParam() * kProblemsAShard + i);
    FakeRenderer& renderer = renderer_of(seed);
    const DegenerateProblem problem = problem_of(renderer, seed);
    SCOPED_TRACE(std::to_string(seed) + ": " + problem.what);
    auto live = LiveSolve::create(renderer, problem.start, problem.target, problem.options);
    ASSERT_EQ(live.has_value(), !problem.all_locked);
    if (!live) continue;
    const Target other = problem_of(renderer, seed + 3 * 16).target;  // of the same engine
    const SurfaceBuffer& surface = renderer.surface();
    for (const Target* target : {&problem.target, &other, &problem.target}) {
      LUM_EXPECT_OK(live->retarget(*target, {0, 0, surface.width, (surface.height + 1) / 2}));
      for (int step = 0; step < std::min(problem.steps, 20); ++step) {
        const double before = live->report().epsilon;
        LUM_ASSERT_OK([[maybe_unused]] const bool more, live->step());
        LUM_ASSERT_OK([[maybe_unused]] const bool changed, live->show());
        ASSERT_TRUE(std::isfinite(live->report().epsilon));
        ASSERT_LE(live->report().epsilon, before);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(TenThousand, DegenerateProblems, testing::Range(0, kShards));

}  // namespace
}  // namespace luminist
