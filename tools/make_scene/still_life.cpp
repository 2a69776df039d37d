// The paper's Figure 2: a painted jug, fruit, a bowl and a cloth on a table before a wall.
#include <cmath>

#include "make_scene/curve.h"
#include "make_scene/drape.h"
#include "make_scene/fruit.h"
#include "make_scene/grain.h"
#include "make_scene/jug.h"
#include "make_scene/noise.h"
#include "make_scene/recipes.h"
#include "make_scene/slab.h"
#include "make_scene/stage.h"
#include "make_scene/vessel.h"

namespace luminist {
namespace {

constexpr double kTableFront = 0.30;  // z of the table's front edge
constexpr double kTableHalf = 0.024;  // half the thickness of its top
constexpr double kWall = -0.36;       // z of the wall
constexpr double kCloth = 0.0022;     // what lies on the cloth is this much higher

struct Foot {
  Point2 place;
  double radius;
};
constexpr Foot kFeet[] = {
    {{0.155, 0.015}, 0.060}, {{-0.062, 0.150}, 0.036}, {{0.055, 0.185}, 0.036}};  // bowl, apple, orange

Material textured(const std::string& name, int texture, float roughness) {
  Material material;
  material.name = name;
  material.base_color = Vec3(1.0F);
  material.base_color_texture = texture;
  material.roughness = roughness;
  return material;
}

Material plain(const std::string& name, const Vec3& color, float roughness) {
  Material material;
  material.name = name;
  material.base_color = color;
  material.roughness = roughness;
  return material;
}

void add_surroundings(Stage& stage) {
  Material wood = textured(
      "table_wood", stage.add_texture("wood", wood_painting(1024, 512, swatch(0x7A4C2C), swatch(0x3E2214))), 1.0F);
  wood.metallic_roughness_texture = stage.add_texture("wood_roughness", wood_roughness(512, 256));
  wood.metallic = 1.0F;  // the texture's blue says 0
  wood.normal_texture = stage.add_texture("wood_relief", wood_relief(512, 256, {0.8, 0.4}));
  const int wood_index = stage.add_material(wood);
  Mesh table;
  const double depth = (kTableFront - kWall) / 4.0;
  for (int i = 0; i < 4; ++i) {
    const auto z = static_cast<float>(kWall + depth * (i + 0.5));
    const Vec3 half{0.80F, static_cast<float>(kTableHalf), static_cast<float>(0.5 * depth) - 0.0006F};
    append(table, slab_at({0.0F, -half.y, z}, half, 0.006F, 0.8F,
                          {0.37F * static_cast<float>(i), 0.29F * static_cast<float>(i)}));
  }
  const Vec3 apron{0.76F, 0.055F, 0.012F};
  append(table, slab_at({0.0F, -0.048F - apron.y, static_cast<float>(kTableFront) - 0.035F}, apron, 0.003F, 0.8F,
                        {0.2F, 0.6F}));
  stage.add_object("table", table, wood_index);
  stage.mark_backdrop();

  Material plaster =
      textured("plaster", stage.add_texture("plaster", plaster_painting(512, swatch(0xB5A894), 0.34)), 0.92F);
  plaster.normal_texture = stage.add_texture("plaster_relief", plaster_relief(512, 0.7));
  const Surface wall = [](double u, double v) { return Point3(-1.1 + 2.2 * u, -0.5 + 1.6 * v, kWall); };
  Mesh wall_mesh = tessellate(wall, 2, 2);
  scale_uvs(wall_mesh, {2.2F / 0.7F, 1.6F / 0.7F});
  stage.add_object("wall", wall_mesh, stage.add_material(plaster));
  stage.mark_backdrop();
}

/// A linen cloth, gathered, over the front edge of the table; what stands on it presses it flat.
Mesh cloth_mesh() {
  Drape drape;
  drape.size = {0.50, 0.50};
  drape.columns = 100;
  drape.rows = 100;
  drape.start = [](double u, double v) {
    const double gather = 0.76 + 0.06 * std::sin(5.0 * v);
    const double x = 0.045 + (u - 0.5) * 0.50 * gather + 0.10 * (v - 0.5);
    const double z = -0.055 + 0.485 * v + 0.05 * (u - 0.5);
    const double waves = noise({u * 5.0, v * 1.6, 0.4}) + 0.3 * noise({u * 9.0 + 3.0, v * 3.0, 2.4});
    return Point3(x, 0.035 + 0.036 * waves, z + 0.012 * noise({u * 4.0, v * 4.0, 8.0}));
  };
  drape.obstacle = [](const Point3& p) {
    const Point3 q = p - Point3(0.0, -kTableHalf, 0.5 * (kTableFront + kWall));
    return box_distance(q, {0.9, kTableHalf + 0.0014, 0.5 * (kTableFront - kWall) + 0.004},
                        0.012);  // as round as cloth bends
  };
  drape.ceiling = [](const Point3& p) {
    double height = 1.0;
    for (const Foot& foot : kFeet) {
      const double away = glm::length(Point2(p.x, p.z) - foot.place) - foot.radius;
      height = std::min(height, 0.0018 + 1.2 * std::max(away, 0.0) + 8.0 * std::pow(std::max(away, 0.0), 2.0));
    }
    return height;
  };
  drape.thickness = 0.0007;
  drape.steps = 420;
  return fallen(drape);
}

void add_vessels(Stage& stage) {
  stage.add_object(
      "jug", jug_mesh(),
      stage.add_material(textured("jug_glaze", stage.add_texture("jug_ornament", jug_painting(1024, 1024)), 0.22F)),
      Placement{{-0.120F, 0.0F, -0.075F}, {0.0F, -0.18F, 0.0F}}.matrix());
  stage.add_object(
      "bowl", bowl_mesh(),
      stage.add_material(textured("celadon", stage.add_texture("celadon", bowl_painting(512, 256)), 0.20F)),
      Placement{
          {static_cast<float>(kFeet[0].place.x), static_cast<float>(kCloth), static_cast<float>(kFeet[0].place.y)}}
          .matrix());
}

void add_apple(Stage& stage, const std::string& name, std::uint64_t seed, double blush, const Mat4& place, int stem) {
  const int skin = stage.add_texture(name + "_skin", apple_painting(384, 192, blush));
  stage.add_object(name, apple_mesh(seed), stage.add_material(textured(name, skin, 0.30F)), place);
  stage.add_object(name + "_stem", apple_stem_mesh(seed), stem, place);
}

void add_fruit(Stage& stage) {
  const int stem = stage.add_material(plain("stem", swatch(0x5A4326), 0.8F));
  const auto bowl_x = static_cast<float>(kFeet[0].place.x);
  const auto bowl_z = static_cast<float>(kFeet[0].place.y);
  const float floor = static_cast<float>(kCloth + bowl_floor(0.035));
  add_apple(stage, "apple_front", 3, 0.95,
            Placement{{-0.062F, static_cast<float>(kCloth), 0.150F}, {0.35F, 0.6F, 0.10F}}.matrix(), stem);
  add_apple(stage, "apple_bowl", 8, 0.70,
            Placement{{bowl_x - 0.032F, floor + 0.004F, bowl_z + 0.012F}, {0.30F, 2.4F, -0.25F}}.matrix(), stem);
  add_apple(stage, "apple_back", 11, 0.35,
            Placement{{bowl_x + 0.040F, floor + 0.006F, bowl_z - 0.026F}, {-0.2F, 4.1F, -0.35F}}.matrix(), stem);

  Material orange = textured("orange", stage.add_texture("orange_skin", orange_painting(384, 192)), 0.42F);
  orange.normal_texture = stage.add_texture("orange_pores", orange_pores(448, 224));
  Mesh orange_peel = orange_mesh();
  stage.add_object("orange", orange_peel, stage.add_material(orange),
                   Placement{{0.055F, static_cast<float>(kCloth), 0.185F}, {0.5F, 0.3F, 0.0F}}.matrix());
  stage.add_object("pear", pear_mesh(),
                   stage.add_material(textured("pear", stage.add_texture("pear_skin", pear_painting(384, 256)), 0.42F)),
                   Placement{{-0.235F, 0.0F, 0.060F}, {0.0F, 0.5F, 0.0F}}.matrix());
  stage.add_object("pear_stem", pear_stem_mesh(), stem,
                   Placement{{-0.235F, 0.0F, 0.060F}, {0.0F, 0.5F, 0.0F}}.matrix());

  const int berries =
      stage.add_material(textured("grapes", stage.add_texture("grape_skin", grape_painting(256, 128)), 0.32F));
  const Mat4 bunch = Placement{{0.130F, static_cast<float>(kCloth), 0.150F}, {0.0F, -0.30F, 0.0F}}.matrix();
  stage.add_object("grapes", grapes_mesh(44, 5), berries, bunch);
  stage.add_object("grape_stems", grape_stems_mesh(), stage.add_material(plain("grape_stem", swatch(0x7A6A32), 0.8F)),
                   bunch);
}

}  // namespace

Scene build_still_life() {
  Stage stage;
  add_vessels(stage);
  add_fruit(stage);
  Material linen = plain("linen", swatch(0xD8CDB8), 0.85F);
  linen.normal_texture = stage.add_texture("weave", weave_relief(128, 32, 0.0161));
  Mesh cloth = cloth_mesh();
  scale_uvs(cloth, {31.0F, 31.0F});
  stage.add_object("cloth", cloth, stage.add_material(linen));
  add_surroundings(stage);
  stage.add_camera("painter", {0.02F, 0.40F, 1.45F}, {-0.005F, 0.115F, 0.0F}, 0.345F);
  return stage.take();
}

}  // namespace luminist
