#include "project/state_document.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "support/fixtures.h"

namespace luminist {
namespace {

class StateDocument : public testing::Test {
 protected:
  void SetUp() override {
    const AssetRoots roots = AssetRoots::standard();
    LUM_ASSERT_OK(types_, LightTypes::load(roots));
    LUM_ASSERT_OK(style_, load_style(roots, "toon"));
  }

  /// Two lights with random values and locks.
  ParamState random_state(unsigned seed) {
    std::mt19937 random(seed);
    ParamState state = initial_state(types_, style_, frame_);
    for (const char* type : {"cinematic", "point"}) {
      auto light = make_light(types_, type, std::string("my ") + type, frame_);
      EXPECT_TRUE(light);
      if (!light) continue;
      state.rig.lights.push_back(*light);
    }
    state.rig.lights[0].group = "fill";
    state.rig.lights[1].muted = true;
    state.rig.lights[1].objects = {"head", "wing_*"};
    state.rig.shadow_light = "my point";
    for (ParamBlock* block : state.blocks()) {
      for (int param = 0; param < block->schema().size(); ++param) {
        if (block->schema()[param].dofs() == 0) continue;
        for (int component = 0; component < block->schema()[param].components(); ++component) {
          block->set(param, component, std::uniform_real_distribution<double>(-2.0, 2.0)(random));
        }
      }
      for (int dof = 0; dof < block->schema().dofs(); ++dof) block->set_locked(dof, random() % 2 == 0);
    }
    return state;
  }

  LightTypes types_;
  Style style_;
  SceneFrame frame_{Vec3(1.0F, 2.0F, 3.0F), 2.5F};
};

TEST_F(StateDocument, KeepsEveryBitAndEveryLock) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const ParamState written = random_state(seed);
    Document document;
    write_state(written, document);
    LUM_ASSERT_OK(const ParamState read, read_state(document, types_, style_, frame_));
    const auto blocks = written.blocks();
    const auto read_blocks = read.blocks();
    ASSERT_EQ(blocks.size(), read_blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      EXPECT_TRUE(blocks[i]->same_values(*read_blocks[i])) << i;
      for (int dof = 0; dof < blocks[i]->schema().dofs(); ++dof) {
        EXPECT_EQ(blocks[i]->locked(dof), read_blocks[i]->locked(dof));
      }
    }
    EXPECT_EQ(read.rig.lights[0].group, "fill");
    EXPECT_TRUE(read.rig.lights[1].muted);
    EXPECT_TRUE(read.rig.lights[0].objects.empty());
    EXPECT_EQ(read.rig.lights[1].objects, written.rig.lights[1].objects);
    EXPECT_EQ(read.rig.shadow_light, "my point");
  }
}

TEST_F(StateDocument, KeepsOfMaterialsOnlyWhatIsNotAsTheSceneHasIt) {
  LUM_ASSERT_OK(const auto schema, load_material_schema(AssetRoots::standard()));
  Material jug;
  jug.name = "jug";
  jug.roughness = 0.3F;
  const std::vector<MaterialParams> own = material_params({jug, Material{}}, *schema);
  ParamState state = random_state(5);
  Document without;
  write_state(state, without);
  state.materials = own;
  Document document;
  write_state(state, document);
  EXPECT_EQ(document.hash(), without.hash());

  LUM_EXPECT_OK(set_path(state, "materials/jug/tint=0.1,0.2,0.30000001"));
  LUM_ASSERT_OK(const int freed, set_locked(state, "materials/material/roughness", false));
  EXPECT_EQ(freed, 1);
  write_state(state, document);
  EXPECT_TRUE(document.has("materials/jug/tint"));
  EXPECT_FALSE(document.has("materials/jug/roughness"));
  EXPECT_TRUE(document.has("locks/materials/material/roughness"));
  LUM_ASSERT_OK(const ParamState read, read_state(document, types_, style_, frame_, own));
  ASSERT_EQ(read.materials.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(read.materials[i].params.same_values(state.materials[i].params));
    for (int dof = 0; dof < 5; ++dof) {
      EXPECT_EQ(read.materials[i].params.locked(dof), state.materials[i].params.locked(dof));
    }
  }
  state.materials = own;
  write_state(state, document);
  EXPECT_EQ(document.hash(), without.hash()) << "what is taken back leaves nothing";

  document.set("materials/jug/tint", "\"red\"");
  const auto broken = read_state(document, types_, style_, frame_, own);
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().field, "materials/jug/tint");
}

TEST_F(StateDocument, RefusesLinksThatAreNoListOfNames) {
  for (const char* value : {"3", "[1]", "{}", "\"head\"", "oops"}) {
    Document document;
    write_state(random_state(1), document);
    document.set("lights/my point/@objects", value);
    const auto read = read_state(document, types_, style_, frame_);
    ASSERT_FALSE(read) << value;
    EXPECT_EQ(read.error().field, "lights/my point/@objects");
  }
}

