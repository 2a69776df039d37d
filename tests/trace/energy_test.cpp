// What is known of light without any picture: furnaces, form factors, mirrors.
#include <cmath>

#include "trace/box_scene.h"
#include "trace/path_sampler.h"

namespace luminist {
namespace {

/// Mean of a channel and the standard error of that mean, over pixels that all see the same.
struct Mean {
  double value = 0.0;
  double error = 0.0;
};
Mean mean_of(const Image& image, int channel = 0) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const auto v = static_cast<double>(image.rgb(i)[channel]);
    sum += v, squares += v * v;
  }
  const auto n = static_cast<double>(image.pixels());
  return {sum / n, std::sqrt(std::max(0.0, squares / n - sum / n * sum / n) / n)};
}

/// Of a point under the middle of a parallel square of half side a at distance h (the four corner rectangles of
/// Hottel's formula).
double point_form_factor(double a, double h) {
  const double x = a / h;
  const double root = std::sqrt(1.0 + x * x);
  return 4.0 / (2.0 * kPi) * 2.0 * x / root * std::atan(x / root);
}

TEST(Furnace, AFlatWhiteDiffuserShowsExactlyWhatIsAllAround) {
  Scene scene;
  add_rectangle(scene, {-9.0F, -9.0F, 0.0F}, {18.0F, 0.0F, 0.0F}, {0.0F, 18.0F, 0.0F},
                add_material(scene, matte(Vec3(1.0F))));
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(scene, camera_at({0.0F, 0.0F, 1.0F}, 0.8F), 8, 8));
  shot.set("style/highlights=0");
  shot.set("style/samples=4");
  shot.set("ambient/color=0.7,0.7,0.7");
  const Image picture = shot.picture();
  // Every path reflects all and escapes; only sums round.
  for (const float value : picture.data) EXPECT_NEAR(value, 0.7F, 1e-5F);
}

TEST(Furnace, AWhiteValleyShowsWhatIsAllAroundOnAverage) {
  Scene scene;
  const int white = add_material(scene, matte(Vec3(1.0F)));
  add_rectangle(scene, {-1.0F, -1.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}, white);
  add_rectangle(scene, {-1.0F, -1.0F, 0.0F}, {0.0F, 2.0F, 0.0F}, {0.0F, 0.0F, 2.0F}, white);
  add_rectangle(scene, {-1.0F, -1.0F, 0.0F}, {0.0F, 0.0F, 2.0F}, {2.0F, 0.0F, 0.0F}, white);
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(scene, camera_at({0.0F, 0.0F, 1.9F}, 0.7F), 24, 24));
  shot.set("style/highlights=0");
  shot.set("style/bounces=32");
  shot.set("ambient/color=1,1,1");
  const Mean mean = mean_of(shot.picture());
  // A path that is still inside after 32 surfaces is lost; that is one in 10^9 here.
  EXPECT_NEAR(mean.value, 1.0, 4.0 * mean.error + 1e-6);
  EXPECT_LT(mean.error, 0.01) << "the bound says something";
}

TEST(Furnace, AClosedShiningRoomHasTheGeometricSumOfItsReflections) {
  Scene scene;
  add_cube(scene, add_material(scene, matte(Vec3(0.5F), Vec3(1.0F))));
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(scene, camera_at({0.1F, 0.2F, 0.9F}, 1.2F), 16, 16));
  shot.set("style/highlights=0");
  for (const int bounces : {1, 2, 6}) {
    shot.set("style/bounces=" + std::to_string(bounces));
    const Mean mean = mean_of(shot.picture());
    // 1 + 1/2 + 1/4 + ...: emission is seen directly and over 1 .. bounces surfaces.
    // Corners make bright paths that are rare, so 256 pixels understate the spread: six of it.
    EXPECT_NEAR(mean.value, 2.0 - std::pow(0.5, bounces), 6.0 * mean.error + 1e-6) << bounces << " bounces";
    EXPECT_LT(mean.error, 0.02);
  }
}

