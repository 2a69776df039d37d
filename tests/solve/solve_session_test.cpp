#include "solve/solve_session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/metric.h"
#include "solve/fake_renderer.h"
#include "solve/random.h"
#include "solve/start_light.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A start and what is wanted of it.
struct Task {
  ParamState start;
  Target target;
};

/// A hidden light, painted where it shows, and the light of section 5.2 with all 18 degrees of freedom.
Task new_light_task(FakeRenderer& renderer, std::uint64_t seed) {
  Task task{renderer.empty_state(), {}};
  ParamState wanted = task.start;
  wanted.rig.lights.push_back(hidden_light(renderer, "hidden", seed));
  task.target = renderer.target_of(wanted, task.start);
  const std::vector<float> painted = lightening(renderer.surface(), task.target);
  for (std::size_t i = 0; i < painted.size(); ++i) {
    task.target.importance.data[i] = painted[i] > 0.0F ? 1.0F : 0.1F;
    task.target.stroke[i] = painted[i] > 0.0F ? 1 : 0;
  }
  task.start.rig.lights.push_back(renderer.cinematic("new"));
  const auto start = estimate_start_light(renderer.surface(), task.target, renderer.frame());
  if (start) apply_start_light(*start, task.start.rig.lights[0]);
  return task;
}

SolveReport run(SolveSession& session) {
  while (true) {
    const auto more = session.step();
    EXPECT_TRUE(more.has_value());
    if (!more || !*more) break;
  }
  return session.report();
}

void lock_all(ParamState& state) {
  for (ParamBlock* block : state.blocks()) block->set_param_locked(-1, true);
}

std::vector<double> values(const ParamState& state) {
  std::vector<double> all;
  for (const ParamBlock* block : state.blocks()) {
    for (int p = 0; p < block->schema().size(); ++p) {
      for (int c = 0; c < block->schema()[p].components(); ++c) all.push_back(block->get(p, c));
    }
  }
  return all;
}

TEST(SolveSession, RecoversHiddenLightsOfEighteenDegreesOfFreedom) {
  FakeRenderer renderer(96, 96);
  int found = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Task task = new_light_task(renderer, seed);
    LUM_ASSERT_OK(const double start, renderer.error(task.start, task.target));
    SolveOptions options{.solver = SolverKind::kFast, .seed = seed, .until = 0.05 * start};
    LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, options));
    const SolveReport report = run(session);
    EXPECT_DOUBLE_EQ(report.epsilon_start, start);
    EXPECT_EQ(report.termination == Termination::kTargetReached, report.epsilon <= options.until);
    found += report.epsilon <= options.until ? 1 : 0;
  }
  EXPECT_GE(found, 11);  // of 12; one may end in a local minimum
}

TEST(SolveSession, ShowsWhatItsFirstDescentsFindBeforeItLooksFurther) {
  FakeRenderer renderer(48, 48);
  Task task{renderer.empty_state(), {}};
  ParamState wanted = task.start;
  for (const std::uint64_t seed : {1U, 2U}) {
    task.start.rig.lights.push_back(hidden_light(renderer, "light " + std::to_string(seed), seed));
    wanted.rig.lights.push_back(hidden_light(renderer, "light " + std::to_string(seed), seed + 10));
  }
  task.target = renderer.target_of(wanted, task.start);
  for (std::size_t i = 0; i < task.target.color.data.size(); i += 2) task.target.color.data[i] += 0.2F;  // by no light
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, {.restarts = 0}));
  const SolveReport report = run(session);
  const auto better = std::find_if(report.convergence.begin(), report.convergence.end(),
                                   [&](const auto& point) { return point.epsilon < report.epsilon_start; });
  ASSERT_NE(better, report.convergence.end());
  EXPECT_LT(better->render_equivalents, report.render_equivalents / 3.0);
}

TEST(SolveSession, TheSimplexRecoversColourAndDirection) {
  FakeRenderer renderer(48, 48);
  Task task{renderer.empty_state(), {}};
  task.start.rig.lights.push_back(hidden_light(renderer, "spot", 6));
  const ParamState wanted = task.start;
  ParamBlock& light = task.start.rig.lights[0].params;
  const int color = *light.schema().by_role("color");
  const int direction = *light.schema().by_role("direction");
  lock_all(task.start);
  light.set_param_locked(color, false);
  light.set_param_locked(direction, false);
  light.set_vec3(color, Vec3(0.3F, 1.5F, 0.6F));
  light.set_vec3(direction, glm::normalize(light.vec3(direction) + Vec3(0.15F, 0.1F, -0.1F)));
  task.target = renderer.target_of(wanted, task.start);
  LUM_ASSERT_OK(const double start, renderer.error(task.start, task.target));
  const SolveOptions options{.solver = SolverKind::kSimplex, .until = 0.05 * start, .max_evals = 400};
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, options));
  const SolveReport report = run(session);
  EXPECT_EQ(report.termination, Termination::kTargetReached);
  EXPECT_EQ(report.solver, "simplex");
  EXPECT_DOUBLE_EQ(report.render_equivalents, static_cast<double>(report.evals));  // one picture each, one light
}

