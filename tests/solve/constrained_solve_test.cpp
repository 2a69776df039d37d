// Solves in which constraints hold (rig/constraint.h).
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "solve/degenerate_problem.h"
#include "solve/fake_renderer.h"
#include "solve/objective.h"
#include "solve/solve_session.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A rig that obeys its constraints, its picture as target, and the same rig with a few values moved away.
class ConstrainedSolveTest : public testing::Test {
 protected:
  ConstrainedSolveTest() {
    for (const char* name : {"key", "fill"}) {
      Light light = hidden_light(renderer_, name, name[0] == 'k' ? 6 : 3);
      light.params.set_param_locked(-1, true);
      wanted_.rig.lights.push_back(std::move(light));
    }
  }
  static Vec3 get(const ParamState& state, const char* light, const char* role) {
    const ParamBlock& params = state.rig.find(light)->params;
    return params.vec3(*params.schema().by_role(role));
  }
  static void put(ParamState& state, const char* light, const char* role, const Vec3& value) {
    ParamBlock& params = state.rig.find(light)->params;
    params.set_vec3(*params.schema().by_role(role), value);
  }
  void unlock(const std::string& pattern) { LUM_EXPECT_OK(set_locked(wanted_, pattern, false)); }
  void constrain(std::vector<Constraint> constraints) {
    wanted_.rig.constraints = std::move(constraints);
    ASSERT_FALSE(find_fault(wanted_.rig));
    keep_constraints(wanted_.rig);
  }
  /// Solves from a start; its constraints hold at the end. returns what was found.
  ParamState recover(const ParamState& start, SolverKind solver, double part, int evals = 600) {
    const Target target = renderer_.target_of(wanted_, start);
    ParamState kept = start;
    keep_constraints(kept.rig);
    const auto before = renderer_.error(kept, target);
    EXPECT_TRUE(before);
    const SolveOptions options{.solver = solver, .until = part * *before, .max_evals = evals};
    auto session = SolveSession::create(renderer_, start, target, options);
    EXPECT_TRUE(session);
    for (bool more = true; more;) {
      const auto step = session->step();
      EXPECT_TRUE(step);
      more = step && *step;
    }
    EXPECT_EQ(session->report().termination, Termination::kTargetReached)
        << session->report().epsilon / session->report().epsilon_start;
    ParamState found = session->best();
    const auto epsilon = renderer_.error(found, target);
    EXPECT_LE(*epsilon, options.until);  // the state itself makes the picture, not one that is bent afterwards
    ParamState again = found;
    keep_constraints(again.rig);
    for (std::size_t i = 0; i < found.rig.lights.size(); ++i) {
      EXPECT_TRUE(found.rig.lights[i].params.same_values(again.rig.lights[i].params)) << found.rig.lights[i].name;
    }
    return found;
  }

  FakeRenderer renderer_{64, 64};
  ParamState wanted_ = renderer_.empty_state();
};

/// The same for both solvers.
class ConstrainedSolvers : public ConstrainedSolveTest, public testing::WithParamInterface<SolverKind> {};

TEST_P(ConstrainedSolvers, ALightIsFoundOnItsPlane) {
  const Plane plane{get(wanted_, "key", "position"), glm::normalize(Vec3(0.2F, -1.0F, 0.1F))};
  constrain({{"key", OnPlane{plane}}});
  unlock("lights/key/position");
  unlock("lights/key/color");
  ParamState start = wanted_;
  put(start, "key", "position", plane.point + Vec3(0.5F, 0.7F, -0.4F));
  put(start, "key", "color", Vec3(0.5F));
  const ParamState found = recover(start, GetParam(), 0.05);
  const Vec3 place = get(found, "key", "position");
  EXPECT_NEAR(glm::dot(place - plane.point, plane.normal), 0.0F, 3e-6F);  // floats of a few units
}

TEST_P(ConstrainedSolvers, ALightIsFoundAtItsDistance) {
  const Vec3 from = renderer_.frame().center;
  const float distance = glm::distance(get(wanted_, "key", "position"), from);
  constrain({{"key", AtDistance{distance, from}}});
  unlock("lights/key/position");
  unlock("lights/key/color");
  ParamState start = wanted_;
  put(start, "key", "position", get(wanted_, "key", "position") + Vec3(0.5F, 0.6F, -0.4F));
  put(start, "key", "color", Vec3(0.5F));
  const ParamState found = recover(start, GetParam(), 0.05);
  EXPECT_NEAR(glm::distance(get(found, "key", "position"), from), distance, 3e-6F);
}

TEST_P(ConstrainedSolvers, TwoMirroredLightsAreFoundByTurningOne) {
  constrain({{"fill", MirrorOf{"key", {Vec3(0.0F), Vec3(1.0F, 0.0F, 0.0F)}}}});
  // What follows stays no degree of freedom.
  for (const char* pattern : {"lights/*/position", "lights/*/direction", "lights/*/color"}) unlock(pattern);
  ParamState start = wanted_;
  const Vec3 way = get(start, "key", "direction");
  put(start, "key", "direction", glm::normalize(way + Vec3(0.1F, 0.1F, -0.05F)));
  put(start, "key", "position", get(start, "key", "position") + Vec3(0.3F, -0.2F, 0.2F));
  put(start, "key", "color", Vec3(0.6F, 0.5F, 0.4F));
  const ParamState found = recover(start, GetParam(), 0.1, 1200);
  EXPECT_EQ(get(found, "fill", "position"), get(found, "key", "position") * Vec3(-1.0F, 1.0F, 1.0F));
  EXPECT_EQ(get(found, "fill", "color"), get(found, "key", "color"));
}

