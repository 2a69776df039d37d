#include "studio/exploration_results.h"

#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "studio/light_map.h"
#include "studio/script.h"
#include "studio/session_fixture.h"

namespace luminist {
namespace {

class ExplorationTest : public SessionTest {
 protected:
  /// A key, and a fill that stands where the key does.
  void add_two_lights() {
    for (const char* name : {"key", "fill"}) {
      NewLight light;
      light.name = name;
      light.from_paint = false;
      light.lock_others = false;
      LUM_EXPECT_OK(session_->add_light(light));
    }
    LUM_EXPECT_OK(session_->set({"lights/fill/color=0.1,0.2,0.3"}));
    LUM_EXPECT_OK(session_->set_locked("*", true));
    LUM_EXPECT_OK(session_->set_locked("lights/*/color", false));
  }
  [[nodiscard]] nlohmann::json report(const std::filesystem::path& folder) const {
    const auto text = read_file(folder / "report.json");
    return text ? nlohmann::json::parse(*text, nullptr, false) : nlohmann::json();
  }
};

TEST_F(ExplorationTest, ARemovalIsAProposalAndAcceptingItIsOneCommand) {
  add_two_lights();
  const Image before = picture();
  const std::string start = hash();
  LUM_ASSERT_OK(const RemovalFacts facts, start_removal(*session_, "fill", few_evals()));
  LUM_EXPECT_OK(session_->finish_solve({}));
  ASSERT_TRUE(session_->has_proposal());
  EXPECT_EQ(hash(), start);
  EXPECT_GT(facts.epsilon, 0.0);
  EXPECT_LT(session_->solved()->report.epsilon, 0.05 * facts.epsilon);  // the key does the work of both
  LUM_EXPECT_OK(write_removal(*session_, facts, folder_.path() / "out"));
  EXPECT_EQ(report(folder_.path() / "out")["light"], "fill");
  const std::size_t steps = session_->project().undo_steps();
  LUM_EXPECT_OK(session_->accept());
  EXPECT_EQ(session_->project().undo_steps(), steps + 1);
  ASSERT_EQ(session_->state().rig.lights.size(), 1U);
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(session_->state().rig.lights.size(), 2U);
  EXPECT_EQ(picture().data, before.data);
}

TEST_F(ExplorationTest, AnUnknownLightIsNamedAndNothingChanges) {
  add_two_lights();
  const Error error = error_of(start_removal(*session_, "fil", few_evals()));
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_NE(error.hint.find("fill"), std::string::npos);
  EXPECT_FALSE(session_->has_proposal());
}

TEST_F(ExplorationTest, ADietWritesARigForEachSizeAndOneCanBeTaken) {
  add_two_lights();
  LUM_ASSERT_OK(const Diet diet, find_diet(*session_, {}, {}));
  ASSERT_EQ(diet.steps.size(), 2U);
  LUM_EXPECT_OK(write_diet(*session_, diet, folder_.path() / "out"));
  for (const char* name : {"2_lights/rig.toml", "1_light/rig.toml", "1_light/picture.png", "contact_sheet.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / name)) << name;
  }
  const nlohmann::json json = report(folder_.path() / "out");
  ASSERT_EQ(json["sizes"].size(), 2U);
  EXPECT_EQ(json["chosen"], 1);
  LUM_ASSERT_OK(const LightRig rig, load_rig((folder_.path() / "out/1_light/rig.toml").string(),
                                             session_->stage().types, session_->stage().frame));
  EXPECT_EQ(rig.lights.size(), 1U);
  propose(*session_, diet, diet.chosen);
  LUM_EXPECT_OK(session_->accept());
  EXPECT_EQ(rig_to_toml(session_->state().rig), rig_to_toml(rig));
}

TEST_F(ExplorationTest, AlternativesNeedPaintAndOneCanBeTaken) {
  EXPECT_EQ(error_of(find_alternatives(*session_, {}, {})).kind, ErrorKind::kNothingToDo);
  LUM_EXPECT_OK(session_->paint(light_strokes(), "strokes.json"));
  LUM_EXPECT_OK(session_->add_light({}));
  const std::string start = hash();
  AlternativesOptions options;
  options.count = 2;
  options.tries = 2;
  LUM_ASSERT_OK(const Alternatives found, find_alternatives(*session_, options, {}));
  EXPECT_EQ(hash(), start);
  ASSERT_GE(found.list.size(), 1U);
  LUM_EXPECT_OK(write_alternatives(*session_, found, folder_.path() / "out"));
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out/1/rig.toml"));
  EXPECT_EQ(report(folder_.path() / "out")["alternatives"].size(), found.list.size());
  LUM_EXPECT_OK(propose(*session_, found.list.back()));
  ASSERT_TRUE(session_->has_proposal());
  LUM_ASSERT_OK(const Image wanted, session_->stage().renderer->render(found.list.back().state));
  EXPECT_EQ(picture().data, wanted.data);
  LUM_EXPECT_OK(session_->revert());
  EXPECT_EQ(hash(), start);
  LUM_EXPECT_OK(propose(*session_, found.list.front()));
  LUM_EXPECT_OK(session_->accept());
  LUM_EXPECT_OK(session_->undo());
  EXPECT_EQ(hash(), start);
}

TEST_F(ExplorationTest, TheMapShowsALightWhereItStands) {
  add_two_lights();
  LUM_EXPECT_OK(session_->remove_light("fill"));
  LUM_EXPECT_OK(session_->set({"lights/key/color=1,0,0", "lights/key/direction=0,-1,0"}));
  const SceneFrame frame = session_->stage().frame;
  ParamState state = session_->state();
  Light& key = state.rig.lights[0];
  key.params.set_vec3(*key.params.schema().by_role("position"), frame.center + Vec3(0.0F, 2.0F * frame.radius, 0.0F));
  const std::vector<const LightRig*> rigs = {&state.rig};
  const MapScale scale = map_scale(rigs, frame);
  const SurfaceBuffer& surface = session_->stage().renderer->surface();
  const Image above = light_map(state.rig, surface, scale, MapView::kAbove, 101, 101);
  EXPECT_GT(above.at(50, 50, 0), 0.9F);
  EXPECT_LT(above.at(50, 50, 1), 0.1F);
  const Image side = light_map(state.rig, surface, scale, MapView::kSide, 101, 101);
  EXPECT_GT(side.at(50, 5, 0), 0.9F);  // 0.45 of the picture above its middle
}

TEST_F(ExplorationTest, AScriptLooksFurtherToo) {
  std::ofstream(folder_.file("rig.toml"))
      << "[[light]]\nname = \"key\"\ntype = \"cinematic\"\nunlocked = [\"color\"]\n"
         "[[light]]\nname = \"fill\"\ntype = \"cinematic\"\ncolor = [0.1, 0.2, 0.3]\nunlocked = [\"color\"]\n"
         "[[light]]\nname = \"dark\"\ntype = \"cinematic\"\ncolor = [0, 0, 0]\nunlocked = [\"color\"]\n";
  std::ofstream(folder_.file("script.jsonl"))
      << R"({"do": "open", "scene": "ball.obj", "size": [48, 36], "rig": "rig.toml"}
{"do": "make_up", "light": "fill", "to": "removed"}
{"do": "accept"}
{"do": "diet", "budget": "1%", "to": "diet", "take": true}
{"do": "accept"}
{"do": "paint", "strokes": {"strokes": [{"color": [1, 0.9, 0.8], "points": [[0.6, 0.4]], "diameter": 0.5}]}}
{"do": "alternatives", "count": 2, "tries": 1, "to": "alternatives", "take": 1}
{"do": "accept"}
{"do": "export", "to": "end"}
)";
  const std::filesystem::path out = folder_.path() / "out";
  LUM_EXPECT_OK(run_script(*device_, roots_, folder_.path() / "script.jsonl", out, {}, diagnostics_));
  for (const char* name : {"removed", "diet", "alternatives"}) EXPECT_TRUE(report(out / name).is_object()) << name;
  LUM_ASSERT_OK(const LightRig rig,
                load_rig((out / "end/rig.toml").string(), session_->stage().types, session_->stage().frame));
  ASSERT_EQ(rig.lights.size(), 1U);
  EXPECT_EQ(rig.lights[0].name, "key");
  std::ofstream(folder_.file("wrong.jsonl"))
      << R"({"do": "open", "scene": "ball.obj", "size": [48, 36], "rig": "rig.toml"}
{"do": "diet", "budget": "much"}
)";
  const Error error = error_of(run_script(*device_, roots_, folder_.path() / "wrong.jsonl", out, {}, diagnostics_));
  EXPECT_NE(error.where.find("wrong.jsonl:2"), std::string::npos) << error.message();
}

}  // namespace
}  // namespace luminist
