// The sun: parallel rays, in pictures and in what the solver sees.
#include "raster/renderer_fixture.h"

namespace luminist {
namespace {

class SunTest : public RendererTest {
 protected:
  void SetUp() override {
    RendererTest::SetUp();
    use_style("cinematic");
    LUM_ASSERT_OK(Light sun, make_light(*types_, "sun", "sun", renderer_->frame()));
    state_->rig.lights = {sun};
    set("ambient/color=0,0,0");
    set("style/specular=0");
    shine(Vec3(0.5F, -1.0F, -0.3F));
  }
  void set(const std::string& assignment) { LUM_EXPECT_OK(set_path(*state_, assignment)); }
  void shine(const Vec3& way) { light(0).set_vec3(param(light(0), "direction"), glm::normalize(way)); }
  [[nodiscard]] Vec3 way() { return light(0).vec3(param(light(0), "direction")); }
  /// How far from the ball's middle the ray of the sun passes that meets a place.
  [[nodiscard]] float passes(const Vec3& place) { return glm::length(place - glm::dot(place, way()) * way()); }
  Image picture() {
    auto picture = renderer_->render(*state_);
    EXPECT_TRUE(picture) << picture.error().message();
    return picture ? *picture : Image(kWidth, kHeight, 3);
  }
};

TEST_F(SunTest, LightsByTheCosineAndNothingElse) {
  drop_shadows();
  const SurfaceBuffer& surface = renderer_->surface();
  const std::vector<Vec3> colors = evaluate({&*state_, 0}, all_pixels());
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == 0) continue;
    const Vec3 wanted = surface.albedo[i] * std::max(0.0F, -glm::dot(surface.normal[i], way()));
    ASSERT_LT(glm::distance(colors[i], wanted), 1e-5F) << i;  // single precision
  }
}

TEST_F(SunTest, TheBallsShadowFallsAlongTheRays) {
  for (const Vec3& way : {Vec3(0.5F, -1.0F, -0.3F), Vec3(-1.0F, -0.7F, 0.0F), Vec3(0.0F, -1.0F, 0.0F)}) {
    shine(way);
    const Image lit = picture();
    const SurfaceBuffer& surface = renderer_->surface();
    int dark = 0;
    int bright = 0;
    int wrong = 0;
    for (std::size_t i = 0; i < surface.pixels(); ++i) {
      if (surface.object[i] != 2) continue;
      const float off = passes(surface.position[i]);
      if (off < 0.85F && glm::length(surface.position[i]) > 1.1F) {  // bumps and the filter take the rest
        wrong += lit.rgb(i).x > 0.01F ? 1 : 0;
        ++dark;
      } else if (off > 1.2F) {
        wrong += lit.rgb(i).x < 0.5F ? 1 : 0;
        ++bright;
      }
    }
    EXPECT_GT(dark, 100);
    EXPECT_GT(bright, 1000);
    EXPECT_LT(wrong, (dark + bright) / 100);  // antialiased silhouettes
  }
}

TEST_F(SunTest, RaysAndItsMapSeeTheSameShadows) {
  const Image picture_by_maps = picture();
  const std::vector<Vec3> by_rays = evaluate({&*state_, Candidate::kAllLights}, all_pixels());
  double sum = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < by_rays.size(); ++i) {
    sum += static_cast<double>(glm::distance(by_rays[i], picture_by_maps.rgb(i)));
    all += static_cast<double>(glm::length(picture_by_maps.rgb(i)));
  }
  EXPECT_LT(sum, 0.03 * all);  // four rays a sample and the picture's own antialiasing
  EXPECT_GT(all, 1000.0);
}

TEST_F(SunTest, ALargerDiscHasSofterShadowsAndTheSameLight) {
  const auto half_lit = [&](const char* softness) {
    set(std::string("lights/sun/shadow_softness=") + softness);
    const Image lit = picture();
    int count = 0;
    for (std::size_t i = 0; i < lit.pixels(); ++i) {
      if (renderer_->surface().object[i] == 2 && lit.rgb(i).x > 0.1F && lit.rgb(i).x < 0.6F) ++count;
    }
    return count;
  };
  const int hard = half_lit("0.002");
  EXPECT_GT(half_lit("0.08"), 3 * hard);
}

}  // namespace
}  // namespace luminist