TEST_P(ConstrainedSolvers, OneColourIsFoundForTwoLights) {
  constrain({{"fill", SameColor{"key", 0.5F}}});
  unlock("lights/*/color");
  unlock("lights/fill/barn");
  ParamState start = wanted_;
  put(start, "key", "color", Vec3(0.3F, 1.5F, 0.6F));
  const ParamState found = recover(start, GetParam(), 0.02);
  EXPECT_EQ(get(found, "fill", "color"), 0.5F * get(found, "key", "color"));
  for (int c = 0; c < 3; ++c) {
    // 2 % of the error away from a sharp optimum.
    EXPECT_NEAR(get(found, "key", "color")[c], get(wanted_, "key", "color")[c], 0.05F);
  }
}

INSTANTIATE_TEST_SUITE_P(, ConstrainedSolvers, testing::Values(SolverKind::kFast, SolverKind::kSimplex),
                         [](const auto& each) { return each.param == SolverKind::kFast ? "Fast" : "Simplex"; });

/// Constraints between lights of a rig that can be kept.
std::vector<Constraint> random_constraints(LightRig rig, const SceneFrame& frame, Random& random) {
  const auto name = [&] {
    return rig.lights[static_cast<std::size_t>(random.index(static_cast<int>(rig.lights.size())))].name;
  };
  const Vec3 place = frame.center + frame.radius * random.direction();
  for (int i = 0; i < 4; ++i) {
    const Plane plane{place, random.direction()};
    const std::vector<Constraint> kinds{{name(), OnPlane{plane}},
                                        {name(), AtDistance{static_cast<float>(random.uniform(0.5, 3.0)), place}},
                                        {name(), MirrorOf{name(), plane}},
                                        {name(), SameColor{name(), static_cast<float>(random.uniform(0.0, 2.0))}}};
    rig.constraints.push_back(kinds[static_cast<std::size_t>(random.index(4))]);
    if (find_fault(rig)) rig.constraints.pop_back();
  }
  return rig.constraints;
}

TEST_F(ConstrainedSolveTest, DegenerateProblemsKeepThemAndEndWithNothingWorseThanTheirStart) {
  constexpr std::uint64_t kProblems = fewer_sanitized(300);
  std::array<FakeRenderer, 3> renderers{FakeRenderer(16, 16), FakeRenderer(9, 6, FakeStyle::kToon),
                                        FakeRenderer(8, 8, FakeStyle::kTinted)};
  int constrained = 0;
  for (std::uint64_t seed = 0; seed < kProblems; ++seed) {
    FakeRenderer& renderer = renderers[seed % 3];
    LUM_ASSERT_OK(DegenerateProblem problem,
                  degenerate_problem(renderer, renderer.empty_state(), renderer.cinematic("light"), seed));
    LightRig& rig = problem.start.rig;
    if (rig.lights.empty()) continue;
    Random random(seed);
    rig.constraints = random_constraints(rig, renderer.frame(), random);
    constrained += rig.constraints.empty() ? 0 : 1;
    auto session = SolveSession::create(renderer, problem.start, problem.target, problem.options);
    if (!session) continue;  // everything is locked or follows, or nothing counts
    for (int step = 0; step < problem.steps; ++step) {
      LUM_ASSERT_OK(const bool more, session->step());
      if (!more) break;
    }
    session->stop();
    EXPECT_LE(session->report().epsilon, session->report().epsilon_start) << seed;
    ParamState again = session->best();
    keep_constraints(again.rig);
    for (std::size_t i = 0; i < again.rig.lights.size(); ++i) {
      EXPECT_TRUE(again.rig.lights[i].params.same_values(session->best().rig.lights[i].params)) << seed << problem.what;
    }
  }
  EXPECT_GT(constrained, static_cast<int>(kProblems / 2));
}

TEST_F(ConstrainedSolveTest, EveryStateOfAnObjectiveKeepsThem) {
  constrain(
      {{"fill", MirrorOf{"key", {Vec3(0.0F), Vec3(1.0F, 0.0F, 0.0F)}}}, {"key", OnPlane{{Vec3(0.0F, 3.0F, 0.0F)}}}});
  unlock("lights/*");
  const Target target = renderer_.target_of(wanted_, wanted_);
  const Objective objective(renderer_, wanted_, target);
  EXPECT_EQ(objective.dofs(), 18);
  std::vector<double> x(18, 0.7);
  const ParamState state = objective.state(x);
  EXPECT_EQ(get(state, "key", "position").y, 3.0F);
  EXPECT_EQ(get(state, "fill", "position").x, -get(state, "key", "position").x);
}

}  // namespace
}  // namespace luminist
