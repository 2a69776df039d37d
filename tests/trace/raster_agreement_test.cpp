// The path tracer and the raster engine draw the same direct light.
#include <cmath>
#include <numeric>

#include "gpu/device.h"
#include "raster/raster_renderer.h"
#include "scene/scene.h"
#include "trace/box_scene.h"
#include "trace/rig_light.h"

namespace luminist {
namespace {

/// A board with a post on it, both matte, seen from above at a slant; not closed, so that all light is direct.
Scene board_scene() {
  Scene scene;
  add_rectangle(scene, {-2.0F, 0.0F, 2.0F}, {4.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -4.0F},
                add_material(scene, matte({0.8F, 0.6F, 0.4F})));
  const int post = add_material(scene, matte({0.3F, 0.5F, 0.7F}));
  add_rectangle(scene, {-0.2F, 0.0F, 0.0F}, {0.5F, 0.0F, -0.2F}, {0.0F, 1.0F, 0.0F}, post);
  add_rectangle(scene, {-0.2F, 1.0F, 0.0F}, {0.5F, 0.0F, -0.2F}, {-0.1F, 0.0F, -0.4F}, post);
  return scene;
}

Camera slanted_camera() {
  Camera camera;
  const Vec3 eye(0.3F, 2.5F, 3.0F);
  const Vec3 back = glm::normalize(eye - Vec3(0.0F, 0.3F, 0.0F));
  const Vec3 right = glm::normalize(glm::cross(Vec3(0.0F, 1.0F, 0.0F), back));
  camera.world_from_camera =
      Mat4(Vec4(right, 0.0F), Vec4(glm::cross(back, right), 0.0F), Vec4(back, 0.0F), Vec4(eye, 1.0F));
  camera.fov_y = 0.7F;
  return camera;
}

class RasterAgreement : public ::testing::Test {
 protected:
  static constexpr int kWidth = 96;
  static constexpr int kHeight = 72;

