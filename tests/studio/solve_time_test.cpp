#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <chrono>

#include "solve/solve_session.h"
#include "studio/stage.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A scene of the project in its rig, the first lights unlocked, to be solved for its own picture from lights that were
/// moved.
class RigSolve : public testing::Test {
 protected:
  void open(const std::string& name, int size, std::size_t free_lights) {
    LUM_ASSERT_OK(device_, Device::create_headless());
    Shot shot;
    shot.scene = "meshes/" + name + "/" + name + ".glb";
    shot.rig = "meshes/" + name + "/rig.toml";
    shot.width = shot.height = size;
    const AssetRoots roots = AssetRoots::standard();
    LUM_ASSERT_OK(stage_, open_stage(*device_, roots, shot, ".", diagnostics_));
    LUM_ASSERT_OK(start_, starting_state(*stage_, roots, shot, "."));
    LUM_ASSERT_OK(target_.color, stage_->renderer->render(*start_));
    for (ParamBlock* block : start_->blocks()) block->set_param_locked(-1, false);
    for (std::size_t i = free_lights; i < start_->rig.lights.size(); ++i) {
      start_->rig.lights[i].params.set_param_locked(-1, true);
    }
    const Vec3 step = 0.3F * stage_->frame.radius * Vec3(1.0F, -0.5F, 0.7F);
    for (Light& light : start_->rig.lights) {
      const int position = *light.params.schema().by_role("position");
      light.params.set_vec3(position, light.params.vec3(position) + step);
    }
    LUM_ASSERT_OK(target_.before, stage_->renderer->render(*start_));
    target_.importance = Image(size, size, 1, 1.0F);
    target_.stroke.assign(target_.color.pixels(), 1);
  }

  Diagnostics diagnostics_;
  std::optional<Device> device_;
  std::unique_ptr<Stage> stage_;
  std::optional<ParamState> start_;
  Target target_;
};

TEST_F(RigSolve, AtFullSizeItCanBeStoppedAtAnyTimeWithoutAWait) {
  open("creature", 512, 7);
  if (HasFatalFailure()) return;
  EXPECT_EQ(start_->rig.lights.size(), 7U);
  constexpr double kDeadline = 2.0;  // seconds: ten times what an artist may wait for a cancelled solve
  constexpr double kWatched = 10.0;  // seconds of a solve
  auto before = Clock::now();
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(*stage_->renderer, *start_, target_, {}));
  double longest = seconds_since(before);
  EXPECT_LT(longest, kDeadline) << "to begin";
  const auto start = Clock::now();
  int steps = 0;
  for (bool more = true; more && seconds_since(start) < kWatched; ++steps) {
    before = Clock::now();
    LUM_ASSERT_OK(more, session.step());
    const double step = seconds_since(before);
    EXPECT_LT(step, kDeadline) << "step " << steps;
    longest = std::max(longest, step);
  }
  RecordProperty("longest_ms", static_cast<int>(1e3 * longest));
  EXPECT_GT(steps, 10);
  session.stop();
  LUM_ASSERT_OK(const bool more, session.step());
  EXPECT_FALSE(more);
}

TEST_F(RigSolve, GivesTheSameBitsInSlicesOnAnyNumberOfThreads) {
  open("bust", 48, 2);
  if (HasFatalFailure()) return;
  struct Found {
    Image picture;
    double epsilon;
    int evals;
  };
  std::vector<Found> found;
  for (const std::size_t threads : {1U, 7U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const std::chrono::milliseconds slice(threads == 1 ? 1 : 1000 * static_cast<int>(threads));
    LUM_ASSERT_OK(SolveSession session, SolveSession::create(*stage_->renderer, *start_, target_,
                                                             {.seed = 3, .max_evals = 6, .restarts = 1}));
    for (bool more = true; more;) {
      LUM_ASSERT_OK(more, session.run_for(slice));
    }
    LUM_ASSERT_OK(Image picture, stage_->renderer->render(session.best()));
    found.push_back({std::move(picture), session.report().epsilon, session.report().evals});
  }
  for (const Found& other : found) {
    EXPECT_EQ(other.picture.data, found[0].picture.data);
    EXPECT_EQ(other.epsilon, found[0].epsilon);
    EXPECT_EQ(other.evals, found[0].evals);
  }
  EXPECT_GT(found[0].evals, 1);
}

}  // namespace
}  // namespace luminist