TEST(SolveSession, MovesAShadowThatGaussNewtonAloneDoesNotSee) {
  FakeRenderer renderer(96, 96);
  Task task{renderer.empty_state(), {}};
  Light spot = renderer.cinematic("key");
  const int position = *spot.params.schema().by_role("position");
  const int direction = *spot.params.schema().by_role("direction");
  spot.params.set_vec3(position, Vec3(3.0F, 4.0F, 3.0F));
  spot.params.set_vec3(direction, glm::normalize(Vec3(0.0F, 0.5F, 0.0F) - Vec3(3.0F, 4.0F, 3.0F)));
  spot.params.set_vec3(*spot.params.schema().by_role("shape"), Vec3(1.2F, 1.2F, 0.1F));
  task.start.rig.lights.push_back(spot);
  lock_all(task.start);
  task.start.rig.lights[0].params.set_param_locked(position, false);
  ParamState wanted = task.start;
  wanted.rig.lights[0].params.set_vec3(position, Vec3(2.0F, 4.5F, 3.4F));
  task.target = renderer.target_of(wanted, task.start);
  LUM_ASSERT_OK(const double start, renderer.error(task.start, task.target));
  const SolveOptions options{.until = 0.05 * start};
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, options));
  EXPECT_EQ(run(session).termination, Termination::kTargetReached);
}

TEST(SolveSession, SolvesStylesThatEvaluateAllLightsTogether) {
  FakeRenderer renderer(96, 96, FakeStyle::kToon);
  Task task{renderer.empty_state(), {}};
  task.start.rig.lights.push_back(hidden_light(renderer, "spot", 6));
  const ParamState wanted = task.start;
  ParamBlock& light = task.start.rig.lights[0].params;
  lock_all(task.start);
  light.set_param_locked(*light.schema().by_role("color"), false);
  light.set_param_locked(*light.schema().by_role("position"), false);
  task.start.style.set_locked(1, false);
  light.set_vec3(*light.schema().by_role("color"), Vec3(0.6F));
  light.set_vec3(*light.schema().by_role("position"),
                 light.vec3(*light.schema().by_role("position")) + Vec3(0.6F, 0.2F, 0.0F));
  task.start.style.set(1, 0, 0.5);
  task.target = renderer.target_of(wanted, task.start);
  LUM_ASSERT_OK(const double start, renderer.error(task.start, task.target));
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, {.until = 0.1 * start}));
  EXPECT_EQ(run(session).termination, Termination::kTargetReached);
}

TEST(SolveSession, FindsTheLightAndTheColoursOfAStyleWithBands) {
  FakeRenderer renderer(96, 96, FakeStyle::kTwoTone);
  int found = 0;
  constexpr int kRuns = 5;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    ParamState wanted = renderer.empty_state();
    wanted.rig.lights.push_back(hidden_light(renderer, "hidden", seed));
    ParamBlock& light = wanted.rig.lights[0].params;
    light.set_param_locked(-1, true);
    for (const char* role : {"position", "direction", "color"}) {
      light.set_param_locked(*light.schema().by_role(role), false);
    }
    ParamState start = wanted;
    ParamBlock& moved = start.rig.lights[0].params;
    const int position = *moved.schema().by_role("position");
    moved.set_vec3(position, moved.vec3(position) + Vec3(0.5F, 0.3F, -0.4F));
    const int bright = *start.style.schema().find("bright");
    const int shade = *start.style.schema().find("shade");
    start.style.set_vec3(bright, Vec3(0.4F, 1.5F, 0.7F));
    start.style.set_vec3(shade, Vec3(0.6F, 0.1F, 0.9F));
    const Target target = renderer.target_of(wanted, start);
    LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, start, target, {.seed = seed}));
    const SolveReport report = run(session);
    // What the threshold leaves at the edges of bands, a pixel here and there, is a few percent of the start's error.
    found += report.epsilon < 0.05 * report.epsilon_start ? 1 : 0;
  }
  EXPECT_GE(found, kRuns - 1);  // some lights fall into another minimum
}

