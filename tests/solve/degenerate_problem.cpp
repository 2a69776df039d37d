#include "solve/degenerate_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

void note(std::string& what, const char* word) {
  what += (what.empty() ? "" : ", ") + std::string(word);
}

Vec3 odd_place(const SurfaceBuffer& surface, const SceneFrame& frame, Random& random, std::string& what) {
  const std::size_t pixel = static_cast<std::size_t>(random.index(static_cast<int>(surface.pixels())));
  const Vec3 point = surface.position[pixel];
  const Vec3 normal = surface.normal[pixel];
  switch (random.index(7)) {
    case 0:
      note(what, "inside what is seen");
      return point - 0.3F * frame.radius * normal;
    case 1:
      note(what, "at a surface");
      return point;
    case 2:
      note(what, "just above a surface");
      return point + 1e-5F * normal;
    case 3:
      note(what, "behind the wall");
      return frame.center + Vec3(0.0F, 0.0F, -3.0F * frame.radius);
    case 4:
      note(what, "below the floor");
      return frame.center + Vec3(0.0F, -3.0F * frame.radius, 0.0F);
    case 5:
      note(what, "at the eye");
      return surface.eye;
    default:
      note(what, "far away");
      return frame.center + 1e5F * frame.radius * random.direction();
  }
}

/// Values at the ends of their ranges or far beyond; directions stay unit.
void odd_values(ParamBlock& params, const SceneFrame& frame, Random& random) {
  for (int p = 0; p < params.schema().size(); ++p) {
    const ParamSpec& spec = params.schema()[p];
    if (spec.type == ParamType::kDirection) {
      params.set_vec3(p, random.direction());
      continue;
    }
    if (spec.dofs() == 0 || random.uniform() < 0.5) continue;
    for (int c = 0; c < spec.components(); ++c) {
      const auto component = static_cast<std::size_t>(c);
      const double low = spec.stored(c, spec.range_min[component], frame);
      const double high = spec.stored(c, spec.range_max[component], frame);
      const double beyond = random.uniform() < 0.2 ? 3.0 : 0.0;
      params.set(p, c, random.uniform() < 0.5 ? low - beyond * (high - low) : high + beyond * (high - low));
    }
  }
}

void random_locks(ParamState& state, Random& random) {
  const double share = random.uniform();
  for (ParamBlock* block : state.blocks()) {
    for (int dof = 0; dof < block->schema().dofs(); ++dof) block->set_locked(dof, random.uniform() < share);
  }
  state.rig.ambient.set_locked(0, false);  // one is left
}

bool finite(const ParamState& state) {
  for (const ParamBlock* block : state.blocks()) {
    for (int p = 0; p < block->schema().size(); ++p) {
      for (int c = 0; c < block->schema()[p].components(); ++c) {
        if (!std::isfinite(block->get(p, c))) return false;
      }
    }
  }
  return true;
}

double out_of_range(const ParamState& state, const SceneFrame& frame) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  return penalty(UnitMap::create(blocks, frame).to_unit(blocks));
}

}  // namespace

ParamState degenerate_lights(const ParamState& empty, const Light& prototype, const SurfaceBuffer& surface,
                             const SceneFrame& frame, Random& random, std::string& what) {
  ParamState state = empty;
  const int count = random.index(4);
  if (count == 0) note(what, "no lights");
  for (int i = 0; i < count; ++i) {
    Light light = prototype;
    light.name = "light" + std::to_string(i);
    if (i > 0 && random.uniform() < 0.2) {
      note(what, "doubled");
      light.params = state.rig.lights.back().params;
    } else {
      const int position = *light.params.schema().by_role("position");
      light.params.set_vec3(*light.params.schema().by_role("direction"), random.direction());
      if (random.uniform() < 0.5) odd_values(light.params, frame, random);
      if (random.uniform() < 0.7) light.params.set_vec3(position, odd_place(surface, frame, random, what));
    }
    if (random.uniform() < 0.2) {
      note(what, "dark");
      light.params.set_vec3(*light.params.schema().by_role("color"), Vec3(0.0F));
    }
    light.muted = random.uniform() < 0.15;
    state.rig.lights.push_back(std::move(light));
  }
  if (count > 0 && random.uniform() < 0.2) {
    note(what, "shared shadow");
    state.rig.shadow_light = "light0";
  }
  random_locks(state, random);
  return state;
}