  void SetUp() override { prepare(board_scene()); }
  void prepare(const Scene& scene) {
    const AssetRoots roots = AssetRoots::standard();
    raster_.reset();  // before the device it was made from, which goes before there is another
    device_.reset();
    LUM_ASSERT_OK(Device device, Device::create_headless());
    device_.emplace(std::move(device));
    LUM_ASSERT_OK(LightTypes types, LightTypes::load(roots));
    types_.emplace(std::move(types));
    LUM_ASSERT_OK(const Style cinematic, load_style(roots, "cinematic"));
    LUM_ASSERT_OK(const Style path, load_style(roots, "path"));
    LUM_ASSERT_OK(
        raster_, RasterRenderer::create(*device_, scene, slanted_camera(), *types_, cinematic, roots, kWidth, kHeight));
    LUM_ASSERT_OK(paths_, PathRenderer::create(scene, slanted_camera(), path, kWidth, kHeight));
    rastered_.emplace(initial_state(*types_, cinematic, paths_->frame()));
    traced_.emplace(initial_state(*types_, path, paths_->frame()));
    set("ambient/color=0,0,0");
    LUM_EXPECT_OK(set_path(*rastered_, "style/specular=0"));
    LUM_EXPECT_OK(set_path(*traced_, "style/highlights=0"));
    LUM_EXPECT_OK(set_path(*traced_, "style/bounces=1"));
  }
  void set(const std::string& assignment) {
    LUM_EXPECT_OK(set_path(*rastered_, assignment));
    LUM_EXPECT_OK(set_path(*traced_, assignment));
  }
  void add_light(const std::string& type) {
    for (ParamState* state : {&*rastered_, &*traced_}) {
      LUM_ASSERT_OK(Light light, make_light(*types_, type, "key", paths_->frame()));
      state->rig.lights = {light};
    }
    if (type != "sun") set("lights/key/position=1.2,2.5,1.4");
  }
  /// What both engines say at the pixels' centres, without shadows; the path tracer's light is that of its formula.
  void compare_formulas(float tolerance) {
    const SurfaceBuffer& surface = raster_->surface();
    SampleSet samples{5, std::vector<std::uint32_t>(surface.pixels())};
    std::iota(samples.pixels.begin(), samples.pixels.end(), 0U);
    const Candidate candidate{&*rastered_, 0};
    std::vector<Vec3> colors(surface.pixels());
    LUM_EXPECT_OK(raster_->evaluate({&candidate, 1}, samples, {}, colors));
    LUM_ASSERT_OK(const RigLight light, rig_light(traced_->rig, 0, {}, paths_->frame()));
    int lit = 0;
    for (std::size_t i = 0; i < surface.pixels(); ++i) {
      if (surface.object[i] == 0) continue;
      const Vec3 way = glm::normalize(light.position - surface.position[i]);
      const float facing = std::max(0.0F, glm::dot(way, surface.normal[i]));
      const Vec3 wanted = surface.albedo[i] * light.color * (facing * point_strength(light, surface.position[i]));
      ASSERT_LT(glm::distance(colors[i], wanted), tolerance) << i;
      lit += wanted.x > 0.01F ? 1 : 0;
    }
    EXPECT_GT(lit, 500) << "the light is in the picture";
  }
  /// Mean and largest difference of both engines' pictures, and the share of pixels that differ by more than 0.05.
  void compare_pictures(double mean, double share) {
    LUM_ASSERT_OK(const Image a, raster_->render(*rastered_));
    LUM_ASSERT_OK(const Image b, paths_->render(*traced_));
    double sum = 0.0;
    double brightness = 0.0;
    int far = 0;
    for (std::size_t i = 0; i < a.pixels(); ++i) {
      const auto difference = static_cast<double>(glm::length(a.rgb(i) - b.rgb(i)));
      sum += difference;
      brightness += static_cast<double>(glm::length(a.rgb(i)));
      far += difference > 0.05 ? 1 : 0;
    }
    EXPECT_LT(sum, mean * brightness);
    EXPECT_LT(far, share * static_cast<double>(a.pixels()));
    EXPECT_GT(brightness, 0.1 * static_cast<double>(a.pixels())) << "there is light to compare";
  }