TEST_F(StateDocument, ErasesLightsThatAreGoneAndKeepsStrangers) {
  ParamState state = random_state(1);
  Document document;
  document.set("shot/style", "\"toon\"");
  document.set("lights/ghost/@future", "1");
  write_state(state, document);
  state.rig.lights.erase(state.rig.lights.begin());
  write_state(state, document);
  for (const auto& [path, value] : document.entries()) {
    EXPECT_EQ(path.find("my cinematic"), std::string::npos) << path;
  }
  EXPECT_TRUE(document.has("lights/my point/position"));
  EXPECT_TRUE(document.has("shot/style"));
  EXPECT_TRUE(document.has("lights/ghost/@future"));
}

TEST_F(StateDocument, WritingTwiceChangesNothing) {
  const ParamState state = random_state(2);
  Document document;
  write_state(state, document);
  const std::string hash = document.hash();
  LUM_ASSERT_OK(const ParamState read, read_state(document, types_, style_, frame_));
  write_state(read, document);
  EXPECT_EQ(document.hash(), hash);
}

TEST_F(StateDocument, KeepsConstraintsAndTheyHold) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    ParamState written = random_state(seed);
    Light twin = written.rig.lights[0];
    twin.name = "twin";
    written.rig.lights.push_back(twin);
    const Plane plane{Vec3(0.1F, 0.2F, 0.3F), Vec3(0.4F, -0.5F, 0.6F)};
    written.rig.constraints = {{"twin", MirrorOf{"my cinematic", plane}},
                               {"my cinematic", OnPlane{plane}},
                               {"my cinematic", AtDistance{1.7F, Vec3(0.3F, 0.1F, 0.2F)}},
                               {"my point", SameColor{"twin", 0.3F}},
                               {"my point", Between{"falloff_exponent", 0.1F, 0.9F}}};
    ASSERT_FALSE(find_fault(written.rig));
    keep_constraints(written.rig);
    Document document;
    write_state(written, document);
    LUM_ASSERT_OK(const ParamState read, read_state(document, types_, style_, frame_));
    ASSERT_EQ(read.rig.constraints.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(to_text(read.rig.constraints[i]), to_text(written.rig.constraints[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const ParamBlock& before = written.rig.lights[i].params;
      const ParamBlock& after = read.rig.lights[i].params;
      EXPECT_TRUE(before.same_values(after)) << i;
      for (int dof = 0; dof < before.schema().dofs(); ++dof) {
        EXPECT_EQ(before.locked_by_hand(dof), after.locked_by_hand(dof));
        EXPECT_EQ(before.following(dof), after.following(dof));
        ASSERT_EQ(before.limits(dof) != nullptr, after.limits(dof) != nullptr);
        if (before.limits(dof) != nullptr) {
          EXPECT_EQ(before.limits(dof)->low, after.limits(dof)->low);
          EXPECT_EQ(before.limits(dof)->high, after.limits(dof)->high);
        }
      }
    }
    written.rig.constraints.clear();
    write_state(written, document);
    EXPECT_FALSE(document.has("rig/constraints"));
  }
}

TEST_F(StateDocument, RefusesConstraintsThatItCannotReadOrKeep) {
  Document whole;
  write_state(random_state(3), whole);
  for (const char* value : {"7", "{", "[{}]", R"([{"light": "my point", "on_plane": {"point": [0, 1]}}])",
                            R"([{"light": "ghost", "same_color": {"light": "my point", "factor": 1}}])"}) {
    Document document = whole;
    document.set("rig/constraints", value);
    const Error error = error_of(read_state(document, types_, style_, frame_));
    EXPECT_EQ(error.kind, ErrorKind::kBadContent) << value;
    EXPECT_EQ(error.field, "rig/constraints") << value;
  }
}

TEST_F(StateDocument, NamesThePathThatItCannotRead) {
  Document whole;
  write_state(random_state(3), whole);
  for (const char* path : {"lights/my cinematic/color", "lights/my cinematic/direction", "lights/my point/@type",
                           "locks/ambient/color", "rig/lights"}) {
    Document document = whole;
    document.set(path, "{}");
    const Error error = error_of(read_state(document, types_, style_, frame_));
    EXPECT_EQ(error.kind, ErrorKind::kBadContent);
    EXPECT_EQ(error.field, path);
  }
}

TEST_F(StateDocument, GivesANewParameterOfAStyleItsDefault) {
  Document document;
  write_state(random_state(4), document);
  const std::string name = style_.schema->specs().front().name;
  document.set("style/" + name, "");
  document.set("locks/style/" + name, "");
  LUM_ASSERT_OK(const ParamState read, read_state(document, types_, style_, frame_));
  const ParamState fresh = initial_state(types_, style_, frame_);
  EXPECT_EQ(read.style.get(0), fresh.style.get(0));
}

}  // namespace
}  // namespace luminist
