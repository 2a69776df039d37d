// An imp that waves from a rocky hollow: horns, ears, fingers, wings, a curled tail and a staff, for telling shadows.
#include <glm/ext/matrix_transform.hpp>

#include "make_scene/glade.h"
#include "make_scene/grain.h"
#include "make_scene/imp.h"
#include "make_scene/painting.h"
#include "make_scene/recipes.h"
#include "make_scene/stage.h"

namespace luminist {
namespace {

const float kScale = 0.1F;  // one unit is ten centimetres

Mat4 at_joint(const Point3& joint) {
  return glm::scale(glm::translate(Mat4(1.0F), kScale * Vec3(joint)), Vec3(kScale));
}

int add_carved(Stage& stage, const std::string& name, Image picture, Image relief, float roughness) {
  Material material;
  material.name = name;
  material.base_color = Vec3(1.0F);
  material.base_color_texture = stage.add_texture(name, std::move(picture));
  material.normal_texture = stage.add_texture(name + "_relief", std::move(relief));
  material.roughness = roughness;
  return stage.add_material(material);
}

void add_imp(Stage& stage) {
  const int skin = stage.add_textured("imp_skin", imp_skin(256, 64), 0.48F);
  for (BodyPart& part : imp_body()) stage.add_object(part.name, std::move(part.mesh), skin, at_joint(part.joint));
  const int horn = stage.add_textured("horn", horn_painting(128, 256), 0.40F);
  const int eye = stage.add_textured("eye", eye_painting(256, 256), 0.08F);
  const int web = stage.add_textured("wing_skin", wing_painting(384, 256), 0.55F);
  const Mat4 body = at_joint(Point3(0.0));
  const int ball = stage.add_mesh(eye_mesh());
  for (const int side : {-1, 1}) {
    const std::string suffix = side < 0 ? "_right" : "_left";
    stage.add_object("eye" + suffix, ball, eye,
                     at_joint(eye_center(side)) *
                         Placement{Vec3(0.0F), {0.02F, 0.10F - 0.06F * static_cast<float>(side), 0.0F}}.matrix());
    stage.add_object("horn" + suffix, horn_mesh(side), horn, body);
    stage.add_object("wing_bones" + suffix, wing_bones(side), skin, body);
    stage.add_object("wing_skin" + suffix, wing_skin(side), web, body);
  }
  stage.add_object("tail", tail_mesh(), skin, body);
}

void add_toadstools(Stage& stage, const Mat4& world) {
  const int cap = stage.add_textured("toadstool_cap", cap_painting(384, 192), 0.35F);
  const int stalk = stage.add_plain("toadstool_stalk", swatch(0xE2D6BC), 0.7F);
  struct Spot {
    double x, z, height, lean, radius;
  };
  const Spot spots[] = {{-1.65, 0.95, 0.75, -0.12, 0.42},
                        {-2.05, 0.70, 0.42, -0.10, 0.26},
                        {-1.38, 1.30, 0.30, 0.08, 0.20},
                        {2.15, -0.35, 0.62, 0.10, 0.36}};
  int number = 1;
  for (const Spot& spot : spots) {
    const Point3 foot{spot.x, ground_height(spot.x, spot.z) - 0.03, spot.z};
    const Mat4 place = world * glm::translate(Mat4(1.0F), Vec3(foot));
    const std::string name = "toadstool_" + std::to_string(number++);
    stage.add_object(name, toadstool_cap(spot.height, spot.lean, spot.radius), cap, place);
    stage.add_object(name + "_stalk", toadstool_stalk(spot.height, spot.lean), stalk, place);
  }
}

void add_glade(Stage& stage) {
  const Mat4 world = glm::scale(Mat4(1.0F), Vec3(kScale));
  stage.add_object("staff", staff_mesh(),
                   stage.add_textured("bark", wood_painting(256, 128, swatch(0x8A6A48), swatch(0x3E2A1A)), 0.75F),
                   world);
  add_toadstools(stage, world);
  const int green = stage.add_plain("fern", swatch(0x5F7A32), 0.6F);
  Mesh ferns = fern_mesh({2.05, ground_height(2.05, -1.1) - 0.05, -1.1}, 2.1, -1.0);
  append(ferns, fern_mesh({2.40, ground_height(2.40, -1.2) - 0.05, -1.2}, 1.5, 1.0));
  append(ferns, fern_mesh({-2.20, ground_height(-2.20, -0.7) - 0.05, -0.7}, 1.7, -1.0));
  stage.add_object("ferns", ferns, green, world);
  stage.add_object("grass", grass_mesh(130, 4), stage.add_plain("grass", swatch(0x73843A), 0.65F), world);
  stage.add_object("ground", ground_mesh(), add_carved(stage, "moss", ground_painting(448), ground_relief(384), 0.9F),
                   world);
  stage.mark_backdrop();
  stage.add_object("hollow", hollow_mesh(), add_carved(stage, "rock", rock_painting(448), rock_relief(384), 0.88F),
                   world);
  stage.mark_backdrop();
}

}  // namespace

Scene build_creature() {
  Stage stage;
  add_imp(stage);
  add_glade(stage);
  stage.add_camera("glade", {0.10F, 0.27F, 1.22F}, {0.02F, 0.235F, 0.0F}, 0.50F);
  Scene scene = stage.take();
  animate_imp(scene);
  return scene;
}

}  // namespace luminist
