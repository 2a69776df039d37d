// Materials are turned, locked, undone, kept and scripted as what else a session has.
#include <algorithm>
#include <fstream>
#include <functional>

#include "studio/picture_export.h"
#include "studio/scene_export.h"
#include "studio/script.h"
#include "studio/session_fixture.h"
#include "studio/shot_view.h"

namespace luminist {
namespace {

Vec3 tint_of(const ParamState& state, int material) {
  const ParamBlock& params = state.materials.at(static_cast<std::size_t>(material)).params;
  return params.vec3(*params.schema().find("tint"));
}

TEST_F(SessionTest, HasTheMaterialsOfItsSceneLocked) {
  ASSERT_EQ(session_->state().materials.size(), 2U);
  EXPECT_EQ(session_->state().materials[0].name, "clay");
  EXPECT_EQ(session_->state().materials[1].name, "board");
  for (const auto& [path, value] : session_->project().document().entries()) {
    EXPECT_EQ(path.find("materials/"), std::string::npos) << "nothing is kept of what nobody turned: " << path;
  }
  LUM_ASSERT_OK(const int unlocked, session_->set_locked("*", false));
  EXPECT_GT(unlocked, 0);
  const ParamBlock& clay = session_->state().materials[0].params;
  for (int dof = 0; dof < clay.schema().dofs(); ++dof) EXPECT_TRUE(clay.locked(dof)) << "\"*\" is what light can do";
  LUM_ASSERT_OK(const int tints, session_->set_locked("materials/*/tint", false));
  EXPECT_EQ(tints, 6);
}

TEST_F(SessionTest, TurnsAMaterialAndUndoesIt) {
  LUM_EXPECT_OK(session_->set({"ambient/color=0.5,0.5,0.5"}));
  const Image before = picture();
  const std::string hash_before = hash();
  LUM_EXPECT_OK(session_->set({"materials/clay/tint=0.5,1,1"}));
  const Image turned = picture();
  EXPECT_NE(turned.data, before.data);
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), hash_before);
  EXPECT_EQ(picture().data, before.data);
  LUM_EXPECT_OK(session_->redo());
  EXPECT_EQ(picture().data, turned.data);
  LUM_EXPECT_OK(session_->set({"materials/clay/tint=1,1,1"}));
  EXPECT_EQ(picture().data, before.data);
}

TEST_F(SessionTest, AMaterialThatTheSceneLacksIsNamedWithTheNearest) {
  const Error error = error_of(session_->set({"materials/cley/tint=1,1,1"}));
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_NE(error.what.find("no material \"cley\""), std::string::npos) << error.what;
  EXPECT_NE(error.hint.find("clay"), std::string::npos) << error.hint;
  const auto locked = session_->set_locked("materials/jug/tint", false);
  ASSERT_FALSE(locked);
  EXPECT_NE(locked.error().hint.find("clay, board"), std::string::npos) << locked.error().hint;
  const Error param = error_of(session_->set({"materials/clay/shine=1"}));
  EXPECT_NE(param.what.find("no parameter"), std::string::npos) << param.what;
}

TEST_F(SessionTest, KeysAreForLightsNotForMaterials) {
  EXPECT_FALSE(session_->set_keys("materials/clay/tint", KeyInterpolation::kSmooth));
}

TEST_F(SessionTest, MaterialsComeBackWithTheProjectAndWithAnotherStyle) {
  LUM_EXPECT_OK(session_->set({"materials/clay/tint=0.25,0.5,0.75", "materials/board/roughness=0.2"}));
  LUM_ASSERT_OK(const int unlocked, session_->set_locked("materials/clay/roughness", false));
  EXPECT_EQ(unlocked, 1);
  LUM_EXPECT_OK(session_->restyle("toon"));
  EXPECT_EQ(tint_of(session_->state(), 0), Vec3(0.25F, 0.5F, 0.75F));
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "shot.lum"));
  session_.reset();
  session_ = open_project("shot.lum");
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(tint_of(session_->state(), 0), Vec3(0.25F, 0.5F, 0.75F));
  EXPECT_EQ(tint_of(session_->state(), 1), Vec3(1.0F));
  const ParamBlock& board = session_->state().materials[1].params;
  EXPECT_EQ(board.scalar(*board.schema().find("roughness")), 0.2F);
  const ParamBlock& clay = session_->state().materials[0].params;
  EXPECT_FALSE(clay.locked(clay.schema()[*clay.schema().find("roughness")].first_dof));
  EXPECT_TRUE(clay.locked(clay.schema()[*clay.schema().find("tint")].first_dof));
}

