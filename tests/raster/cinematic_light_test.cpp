// The formulas of shaders/light and styles/cinematic against the same formulas in double precision.
#include <algorithm>
#include <cmath>
#include <functional>

#include "raster/renderer_fixture.h"

namespace luminist {
namespace {

using DVec3 = glm::dvec3;

/// The cinematic light as its documentation says, written apart from the shader.
struct ReferenceLight {
  DVec3 position{0.0}, axis{0.0}, right{0.0}, up{0.0};
  double near_start = 0.0, near_width = 0.0, far_start = 0.0, far_width = 0.0;
  double exponent = 0.0, reference = 1.0;
  double w = 1.0, h = 1.0, edge = 0.1;

  static double smooth(double t) {
    const double c = std::clamp(t, 0.0, 1.0);
    return c * c * (3.0 - 2.0 * c);
  }
  /// Superellipse of degree 4: where the ray from the centre through (x, y) meets the curve with half axes a, b,
  /// as a multiple of (x, y).
  static double reach(double x, double y, double a, double b) {
    return std::pow(std::pow(std::abs(x) / a, 4.0) + std::pow(std::abs(y) / b, 4.0), -0.25);
  }
  [[nodiscard]] double shape(const DVec3& point) const {
    const DVec3 away = point - position;
    const double r = glm::length(away);
    const double depth = glm::dot(away, axis);
    if (depth <= 0.0) return 0.0;
    const double x = glm::dot(away, right) / depth;
    const double y = glm::dot(away, up) / depth;
    const double inner = reach(x, y, w, h);
    const double outer = reach(x, y, w + edge, h + edge);
    const double barn = 1.0 - smooth((1.0 - inner) / (outer - inner));
    return barn * smooth((r - near_start) / near_width) * (1.0 - smooth((r - far_start) / far_width));
  }
  [[nodiscard]] double strength(const DVec3& point) const {
    const double ratio = glm::length(point - position) / reference;
    return shape(point) * std::pow(2.0 / (1.0 + ratio * ratio), exponent / 2.0);
  }
};

class CinematicLightTest : public RendererTest {
 protected:
  void SetUp() override {
    RendererTest::SetUp();
    use_style("cinematic");
    state_->rig.lights.pop_back();
    drop_shadows();
    state_->rig.ambient.set_vec3(0, Vec3(0.0F));
    set("color", {1.0, 1.0, 1.0});
  }
  void set(const char* name, std::initializer_list<double> values) {
    int component = 0;
    for (const double v : values) light(0).set(param(light(0), name), component++, v);
  }
  void set_specular(double factor) { state_->style.set(param(state_->style, "specular"), 0, factor); }

