// A ramp in two dimensions is painted on the picture: its texels come out of a solve.
#include <algorithm>
#include <cmath>

#include "studio/session_fixture.h"

namespace luminist {
namespace {

TEST_F(SessionTest, TexelsOfALitSphereComeBackFromAPictureMadeWithThem) {
  std::ofstream(folder_.file("rig.toml"))
      << "[ambient]\ncolor = [0, 0, 0]\n[[light]]\nname = \"key\"\ntype = \"point\"\n"
         "position = [2, 4, 3]\nfalloff_exponent = 0\ncolor = [1, 1, 1]\n";
  Shot shot = this->shot();
  shot.style = "litsphere";
  shot.rig = "rig.toml";
  shot.set = {"style/painting=0"};
  LUM_ASSERT_OK(const auto session, Session::open(*device_, roots_, shot, folder_.path(), diagnostics_));
  const ParamBlock start = session->state().style;
  const ParamSchema& schema = start.schema();
  std::vector<int> texels;
  for (int param = 0; param < schema.size(); ++param) {
    if (schema[param].role == "color") texels.push_back(param);
  }
  ASSERT_EQ(texels.size(), 12U);

  ParamState wanted = session->state();
  Vec3 color(0.2F, 0.9F, 0.5F);
  for (const int param : texels) {
    color = Vec3(color.z, std::fmod(color.x + 0.37F, 1.2F), std::fmod(color.y + 0.61F, 1.1F));
    wanted.style.set_vec3(param, color);
  }
  LUM_ASSERT_OK(const Image target, session->stage().renderer->render(wanted));
  LUM_EXPECT_OK(session->set_target(target, std::nullopt));
  LUM_ASSERT_OK(const int locked, session->set_locked("*", true));
  EXPECT_GT(locked, 0);
  for (const int param : texels) {
    LUM_ASSERT_OK(const int count, session->set_locked("style/" + schema[param].name, false));
    EXPECT_EQ(count, 3);
  }
  SolveOptions options;
  options.max_evals = 300;
  options.until = 1e-6;
  LUM_EXPECT_OK(session->solve(options, nullptr));
  const SolveReport& report = session->solved()->report;
  EXPECT_LT(report.epsilon, 0.02 * report.epsilon_start) << report.epsilon << " from " << report.epsilon_start;

  // Every texel counts as much as it makes of the picture: of one that is hardly seen any colour will do.
  double wrong = 0.0;
  double whole = 0.0;
  int seen = 0;
  for (const int param : texels) {
    ParamState without = wanted;
    without.style.set_vec3(param, Vec3(0.0F));
    LUM_ASSERT_OK(const Image rest, session->stage().renderer->render(without));
    double share = 0.0;
    for (std::size_t i = 0; i < rest.data.size(); ++i) share += std::abs(target.data[i] - rest.data[i]);
    const Vec3 right = wanted.style.vec3(param);
    wrong += share * static_cast<double>(glm::length(session->shown().style.vec3(param) - right) / glm::length(right));
    whole += share;
    seen += share > 0.0 ? 1 : 0;
  }
  EXPECT_GE(seen, 8);
  EXPECT_LT(wrong, 0.05 * whole) << "an error of 0.02 of the start's, and some texels look alike where they blend";
}

}  // namespace
}  // namespace luminist