TEST(Furnace, MetalsReflectAllUnlessTheyAreRoughAndNeverMore) {
  for (const float roughness : {0.0F, 0.1F, 0.5F, 1.0F}) {
    Scene scene;
    Material metal = matte(Vec3(1.0F));
    metal.metallic = 1.0F;
    metal.roughness = roughness;
    add_rectangle(scene, {-9.0F, -9.0F, 0.0F}, {18.0F, 0.0F, 0.0F}, {0.0F, 18.0F, 0.0F}, add_material(scene, metal));
    LUM_ASSERT_OK(const PathShot shot, PathShot::create(scene, camera_at({0.0F, 0.0F, 1.0F}, 0.5F), 16, 16));
    shot.set("ambient/color=1,1,1");
    const Mean mean = mean_of(shot.picture());
    // Light that is reflected twice between the grooves is not modelled. Seen from above, 1 - log 2 is left of it at
    // roughness 1, where D = 1 / pi and V = 1 / (2 (1 + cosine)); the eye sees up to 0.35 radians beside that.
    const double least = roughness < 0.2F ? 0.98 : roughness < 1.0F ? 0.85 : 1.0 - std::log(2.0) - 0.01;
    EXPECT_GT(mean.value, least - 4.0 * mean.error) << roughness;
    EXPECT_LT(mean.value, (roughness < 1.0F ? 1.0 : least + 0.02) + 4.0 * mean.error + 1e-5) << roughness;
  }
}

TEST(Reflection, SamplesWhatItEvaluates) {
  SurfacePoint point;
  point.normal = point.face = Vec3(0.0F, 0.0F, 1.0F);
  point.albedo = Vec3(0.5F);
  point.specular = Vec3(0.3F);
  for (const float roughness : {0.2F, 0.6F, 1.0F}) {
    point.roughness = roughness;
    const Reflection surface = Reflection::create(point, glm::normalize(Vec3(0.8F, 0.1F, 0.5F)), 1.0F);
    constexpr std::uint32_t kCount = 1U << 18;
    double sampled = 0.0;
    double uniform = 0.0;
    double density = 0.0;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const PathSampler sampler(3, 1, i);
      const Bounce bounce = sample(surface, sampler.pair(0).x, sampler.pair(1));
      sampled += static_cast<double>(bounce.weight.x);
      const Vec2 place = sampler.pair(2);
      const float radius = std::sqrt(1.0F - place.x * place.x);
      const float angle = 2.0F * static_cast<float>(kPi) * place.y;
      const Scattered there = evaluate(surface, {radius * std::cos(angle), radius * std::sin(angle), place.x});
      uniform += 2.0 * kPi * static_cast<double>(there.value.x);
      density += 2.0 * kPi * static_cast<double>(there.pdf);
    }
    // The uniform directions are the noisy side: lobes of width alpha >= 0.04 hold some 400 of them.
    EXPECT_NEAR(sampled / kCount, uniform / kCount, 0.004) << roughness;
    EXPECT_LT(density / kCount, 1.005) << "a density; what is sampled below the horizon is missing";
    EXPECT_GT(density / kCount, 0.8);
  }
}

TEST(Reflection, IsTheSameWithEyeAndLightExchanged) {
  SurfacePoint point;
  point.normal = point.face = Vec3(0.0F, 0.0F, 1.0F);
  point.albedo = Vec3(0.5F, 0.4F, 0.3F);
  point.specular = Vec3(0.04F);
  point.roughness = 0.4F;
  const Vec3 a = glm::normalize(Vec3(0.8F, 0.1F, 0.5F));
  const Vec3 b = glm::normalize(Vec3(-0.3F, 0.4F, 0.9F));
  const Vec3 one = evaluate(Reflection::create(point, a, 1.0F), b).value / b.z;
  const Vec3 other = evaluate(Reflection::create(point, b, 1.0F), a).value / a.z;
  EXPECT_NEAR(one.x, other.x, 1e-6F);
  EXPECT_NEAR(one.z, other.z, 1e-6F);
}

/// A white floor far and wide, seen from above at the origin, 0.02 wide.
Scene floor_scene() {
  Scene scene;
  add_rectangle(scene, {-5.0F, 0.0F, 5.0F}, {10.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -10.0F},
                add_material(scene, matte(Vec3(1.0F))));
  return scene;
}

TEST(FormFactor, OfASquarePanelOverAPoint) {
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(floor_scene(), camera_above({0.0F, 0.5F, 0.0F}, 0.04F), 4, 4));
  shot.set("style/highlights=0");
  shot.set("style/bounces=1");
  shot.set("style/samples=512");
  shot.add_light("area", "panel");
  shot.set("lights/panel/direction=0,-1,0");
  shot.set("lights/panel/falloff_distance=1");
  const auto lift = 1e-3 * static_cast<double>(shot.renderer->frame().radius);
  for (const double height : {0.6, 1.0, 2.0}) {
    for (const double side : {0.2, 2.0}) {
      shot.set("lights/panel/position=0," + std::to_string(height) + ",0");
      shot.set("lights/panel/size=" + std::to_string(side));
      const double radiance = kPi / (side * side);
      const double wanted = radiance * point_form_factor(0.5 * side, height - lift);
      // 16 pixels of 512 scrambled samples, within 0.01 of the point: 0.2 % of noise and of size.
      EXPECT_NEAR(mean_of(shot.picture()).value, wanted, 0.004 * wanted) << height << " " << side;
    }
  }
}