TEST(SolveSession, IsNeverWorseThanItsStartOnRandomProblems) {
  FakeRenderer renderer(20, 20);
  Random random(77);
  for (std::uint64_t seed = 0; seed < fewer_sanitized(60); ++seed) {
    Task task{renderer.empty_state(), {}};
    task.start.rig.lights.push_back(hidden_light(renderer, "a", seed));
    if (seed % 3 == 0) task.start.rig.lights.push_back(hidden_light(renderer, "b", seed + 1000));
    for (ParamBlock* block : task.start.blocks()) {
      for (int dof = 0; dof < block->schema().dofs(); ++dof) block->set_locked(dof, random.uniform() < 0.6);
    }
    if (seed % 7 == 0) {  // inside a sphere, or far out of its range
      const Vec3 place = seed % 2 == 0 ? Vec3(-0.9F, 0.6F, 0.0F) : Vec3(0.0F, -40.0F, 0.0F);
      task.start.rig.lights[0].params.set_vec3(0, place);
    }
    task.start.rig.ambient.set_locked(0, false);  // something is always free
    task.target = renderer.target_of(task.start, renderer.empty_state());
    for (float& value : task.target.color.data) {  // contradictory paint, some of it no number
      value = static_cast<float>(random.uniform(-0.5, 2.0));
      if (random.uniform() < 0.01) value = std::nanf("");
    }
    for (float& value : task.target.importance.data) value = random.uniform() < 0.5 ? 0.0F : 1.0F;
    const SolverKind kind = seed % 4 == 0 ? SolverKind::kSimplex : SolverKind::kAuto;
    const SolveOptions options{.solver = kind, .seed = seed, .max_evals = 40, .restarts = seed % 5 == 0 ? 1 : 0};
    LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, options));
    const SolveReport report = run(session);
    EXPECT_NE(report.termination, Termination::kRunning);
    EXPECT_LE(report.epsilon, report.epsilon_start) << seed;
    Target clean = task.target;
    sanitize(clean);
    LUM_ASSERT_OK(const double error, renderer.error(session.best(), clean));
    EXPECT_NEAR(error, report.error(), 1e-9 * (1.0 + report.epsilon)) << seed;
    LUM_ASSERT_OK(const double before, renderer.error(task.start, clean));
    EXPECT_NEAR(before, report.error_start(), 1e-9 * (1.0 + report.epsilon_start)) << seed;
  }
}

TEST(SolveSession, ComparesWhatItFoundEvenWhereNoVariantOfAParameterShows) {
  FakeRenderer renderer(64, 64);
  ParamState wanted = renderer.empty_state();
  wanted.rig.lights.push_back(hidden_light(renderer, "key", 3));
  const int ambient = *wanted.rig.ambient.schema().by_role("color");
  ParamState start = wanted;
  start.rig.ambient.set_vec3(ambient, Vec3(0.3F));
  lock_all(start);
  start.rig.ambient.set_param_locked(ambient, false);
  start.rig.lights[0].params.set_param_locked(*start.rig.lights[0].params.schema().by_role("color"), false);
  Target target = renderer.target_of(wanted, start);
  std::fill(target.importance.data.begin(), target.importance.data.end(), 1.0F);
  // Every third column asks for what no light can do, so that the descent stays far from the target.
  for (std::size_t i = 0; i < target.color.pixels(); i += 3) target.color.set_rgb(i, target.color.rgb(i) + Vec3(0.4F));
  SolveOptions options{.solver = SolverKind::kFast, .seed = 1};
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, start, target, options));
  const SolveReport report = run(session);
  EXPECT_GE(report.evals, 2);
  EXPECT_LT(report.epsilon, 0.8 * report.epsilon_start);
}

TEST(SolveSession, StoppedHalfWayItKeepsTheBest) {
  FakeRenderer renderer(64, 64);
  const Task task = new_light_task(renderer, 3);
  for (const SolverKind kind : {SolverKind::kFast, SolverKind::kSimplex}) {
    LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, {.solver = kind}));
    const int enough = kind == SolverKind::kFast ? 1 : 60;  // pictures: the start's, or a simplex's worth
    while (session.report().evals < enough) {
      LUM_ASSERT_OK([[maybe_unused]] const bool goes_on, session.step());
    }
    session.stop();
    LUM_ASSERT_OK(const bool more, session.step());
    EXPECT_FALSE(more);
    EXPECT_EQ(session.report().termination, Termination::kStopped);
    EXPECT_LE(session.report().epsilon, session.report().epsilon_start);
    LUM_ASSERT_OK(const double error, renderer.error(session.best(), task.target));
    EXPECT_NEAR(error, session.report().error(), 1e-9);
  }
}