  [[nodiscard]] ReferenceLight reference() {
    ParamBlock& block = light(0);
    const auto number = [&](const char* name, int c) { return block.get(param(block, name), c); };
    ReferenceLight light;
    light.position = DVec3(block.vec3(param(block, "position")));
    light.axis = glm::normalize(DVec3(block.vec3(param(block, "direction"))));
    light.right = glm::normalize(glm::cross(light.axis, DVec3(0.0, 1.0, 0.0)));
    light.up = glm::cross(light.right, light.axis);
    light.near_start = number("near_cutoff", 0), light.near_width = number("near_cutoff", 1);
    light.far_start = number("far_cutoff", 0), light.far_width = number("far_cutoff", 1);
    light.exponent = number("falloff_exponent", 0), light.reference = number("falloff_distance", 0);
    light.w = number("barn", 0), light.h = number("barn", 1), light.edge = number("barn", 2);
    return light;
  }
  /// Calls check(position, normal, view, albedo, F0, roughness, what the renderer says) for every visible pixel.
  using Check = std::function<void(std::size_t pixel, const Vec3& color)>;
  void for_each_pixel(const Check& check) {
    const SampleSet samples = all_pixels();
    const std::vector<Vec3> colors = evaluate({&*state_, 0}, samples);
    for (std::size_t i = 0; i < colors.size(); ++i) {
      if (renderer_->surface().object[i] != 0) check(i, colors[i]);
    }
  }
};

TEST_F(CinematicLightTest, MatteSurfacesShowTheLightsFormula) {
  set_specular(0.0);
  set("barn", {0.12, 0.2, 0.15});
  set("near_cutoff", {3.5, 1.0});
  set("far_cutoff", {6.0, 1.5});
  set("falloff_exponent", {1.7});
  set("falloff_distance", {4.0});
  const ReferenceLight wanted = reference();
  int partly = 0;
  for_each_pixel([&](std::size_t i, const Vec3& color) {
    const SurfaceBuffer& s = renderer_->surface();
    const DVec3 p(s.position[i]);
    const double nl = glm::dot(DVec3(s.normal[i]), glm::normalize(wanted.position - p));
    const double value = static_cast<double>(s.albedo[i].y) * std::max(nl, 0.0) * wanted.strength(p);
    // Single precision: positions about 10 units from the light, tangents good to 1e-6, slopes of the edges about 10.
    ASSERT_NEAR(static_cast<double>(color.y), value, 2e-5) << "pixel " << i;
    partly += wanted.shape(p) > 0.05 && wanted.shape(p) < 0.95 ? 1 : 0;
  });
  EXPECT_GT(partly, 200) << "the edges are in the picture";
}

TEST_F(CinematicLightTest, AWhiteDiffuserThatFacesTheLightShowsItsColour) {
  set_specular(0.0);
  set("color", {0.7, 0.2, 3.0});
  const ReferenceLight wanted = reference();
  const SurfaceBuffer& s = renderer_->surface();
  for_each_pixel([&](std::size_t i, const Vec3& color) {
    const double nl = glm::dot(DVec3(s.normal[i]), glm::normalize(wanted.position - DVec3(s.position[i])));
    if (wanted.shape(DVec3(s.position[i])) < 1.0 || nl < 0.5) return;
    EXPECT_NEAR(static_cast<double>(color.z / s.albedo[i].z) / nl, 3.0, 1e-4);
    EXPECT_NEAR(static_cast<double>(color.x / s.albedo[i].x) / nl, 0.7, 1e-4);
  });
}

TEST_F(CinematicLightTest, HighlightsAreGgxTimesPi) {
  set("barn", {3.0, 3.0, 0.1});
  set("position", {1.0, 3.0, 4.0});
  const ReferenceLight wanted = reference();
  const SurfaceBuffer& s = renderer_->surface();
  set_specular(0.0);
  const std::vector<Vec3> matte = evaluate({&*state_, 0}, all_pixels());
  set_specular(1.0);
  double brightest = 0.0;
  for_each_pixel([&](std::size_t i, const Vec3& color) {
    const DVec3 p(s.position[i]);
    const DVec3 n = glm::normalize(DVec3(s.normal[i]));
    const DVec3 l = glm::normalize(wanted.position - p);
    const DVec3 v = glm::normalize(DVec3(s.eye) - p);
    const DVec3 half = glm::normalize(l + v);
    const double nl = glm::dot(n, l);
    const double nv = glm::dot(n, v);
    if (nl <= 0.02 || nv <= 0.02 || wanted.shape(p) < 1.0) return;
    const double alpha2 = std::pow(std::max(std::pow(static_cast<double>(s.roughness[i]), 2.0), 0.01), 2.0);
    const double d = alpha2 / (kPi * std::pow(std::pow(glm::dot(n, half), 2.0) * (alpha2 - 1.0) + 1.0, 2.0));
    const auto lambda = [&](double c) { return 0.5 * (std::sqrt(1.0 + alpha2 * (1.0 / (c * c) - 1.0)) - 1.0); };
    const double g = 1.0 / (1.0 + lambda(nl) + lambda(nv));
    const double f0 = static_cast<double>(s.specular[i].y);
    const double f = f0 + (1.0 - f0) * std::pow(1.0 - glm::dot(half, l), 5.0);
    const double value = kPi * d * g * f / (4.0 * nl * nv) * nl;
    // The normal is kept to about 1e-6; at the peak (alpha2 = 0.04) the lobe magnifies that a hundredfold.
    ASSERT_NEAR(static_cast<double>(color.y - matte[i].y), value, 1e-4 + 1e-3 * value) << "pixel " << i;
    brightest = std::max(brightest, value);
  });
  EXPECT_GT(brightest, 0.1) << "a highlight is in the picture";
}

TEST_F(CinematicLightTest, ASofterLevelWidensTheBarnsEdgeOutwards) {
  set_specular(0.0);
  set("barn", {0.1, 0.1, 0.02});
  const SampleSet samples = all_pixels();
  Softness softness;
  softness.light_edge = 0.2F;
  const std::vector<Vec3> sharp = evaluate({&*state_, 0}, samples);
  const std::vector<Vec3> soft = evaluate({&*state_, 0}, samples, softness);
  set("barn", {0.1, 0.1, 0.2});
  const std::vector<Vec3> wide = evaluate({&*state_, 0}, samples);
  EXPECT_EQ(soft, wide);
  int more = 0;
  for (std::size_t i = 0; i < soft.size(); ++i) {
    EXPECT_GE(soft[i].y, sharp[i].y - 1e-6F);
    more += soft[i].y > sharp[i].y + 0.05F ? 1 : 0;
  }
  EXPECT_GT(more, 100);
}

TEST_F(CinematicLightTest, ALightThatPointsStraightDownChangesSmoothlyWithItsDirection) {
  set_specular(0.0);
  set("position", {0.0, 5.0, 0.0});
  set("barn", {0.3, 0.15, 0.1});
  const SampleSet samples = all_pixels();
  set("direction", {0.0, -1.0, 0.0});
  const std::vector<Vec3> down = evaluate({&*state_, 0}, samples);
  for (const Vec3& tilt : {Vec3(1e-3F, 0, 0), Vec3(-1e-3F, 0, 0), Vec3(0, 0, 1e-3F), Vec3(0, 0, -1e-3F)}) {
    light(0).set_vec3(param(light(0), "direction"), glm::normalize(Vec3(0.0F, -1.0F, 0.0F) + tilt));
    const std::vector<Vec3> tilted = evaluate({&*state_, 0}, samples);
    // 0.001 of tilt turns the frame by at most 0.012; edges have a slope of 1.5 / 0.1 per tangent.
    for (std::size_t i = 0; i < down.size(); ++i) ASSERT_NEAR(tilted[i].y, down[i].y, 0.15F) << "pixel " << i;
  }
}

TEST_F(CinematicLightTest, APointLightShinesEverywhereAndFadesWithDistance) {
  set_specular(0.0);
  Light bulb = make_light(*types_, "point", "bulb", renderer_->frame()).value();
  const Vec3 place(-1.5F, 1.5F, 1.5F);
  bulb.params.set_vec3(*bulb.params.schema().by_role("position"), place);
  bulb.params.set(param(bulb.params, "shadow_density"), 0, 0.0);
  bulb.params.set(param(bulb.params, "falloff_exponent"), 0, 2.0);
  bulb.params.set(param(bulb.params, "falloff_distance"), 0, 1.5);
  state_->rig.lights[0] = bulb;
  const SurfaceBuffer& s = renderer_->surface();
  for_each_pixel([&](std::size_t i, const Vec3& color) {
    const DVec3 to_light = DVec3(place) - DVec3(s.position[i]);
    const double r = glm::length(to_light);
    if (r > 5.0) return;
    const double nl = std::max(0.0, glm::dot(DVec3(s.normal[i]), to_light) / r);
    const double value = static_cast<double>(s.albedo[i].y) * nl * 2.0 / (1.0 + r * r / 2.25);
    ASSERT_NEAR(static_cast<double>(color.y), value, 1e-5);
  });
}

}  // namespace
}  // namespace luminist
