// Materials that are unlocked beside the lights come back from a picture that was made with them.
#include "studio/session_fixture.h"

namespace luminist {
namespace {

/// The ball under a small lamp, in some style; its material is "clay", the floor's "board".
class MaterialSolve : public SessionTest {
 protected:
  void open_in(const std::string& style, const std::vector<std::string>& set = {}, int width = 96, int height = 72) {
    std::ofstream(folder_.file("rig.toml"))
        << "[ambient]\ncolor = [0.05, 0.05, 0.05]\n[[light]]\nname = \"key\"\ntype = \"point\"\n"
           "position = [2, 4, 3]\nfalloff_exponent = 0\ncolor = [1, 1, 1]\n";
    Shot shot = this->shot();
    shot.style = style;
    shot.rig = "rig.toml";
    shot.width = width;
    shot.height = height;
    shot.set = set;
    auto session = Session::open(*device_, roots_, shot, folder_.path(), diagnostics_);
    ASSERT_TRUE(session) << session.error().message();
    session_ = std::move(*session);
    LUM_ASSERT_OK(const int locked, session_->set_locked("*", true));
    EXPECT_GT(locked, 0);
  }
  /// The target becomes the picture of the state with these set.
  void want(const std::vector<std::string>& assignments) {
    wanted_ = std::make_unique<ParamState>(session_->state());
    for (const std::string& assignment : assignments) LUM_EXPECT_OK(set_path(*wanted_, assignment));
    LUM_ASSERT_OK(const Image target, session_->stage().renderer->render(*wanted_));
    LUM_EXPECT_OK(session_->set_target(target, std::nullopt));
  }
  void solve(const std::vector<std::string>& free, SolverKind solver = SolverKind::kAuto, int evals = 200,
             double until = 1e-5) {
    LUM_ASSERT_OK(const int count, session_->set_locked(free, false));
    EXPECT_GT(count, 0);
    SolveOptions options;
    options.solver = solver;
    options.max_evals = evals;
    options.until = until;
    LUM_EXPECT_OK(session_->solve(options, nullptr));
  }
  [[nodiscard]] static const ParamBlock& block(const ParamState& state, const std::string& path) {
    const std::vector<std::string> paths = state.block_paths();
    const auto found = std::find(paths.begin(), paths.end(), path);
    EXPECT_NE(found, paths.end()) << path;
    return *state.blocks()[static_cast<std::size_t>(found - paths.begin())];
  }
  void expect_found(const std::string& path, const std::string& name, double tolerance) {
    const ParamBlock& found = block(session_->shown(), path);
    const ParamBlock& wanted = block(*wanted_, path);
    const int param = *found.schema().find(name);
    for (int c = 0; c < found.schema()[param].components(); ++c) {
      EXPECT_NEAR(found.get(param, c), wanted.get(param, c), tolerance) << path << '/' << name << ' ' << c;
    }
  }
  /// Of what is not free every bit stays.
  void expect_put(const std::vector<std::string>& free) {
    const ParamState& now = session_->shown();
    const std::vector<std::string> paths = now.block_paths();
    for (std::size_t b = 0; b < paths.size(); ++b) {
      const ParamBlock& before = *std::as_const(session_->state()).blocks()[b];
      const ParamBlock& after = *now.blocks()[b];
      for (int param = 0; param < before.schema().size(); ++param) {
        const std::string path = paths[b] + '/' + before.schema()[param].name;
        if (std::find(free.begin(), free.end(), path) != free.end()) continue;
        for (int c = 0; c < before.schema()[param].components(); ++c) {
          EXPECT_EQ(before.get(param, c), after.get(param, c)) << path;
        }
      }
    }
  }

  std::unique_ptr<ParamState> wanted_;
};

TEST_F(MaterialSolve, TintRoughnessAndSpecularComeBackInTheCinematicStyle) {
  open_in("cinematic");
  want({"materials/clay/tint=0.5,0.9,1.2", "materials/clay/roughness=0.3", "materials/clay/specular=4"});
  solve({"materials/clay"});
  EXPECT_LT(session_->solved()->report.epsilon, 1e-3 * session_->solved()->report.epsilon_start);
  expect_found("materials/clay", "tint", 0.01);
  expect_found("materials/clay", "roughness", 0.01);
  expect_found("materials/clay", "specular", 0.1);
  expect_put({"materials/clay/tint", "materials/clay/roughness", "materials/clay/specular"});
}

TEST_F(MaterialSolve, ALightAndTheMaterialsUnderItComeBackTogether) {
  open_in("cinematic");
  want({"lights/key/color=0.8,0.7,0.5", "lights/key/position=-1,4.5,3", "materials/clay/tint=0.5,0.9,1.2",
        "materials/clay/roughness=0.35"});
  const std::vector<std::string> free{"lights/key/color", "lights/key/position", "materials/clay/tint",
                                      "materials/clay/roughness"};
  solve(free, SolverKind::kAuto, 200, 1e-4);
  EXPECT_LT(session_->solved()->report.epsilon, 0.01 * session_->solved()->report.epsilon_start);
  expect_found("materials/clay", "tint", 0.05);
  expect_found("materials/clay", "roughness", 0.03);
  expect_found("lights/key", "color", 0.03);
  expect_found("lights/key", "position", 0.15);
  expect_put(free);
}

TEST_F(MaterialSolve, TheSimplexTurnsThemToo) {
  open_in("cinematic", {}, 48, 36);
  want({"materials/clay/tint=0.5,0.9,1.2", "materials/clay/roughness=0.35"});
  solve({"materials/clay/tint", "materials/clay/roughness"}, SolverKind::kSimplex, 400);
  expect_found("materials/clay", "tint", 0.03);
  expect_found("materials/clay", "roughness", 0.05);
}

TEST_F(MaterialSolve, TintComesBackInTheToonStyle) {
  open_in("toon");
  want({"materials/clay/tint=0.5,0.9,1.2", "materials/board/tint=1.3,1.1,0.6"});
  solve({"materials/clay/tint", "materials/board/tint"});
  expect_found("materials/clay", "tint", 0.02);
  expect_found("materials/board", "tint", 0.02);
}

TEST_F(MaterialSolve, TheyComeBackFromAPathTracedPicture) {
  open_in("path", {"style/samples=64", "style/denoise=0"}, 32, 24);
  want({"materials/clay/tint=0.5,0.9,1.2", "materials/clay/roughness=0.35"});
  solve({"materials/clay/tint", "materials/clay/roughness"}, SolverKind::kAuto, 60);
  // The target is of 64 paths a pixel, the search looks along 8: their noise is what is left.
  expect_found("materials/clay", "tint", 0.06);
  expect_found("materials/clay", "roughness", 0.1);
  expect_put({"materials/clay/tint", "materials/clay/roughness"});
}

}  // namespace
}  // namespace luminist