void degenerate_paint(Target& target, Random& random, std::string& what) {
  const int kind = random.index(6);
  constexpr const char* kWords[] = {"no paint", "stripes", "noise", "far too bright", "negative", "black"};
  note(what, kWords[kind]);
  for (std::size_t i = 0; i < target.color.pixels(); ++i) {
    const auto grey = static_cast<float>(random.uniform(0.0, 2.0));
    const Vec3 paint[] = {
        target.color.rgb(i), Vec3(i % 2 == 0 ? 1.0F : 0.0F), Vec3(grey, 1.0F, 2.0F - grey), Vec3(1e6F), Vec3(-grey),
        Vec3(0.0F)};
    target.color.set_rgb(i, paint[kind]);
  }
  const double nowhere = random.uniform() < 0.3 ? 0.98 : random.uniform();
  const bool nothing = random.uniform() < 0.03;
  for (float& value : target.importance.data) value = nothing || random.uniform() < nowhere ? 0.0F : 1.0F;
  if (random.uniform() < 0.3) {
    note(what, "not finite");
    const double share = random.uniform() < 0.2 ? 1.0 : 0.1;
    for (std::vector<float>* data : {&target.color.data, &target.before.data, &target.importance.data}) {
      for (float& value : *data) {
        if (random.uniform() < share) value = random.uniform() < 0.5 ? kNan : kInfinity;
      }
    }
  }
  if (random.uniform() < 0.1) {
    for (float& value : target.importance.data) value = random.uniform() < 0.5 ? -1.0F : value;
  }
}

Result<DegenerateProblem> degenerate_problem(Renderer& renderer, const ParamState& empty, const Light& prototype,
                                             std::uint64_t seed) {
  Random random(seed * 0x9E3779B9ULL + 11);
  DegenerateProblem problem{empty, {}, {}, 0, {}};
  problem.start = degenerate_lights(empty, prototype, renderer.surface(), renderer.frame(), random, problem.what);
  if (random.uniform() < 0.2) odd_values(problem.start.style, renderer.frame(), random);
  LUM_TRY(problem.target.color, renderer.render(problem.start, {}));
  problem.target.before = problem.target.color;
  problem.target.importance = Image(problem.target.color.width, problem.target.color.height, 1, 1.0F);
  problem.target.stroke.assign(problem.target.color.pixels(), 0);
  degenerate_paint(problem.target, random, problem.what);
  problem.all_locked = random.uniform() < 0.03;
  if (problem.all_locked) {
    for (ParamBlock* block : problem.start.blocks()) block->set_param_locked(-1, true);
  }
  const SolverKind kinds[] = {SolverKind::kAuto, SolverKind::kFast, SolverKind::kSimplex};
  problem.options.solver = kinds[random.index(3)];
  problem.options.seed = random.bits();
  problem.options.until = random.uniform() < 0.2 ? random.uniform() : 0.0;
  problem.options.max_evals = random.uniform() < 0.5 ? 1 + random.index(30) : 200;
  problem.options.restarts = random.index(3) - 1;
  problem.steps = random.uniform() < 0.1 ? 400 : random.index(50);
  return problem;
}

bool counts_somewhere(const SurfaceBuffer& surface, Target target) {
  sanitize(target);
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] != 0 && target.importance.data[i] > 0.0F) return true;
  }
  return false;
}

void expect_sound(Renderer& renderer, const SolveSession& session, const DegenerateProblem& problem) {
  const SolveReport& report = session.report();
  EXPECT_NE(report.termination, Termination::kRunning);
  EXPECT_LE(report.evals, problem.options.max_evals);
  EXPECT_TRUE(std::isfinite(report.render_equivalents) && std::isfinite(report.seconds));
  EXPECT_TRUE(finite(session.best()));
  if (report.evals == 0) return;  // stopped before anything was compared: the start is the best
  EXPECT_TRUE(std::isfinite(report.epsilon_start) && std::isfinite(report.epsilon));
  EXPECT_GE(report.epsilon, 0.0);
  EXPECT_LE(report.epsilon, report.epsilon_start);
  EXPECT_EQ(report.convergence.back().epsilon, report.epsilon);
  Target clean = problem.target;
  sanitize(clean);
  LUM_ASSERT_OK(const double error, renderer.error(session.best(), clean));
  EXPECT_LE(error, report.epsilon * (1.0 + 1e-6) + 1e-6);  // which has the penalty on top; engines sum in floats
  // Leaving the ranges costs what epsilon has on top: nothing is farther out than that; values are floats.
  const double out = out_of_range(session.best(), renderer.frame());
  EXPECT_LE(out, report.epsilon * (1.0 + 1e-5) + 1e-4);
  if (report.solver == "fast" && report.epsilon < report.epsilon_start) {
    EXPECT_LE(out, 1e-3);  // whatever it finds lies in the ranges; to the rounding of floats
  }
}

void solve_degenerate(Renderer& renderer, const DegenerateProblem& problem) {
  auto session = SolveSession::create(renderer, problem.start, problem.target, problem.options);
  const bool solvable = !problem.all_locked && counts_somewhere(renderer.surface(), problem.target);
  ASSERT_EQ(session.has_value(), solvable);
  if (!session) {
    EXPECT_EQ(session.error().kind, ErrorKind::kNothingToDo);
    return;
  }
  for (int step = 0; step < problem.steps; ++step) {
    LUM_ASSERT_OK(const bool more, session->step());
    if (!more) break;
  }
  session->stop();
  expect_sound(renderer, *session, problem);
}

}  // namespace luminist