TEST(SolveSession, GivesTheSameBitsForTheSameSeed) {
  std::vector<std::vector<double>> results;
  for (int i = 0; i < 2; ++i) {
    FakeRenderer renderer(64, 64);
    const Task task = new_light_task(renderer, 5);
    LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, {.seed = 4}));
    // Slices of time pause a solve and decide nothing in it.
    for (bool more = true; more;) {
      LUM_ASSERT_OK(more, session.run_for(std::chrono::milliseconds(i == 0 ? 1 : 50)));
    }
    results.push_back(values(session.best()));
    results.back().push_back(session.report().epsilon);
    results.back().push_back(session.report().evals);
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(SolveSession, ItsConvergenceOnlyFallsAndEndsAtTheReport) {
  FakeRenderer renderer(64, 64);
  const Task task = new_light_task(renderer, 2);
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, {}));
  const SolveReport report = run(session);
  ASSERT_GE(report.convergence.size(), 2U);
  EXPECT_EQ(report.convergence.front().epsilon, report.epsilon_start);
  EXPECT_EQ(report.convergence.back().epsilon, report.epsilon);
  for (std::size_t i = 1; i < report.convergence.size(); ++i) {
    EXPECT_LT(report.convergence[i].epsilon, report.convergence[i - 1].epsilon);
    EXPECT_GT(report.convergence[i].render_equivalents, report.convergence[i - 1].render_equivalents);
  }
}

TEST(SolveSession, ComesBackIntoTheRanges) {
  FakeRenderer renderer(48, 48);
  Task task = new_light_task(renderer, 6);
  ParamBlock& light = task.start.rig.lights[0].params;
  light.set(*light.schema().by_role("color"), 1, 9.0);
  light.set(*light.schema().by_role("shape"), 2, -0.5);
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, {}));
  run(session);
  const std::vector<const ParamBlock*> blocks = session.best().blocks();
  const UnitMap map = UnitMap::create(blocks, renderer.frame());
  EXPECT_NEAR(penalty(map.to_unit(blocks)), 0.0, 1e-4);  // values are floats
}

TEST(SolveSession, SaysWhenEverythingIsLocked) {
  FakeRenderer renderer(16, 16);
  Task task = new_light_task(renderer, 1);
  lock_all(task.start);
  const Error error = error_of(SolveSession::create(renderer, task.start, task.target, {}));
  EXPECT_EQ(error.kind, ErrorKind::kNothingToDo);
  EXPECT_NE(error.field.find("lights/new"), std::string::npos);
}

TEST(SolveSession, SaysWhenNothingCounts) {
  FakeRenderer renderer(16, 16);
  Task task = new_light_task(renderer, 1);
  for (float& importance : task.target.importance.data) importance = 0.0F;
  const Error error = error_of(SolveSession::create(renderer, task.start, task.target, {}));
  EXPECT_EQ(error.kind, ErrorKind::kNothingToDo);
  EXPECT_NE(error.what.find("nothing counts"), std::string::npos);
}

TEST(SolveSession, ATargetThatIsAlreadyThereIsReachedAtOnce) {
  FakeRenderer renderer(32, 32);
  Task task = new_light_task(renderer, 1);
  task.target = renderer.target_of(task.start, task.start);
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, {}));
  const SolveReport report = run(session);
  EXPECT_EQ(report.epsilon, 0.0);
  EXPECT_EQ(report.termination, Termination::kTargetReached);
  EXPECT_EQ(report.evals, 1);
}

TEST(SolveSession, StopsAtItsLimitOfPictures) {
  FakeRenderer renderer(32, 32);
  const Task task = new_light_task(renderer, 1);
  const SolveOptions options{.solver = SolverKind::kSimplex, .max_evals = 30};
  LUM_ASSERT_OK(SolveSession session, SolveSession::create(renderer, task.start, task.target, options));
  const SolveReport report = run(session);
  EXPECT_EQ(report.termination, Termination::kEvalLimit);
  EXPECT_EQ(report.evals, 30);
}

}  // namespace
}  // namespace luminist