TEST(FormFactor, OfAShiningSquareInTheSceneOverAPoint) {
  Scene scene = floor_scene();
  add_rectangle(scene, {-0.5F, 1.0F, -0.5F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F},
                add_material(scene, matte(Vec3(0.0F), Vec3(3.0F))));
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(scene, camera_above({0.0F, 0.5F, 0.0F}, 0.04F), 4, 4));
  shot.set("style/highlights=0");
  shot.set("style/bounces=1");
  shot.set("style/samples=512");
  const double wanted = 3.0 * point_form_factor(0.5, 1.0);
  EXPECT_NEAR(mean_of(shot.picture()).value, wanted, 0.004 * wanted) << "as for the panel";
}

TEST(FormFactor, BetweenTwoParallelUnitSquares) {
  // The eye sees the floor's unit square from 0.5 above it; the panel is behind the eye and blocks nothing.
  LUM_ASSERT_OK(
      const PathShot shot,
      PathShot::create(floor_scene(), camera_above({0.0F, 0.5F, 0.0F}, 0.5F * static_cast<float>(kPi)), 16, 16));
  shot.set("style/highlights=0");
  shot.set("style/bounces=1");
  shot.add_light("area", "panel");
  shot.set("lights/panel/direction=0,-1,0");
  shot.set("lights/panel/falloff_distance=1");
  shot.set("lights/panel/size=1");
  const float lift = 1e-3F * shot.renderer->frame().radius;
  shot.set("lights/panel/position=0," + std::to_string(1.0F + lift) + ",0");
  // F = 0.199825 for unit squares at unit distance (closed form; Howell, configuration C-11), radiance pi.
  EXPECT_NEAR(mean_of(shot.picture()).value, kPi * 0.199825, 0.002 * kPi * 0.2) << "256 pixels of 64 samples";
}

TEST(Mirror, ShowsAPanelAsBrightAsItIsTimesItsReflectance) {
  Scene scene;
  Material mirror = matte({0.9F, 0.8F, 0.5F});
  mirror.metallic = 1.0F;
  mirror.roughness = 0.0F;
  add_rectangle(scene, {-1.0F, -1.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 2.0F, 0.0F}, add_material(scene, mirror));
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(scene, camera_at({0.0F, 0.0F, 1.0F}, 0.2F), 4, 4));
  shot.set("style/samples=2");
  shot.add_light("area", "panel");
  shot.set("lights/panel/direction=0,0,-1");
  shot.set("lights/panel/position=0,0,2");
  shot.set("lights/panel/size=2");
  shot.set("lights/panel/falloff_distance=1");
  shot.set("lights/panel/color=1,2,3");
  const Image picture = shot.picture();
  // Radiance pi / 4 a unit of colour; Schlick adds (1 - 0.995)^5, which is nothing, and a metal scatters nothing else.
  const auto radiance = static_cast<float>(kPi / 4.0);
  for (std::size_t i = 0; i < picture.pixels(); ++i) {
    EXPECT_NEAR(picture.rgb(i).x, 0.9F * radiance, 1e-4F);
    EXPECT_NEAR(picture.rgb(i).y, 0.8F * 2.0F * radiance, 1e-4F);
    EXPECT_NEAR(picture.rgb(i).z, 0.5F * 3.0F * radiance, 1e-4F);
  }
}

TEST(Mirror, IsSeenByTheEyeAsAPanelIsAndFromBehindItIsNotSeen) {
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(floor_scene(), camera_above({0.0F, 2.0F, 0.0F}, 0.2F), 4, 4));
  shot.set("style/samples=2");
  shot.set("style/bounces=1");
  shot.add_light("area", "panel");
  shot.set("lights/panel/position=0,1,0");
  shot.set("lights/panel/size=1");
  shot.set("lights/panel/falloff_distance=1");
  shot.set("lights/panel/direction=0,1,0");
  const Image from_front = shot.picture();
  for (const float value : from_front.data)
    EXPECT_NEAR(value, static_cast<float>(kPi), 1e-4F) << "nothing of the floor";
  shot.set("lights/panel/direction=0,-1,0");
  EXPECT_LT(mean_of(shot.picture()).value, 1.5) << "the floor, seen through the panel's back";
}

}  // namespace
}  // namespace luminist