TEST_F(SessionTest, TheExportedSceneLooksTheSameByItself) {
  LUM_EXPECT_OK(session_->set({"ambient/color=0.5,0.5,0.5", "materials/clay/tint=0.5,1.1,0.75",
                               "materials/clay/specular=3", "materials/board/roughness=0.2"}));
  const Image turned = picture();
  PictureChoice choice;
  choice.light = choice.paint = choice.rig = false;
  choice.scene = true;
  LUM_ASSERT_OK(const auto written, export_pictures(*session_, choice, folder_.path() / "out"));
  ASSERT_EQ(written.size(), 1U);
  Shot shot = this->shot();
  shot.scene = written.front().string();
  shot.set = {"ambient/color=0.5,0.5,0.5"};
  LUM_ASSERT_OK(const auto other, Session::open(*device_, roots_, shot, folder_.path(), diagnostics_));
  LUM_ASSERT_OK(const Image* again, other->picture());
  float most = 0.0F;
  for (std::size_t i = 0; i < turned.data.size(); ++i) most = std::max(most, std::abs(turned.data[i] - again->data[i]));
  EXPECT_LT(most, 1e-4F);  // single precision, in two orders of operations
  EXPECT_EQ(other->state().materials[0].name, "clay");
  EXPECT_TRUE(turn_of(other->state().materials[0].params).nothing()) << "they are the scene's own now";
}

TEST_F(SessionTest, AScriptTurnsAndFreesMaterials) {
  std::ofstream(folder_.file("actions.jsonl"))
      << R"({"do": "open", "scene": ")" << folder_.file("ball.obj") << R"(", "size": [48, 36]})" << '\n'
      << R"({"do": "set", "path": "materials/clay/tint", "value": "0.5,0.6,0.7"})" << '\n'
      << R"({"do": "unlock", "pattern": "materials/clay/roughness"})" << '\n'
      << R"({"do": "save", "project": "scripted.lum"})" << '\n';
  ScriptEvents events;
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.file("actions.jsonl"), folder_.path(), events, diagnostics_));
  session_ = open_project("scripted.lum", Project::Access::kRead);
  ASSERT_NE(session_, nullptr);
  EXPECT_EQ(tint_of(session_->state(), 0), Vec3(0.5F, 0.6F, 0.7F));
  const ParamBlock& clay = session_->state().materials[0].params;
  EXPECT_FALSE(clay.locked(clay.schema()[*clay.schema().find("roughness")].first_dof));
}

TEST_F(SessionTest, MaterialsAreFoundByNameInASceneThatWasWrittenAgain) {
  LUM_EXPECT_OK(session_->set({"materials/board/tint=0.25,0.5,0.75"}));
  LUM_ASSERT_OK([[maybe_unused]] const int freed, session_->set_locked("materials/board/roughness", false));
  std::string written = ball_obj();
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = written.find(from, at)) != std::string::npos; at += to.size()) {
      written.replace(at, from.size(), to);
    }
  };
  replace("usemtl clay", "usemtl enamel");
  std::ofstream(folder_.file("ball.obj")) << written;
  std::ofstream(folder_.file("ball.mtl"), std::ios::app) << "newmtl enamel\nKd 0.2 0.3 0.4\n";
  for (const auto& look : std::vector<std::function<Result<void>()>>{
           [&] { return session_->restyle("toon"); }, [&] { return session_->view().reframe("", 32, 20); },
           [&] { return session_->restyle("path"); }}) {
    LUM_EXPECT_OK(look());
    LUM_ASSERT_OK([[maybe_unused]] const Image* shown, session_->picture());
    bool found = false;
    for (const MaterialParams& material : session_->state().materials) {
      const Vec3 tint = material.params.vec3(*material.params.schema().find("tint"));
      EXPECT_EQ(tint, material.name == "board" ? Vec3(0.25F, 0.5F, 0.75F) : Vec3(1.0F)) << material.name;
      found = found || material.name == "enamel";
    }
    EXPECT_TRUE(found);
  }
}

TEST_F(SessionTest, AProjectTellsOfMaterialsThatItsSceneHasNoMore) {
  LUM_EXPECT_OK(session_->set({"materials/clay/tint=0.25,0.5,0.75"}));
  LUM_EXPECT_OK(session_->save_as(folder_.path() / "kept.lum"));
  session_.reset();
  std::string written = ball_obj();
  for (std::size_t at = 0; (at = written.find("usemtl clay")) != std::string::npos;)
    written.replace(at, 11, "usemtl board");
  std::ofstream(folder_.file("ball.obj")) << written;
  std::ofstream(folder_.file("ball.mtl")) << "newmtl board\nKd 0.5 0.5 0.5\n";
  session_ = open_project("kept.lum");
  ASSERT_NE(session_, nullptr);
  const auto told = std::ranges::find_if(diagnostics_.warnings(),
                                         [](const auto& warning) { return warning.where == "materials/clay"; });
  EXPECT_NE(told, diagnostics_.warnings().end());
}

}  // namespace
}  // namespace luminist