  std::optional<Device> device_;
  std::optional<LightTypes> types_;
  std::unique_ptr<RasterRenderer> raster_;
  std::unique_ptr<PathRenderer> paths_;
  std::optional<ParamState> rastered_;
  std::optional<ParamState> traced_;
};

TEST_F(RasterAgreement, TheCinematicLightHasOneFormula) {
  add_light("cinematic");
  set("lights/key/direction=-0.4,-0.8,-0.45");
  set("lights/key/barn=0.3,0.5,0.2");
  set("lights/key/near_cutoff=2.2,0.5");
  set("lights/key/far_cutoff=3.5,1.0");
  set("lights/key/falloff_exponent=1.7");
  set("lights/key/color=1,0.7,0.3");
  set("lights/key/shadow_density=0");
  compare_formulas(2e-5F);  // single precision in two orders of operations; slopes of the barn's edge about 10
  set("lights/key/direction=0.02,-0.9998,0.01");
  set("lights/key/barn=0.6,0.2,0.02");
  compare_formulas(2e-4F);  // a harder edge; the frame of a light that points down turns fast
}

TEST_F(RasterAgreement, ThePointLightHasOneFormula) {
  add_light("point");
  set("lights/key/far_cutoff=2,2");
  set("lights/key/falloff_exponent=1.3");
  set("lights/key/shadow_density=0");
  compare_formulas(2e-5F);
}

TEST_F(RasterAgreement, TheSunHasOneFormulaAndOneShadow) {
  add_light("sun");
  set("lights/key/direction=-0.4,-0.8,-0.45");
  set("lights/key/color=1,0.7,0.3");
  set("lights/key/shadow_density=0");
  compare_formulas(1e-3F);  // the path tracer's stands 2000 radii away
  set("lights/key/shadow_density=1");
  set("lights/key/shadow_softness=0.001");
  compare_pictures(0.01, 0.03);  // as below
}

TEST_F(RasterAgreement, PicturesOfHardShadowsAreTheSame) {
  add_light("cinematic");
  set("lights/key/direction=-0.4,-0.85,-0.45");
  set("lights/key/barn=1,1,0.1");
  set("lights/key/shadow_softness=0.001");
  // Shadow maps have texels and offsets, and a pixel of an edge is four samples there and 64 here: the shadow's outline
  // and silhouettes differ (3 % of the pixels), areas do not.
  compare_pictures(0.01, 0.03);
}

TEST_F(RasterAgreement, APartialShadowIsAsDense) {
  add_light("point");
  set("lights/key/shadow_density=0.6");
  set("lights/key/shadow_softness=0.001");
  compare_pictures(0.01, 0.03);
}

TEST_F(RasterAgreement, HighlightsOfMetalsAreTheSame) {
  Scene scene = board_scene();
  for (Material& material : scene.materials) material.metallic = 1.0F, material.roughness = 0.5F;
  prepare(scene);
  LUM_EXPECT_OK(set_path(*rastered_, "style/specular=1"));
  LUM_EXPECT_OK(set_path(*traced_, "style/highlights=1"));
  add_light("point");
  set("lights/key/position=-0.6,1.2,-1.4");
  set("lights/key/color=4,4,4");
  set("lights/key/falloff_exponent=0");
  set("lights/key/shadow_softness=0.001");
  compare_pictures(0.02, 0.03);  // as above; metals scatter nothing diffusely, where the engines differ by 1 - F
}

TEST_F(RasterAgreement, TurnedMaterialsAreTheSame) {
  Scene scene = board_scene();
  for (Material& material : scene.materials) material.metallic = 1.0F, material.roughness = 0.5F;
  scene.materials[0].name = "board";
  prepare(scene);
  LUM_ASSERT_OK(const auto schema, load_material_schema(AssetRoots::standard()));
  for (ParamState* state : {&*rastered_, &*traced_}) state->materials = material_params(scene.materials, *schema);
  LUM_EXPECT_OK(set_path(*rastered_, "style/specular=1"));
  LUM_EXPECT_OK(set_path(*traced_, "style/highlights=1"));
  set("materials/board/tint=0.6,1.1,0.5");
  set("materials/board/roughness=0.7");
  add_light("point");
  set("lights/key/position=-0.6,1.2,-1.4");
  set("lights/key/color=4,4,4");
  set("lights/key/falloff_exponent=0");
  set("lights/key/shadow_softness=0.001");
  compare_pictures(0.02, 0.03);  // as above
}

TEST_F(RasterAgreement, TheSurfaceIsTheSame) {
  const SurfaceBuffer& a = raster_->surface();
  const SurfaceBuffer& b = paths_->surface();
  int others = 0;
  for (std::size_t i = 0; i < a.pixels(); ++i) {
    if (a.object[i] != b.object[i]) {
      ++others;  // a silhouette goes through the pixel's centre
      continue;
    }
    // A rasterizer snaps corners to parts of a pixel, and where a surface is seen from the side that is a way.
    EXPECT_LT(glm::distance(a.position[i], b.position[i]), 5e-4F) << i;
    EXPECT_LT(glm::distance(a.normal[i], b.normal[i]), 1e-3F) << i;
    EXPECT_LT(glm::distance(a.albedo[i], b.albedo[i]), 1e-5F) << i;
    EXPECT_EQ(a.material[i], b.material[i]);
  }
  EXPECT_LE(others, 20);
}

TEST_F(RasterAgreement, APanelFarAwayIsLikeThePath) {
  add_light("area");
  set("lights/key/position=0.6,5,0.8");
  set("lights/key/direction=-0.1,-1,-0.1");
  set("lights/key/size=0.3");
  set("lights/key/falloff_distance=4");
  // The raster engine's panel is a point with a filtered shadow: penumbrae differ, light does not.
  compare_pictures(0.03, 0.06);
}

}  // namespace
}  // namespace luminist
