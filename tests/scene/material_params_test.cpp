#include "scene/material_params.h"

#include <gtest/gtest.h>

#include "scene_file.h"

namespace luminist {
namespace {

Material named(const std::string& name) {
  Material material;
  material.name = name;
  return material;
}

class MaterialParamsTest : public testing::Test {
 protected:
  void SetUp() override { LUM_ASSERT_OK(schema_, load_material_schema(AssetRoots::standard())); }

  [[nodiscard]] ParamBlock block_of(const Material& material) const {
    return material_params({material}, *schema_).front().params;
  }
  static void set(ParamBlock& block, const std::string& name, double value, int component = 0) {
    block.set(*block.schema().find(name), component, value);
  }

  std::shared_ptr<const ParamSchema> schema_;
};

TEST(MaterialNames, AreGoodForPathsAndEachThereOnce) {
  const std::vector<Material> materials{named("jug"), named(""),      named("jug"), named("a/b*c=d:e"),
                                        named(""),    named("jug-2"), named("jug"), named("Stone wall")};
  EXPECT_EQ(material_names(materials), (std::vector<std::string>{"jug", "material", "jug-2", "a-b-c-d-e", "material-2",
                                                                 "jug-2-2", "jug-3", "Stone wall"}));
}

TEST(MaterialNames, HoldUtf8WhateverTheFileHolds) {
  const std::vector<Material> materials{named("B\xF6"
                                              "den"),
                                        named("B\xC3\xB6"
                                              "den"),
                                        named("\xED\xA0\x80"), named(std::string(254, 'a') + "\xC3\xB6")};
  EXPECT_EQ(material_names(materials), (std::vector<std::string>{"B-den",
                                                                 "B\xC3\xB6"
                                                                 "den",
                                                                 "---", std::string(254, 'a')}));
}

TEST(MaterialNames, OfThousandsWithoutOneAreNumbered) {
  const std::vector<std::string> names = material_names(std::vector<Material>(20000));
  EXPECT_EQ(names.front(), "material");
  EXPECT_EQ(names.back(), "material-20000");
}

TEST_F(MaterialParamsTest, StartAsTheSceneHasThemAndLocked) {
  Material glazed = named("glazed");
  glazed.roughness = 0.3F;
  glazed.specular = 12.5F;  // beyond the range of the manifest
  const ParamBlock block = block_of(glazed);
  EXPECT_EQ(block.scalar(*block.schema().find("roughness")), 0.3F);
  EXPECT_EQ(block.scalar(*block.schema().find("specular")), 12.5F);
  EXPECT_EQ(block.vec3(*block.schema().find("tint")), Vec3(1.0F));
  EXPECT_EQ(block.schema()[*block.schema().find("specular")].range_max[0], 12.5);
  EXPECT_EQ(block.schema().dofs(), 5);
  for (int dof = 0; dof < block.schema().dofs(); ++dof) EXPECT_TRUE(block.locked(dof));
  EXPECT_TRUE(turn_of(block).nothing());
}

TEST_F(MaterialParamsTest, ATintEndsWhereAllLightIsReflected) {
  Material jug = named("jug");
  jug.base_color = {0.8F, 0.1F, 1.0F};
  const ParamBlock plain = block_of(jug);
  const ParamSpec& tint = plain.schema()[*plain.schema().find("tint")];
  EXPECT_NEAR(tint.range_max[0], 1.25, 1e-6);
  EXPECT_EQ(tint.range_max[1], 2.0) << "the manifest's";
  EXPECT_EQ(tint.range_max[2], 1.0);
  jug.base_color_texture = 0;
  const ParamBlock textured = block_of(jug);
  EXPECT_EQ(textured.schema()[*textured.schema().find("tint")].range_max[2], 2.0) << "a texel may be dark";
}

TEST_F(MaterialParamsTest, NothingTurnedLeavesEveryBit) {
  const SurfaceColors colors{{0.31F, 0.77F, 0.13F}, {0.043F, 0.04F, 0.29F}, 0.0371F, 0.217F};
  const SurfaceColors same = turned(turn_of(block_of(named("jug"))), colors);
  EXPECT_EQ(same.albedo, colors.albedo);
  EXPECT_EQ(same.specular, colors.specular);
  EXPECT_EQ(same.roughness, colors.roughness);
}

TEST_F(MaterialParamsTest, TurnedSurfacesAreThoseOfTheTurnedMaterial) {
  Material own = named("brass");
  own.base_color = {0.5F, 0.4F, 0.2F};
  own.metallic = 0.3F;
  own.roughness = 0.4F;
  own.specular = 2.0F;
  ParamBlock block = block_of(own);
  set(block, "tint", 1.5, 0);
  set(block, "tint", 0.5, 1);
  set(block, "roughness", 0.6);
  set(block, "specular", 0.5);
  const auto dielectric = [](const Material& m) { return 0.04F * m.specular * (1.0F - m.metallic); };
  const auto surface_of = [&](const Material& m, float texel) {  // of the roughness texture
    return SurfaceColors{m.base_color * (1.0F - m.metallic), dielectric(m) + m.base_color * m.metallic, dielectric(m),
                         m.roughness * texel};
  };
  Scene scene;
  scene.materials = {own};
  const Scene other = with_materials(scene, {{"brass", block}});
  for (const float texel : {1.0F, 0.25F}) {
    const SurfaceColors got = turned(turn_of(block), surface_of(own, texel));
    const SurfaceColors wanted = surface_of(other.materials[0], texel);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(got.albedo[c], wanted.albedo[c], 1e-6F);
      EXPECT_NEAR(got.specular[c], wanted.specular[c], 1e-6F);
    }
    EXPECT_NEAR(got.roughness, wanted.roughness, 1e-6F);
  }
}

TEST_F(MaterialParamsTest, ReflectAtMostWhatArrivesWhereverTheSolverGoes) {
  for (const double value : {-3.0, 0.0, 1.7, 40.0}) {
    for (const float metallic : {0.0F, 0.6F, 1.0F}) {
      ParamBlock block = block_of(named("jug"));
      for (int c = 0; c < 3; ++c) set(block, "tint", value, c);
      set(block, "specular", value);
      set(block, "roughness", value);
      const Vec3 base(0.9F, 0.5F, 0.0F);
      const float dielectric = 0.04F * (1.0F - metallic);
      const SurfaceColors got =
          turned(turn_of(block), {base * (1.0F - metallic), dielectric + base * metallic, dielectric, 0.5F});
      for (int c = 0; c < 3; ++c) {
        EXPECT_GE(got.albedo[c], 0.0F);
        EXPECT_LE(got.albedo[c], 1.0F - metallic + 1e-6F);
        EXPECT_GE(got.specular[c], 0.0F);
      }
      EXPECT_GE(got.roughness, 0.0F);
      EXPECT_LE(got.roughness, 1.0F);
    }
  }
}

TEST_F(MaterialParamsTest, AMirrorOfTheSceneCanBecomeRough) {
  Material mirror = named("mirror");
  mirror.roughness = 0.0F;
  ParamBlock block = block_of(mirror);
  set(block, "roughness", 0.4);
  EXPECT_FLOAT_EQ(turned(turn_of(block), {Vec3(0.5F), Vec3(0.04F), 0.04F, 0.0F}).roughness, 0.4F);
}

/// A jug whose base colour is a texture of two texels.
Scene textured_scene() {
  Scene scene;
  scene.meshes = {tetrahedron_with_uvs()};
  Image pattern(2, 1, 3, 0.25F);
  pattern.set_rgb(1, Vec3(0.75F));
  scene.textures = {{"pattern", pattern, true, true}};
  Material jug = named("jug");
  jug.base_color = Vec3(1.0F);
  jug.base_color_texture = 0;
  Material plain = named("plain");
  plain.base_color_texture = 0;
  scene.materials = {jug, plain};
  Object object;
  object.name = "jug";
  scene.objects = {object};
  return scene;
}

TEST_F(MaterialParamsTest, GoIntoASavedSceneAndComeBackAsItsOwn) {
  const Scene scene = textured_scene();
  std::vector<MaterialParams> params = material_params(scene.materials, *schema_);
  set(params[0].params, "tint", 0.5, 1);
  set(params[0].params, "specular", 3.0);
  set(params[0].params, "roughness", 0.125);
  const TemporaryFolder folder;
  LUM_EXPECT_OK(save_scene(with_materials(scene, params), folder.file("turned.glb")));
  Diagnostics diagnostics;
  LUM_ASSERT_OK(const Scene back, load_scene(folder.file("turned.glb"), {}, diagnostics));
  EXPECT_EQ(back.materials[0].base_color, Vec3(1.0F, 0.5F, 1.0F));
  EXPECT_EQ(back.materials[0].specular, 3.0F);
  EXPECT_EQ(back.materials[0].roughness, 0.125F);
  EXPECT_EQ(back.materials[1].specular, 1.0F);
  EXPECT_EQ(back.textures.size(), 1U) << "a factor says it";
  const ParamBlock own = material_params(back.materials, *schema_)[0].params;
  EXPECT_EQ(own.scalar(*own.schema().find("specular")), 3.0F);
}

TEST_F(MaterialParamsTest, ATintThatAFactorCannotSayBecomesATextureOfItsOwn) {
  const Scene scene = textured_scene();
  std::vector<MaterialParams> params = material_params(scene.materials, *schema_);
  for (int c = 0; c < 3; ++c) set(params[0].params, "tint", 1.5, c);
  const Scene other = with_materials(scene, params);
  ASSERT_EQ(other.textures.size(), 2U);
  EXPECT_EQ(other.materials[0].base_color_texture, 1);
  EXPECT_EQ(other.materials[1].base_color_texture, 0) << "who shares the texture keeps it";
  EXPECT_EQ(other.textures[0].image.data, scene.textures[0].image.data);
  EXPECT_EQ(other.textures[1].image.rgb(0), Vec3(0.375F));
  EXPECT_EQ(other.textures[1].image.rgb(1), Vec3(1.0F)) << "nothing reflects more than arrives";
}

TEST(MaterialSchema, SaysWhichRoleIsMissing) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "shaders");
  std::ofstream(folder.path() / "shaders/material.toml")
      << "doc = \"\"\n[[param]]\nname = \"tint\"\ntype = \"color\"\ndefault = [1, 1, 1]\nrange = [0, 2]\nrole = "
         "\"tint\"\ndoc = \"\"\n";
  const auto schema = load_material_schema(AssetRoots({folder.path()}));
  ASSERT_FALSE(schema);
  EXPECT_EQ(schema.error().kind, ErrorKind::kStyle);
  EXPECT_EQ(schema.error().field, "specular");
}

}  // namespace
}  // namespace luminist
