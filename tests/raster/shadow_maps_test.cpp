#include "raster/shadow_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "raster/shadow_stage.h"
#include "rays/ray_scene.h"

namespace luminist {
namespace {

using test::add;
using test::laid_down;
using test::looking;
using test::moved;

/// A square of half side 0.5 at height 1 over a floor at height 0, and a camera that looks down past it.
Scene square_over_floor() {
  Scene scene;
  add(scene, test::quad_mesh(), "floor", laid_down(0.0F, 10.0F));
  add(scene, test::quad_mesh(), "square", laid_down(1.0F, 0.5F));
  return scene;
}

/// Signed distance in the plane of a floor point to the outline of the square's shadow; negative inside.
float distance_to_shadow(const Vec3& p, const Vec3& light) {
  const float scale = light.y / (light.y - 1.0F);  // from height 1 to the floor, seen from the light
  const Vec2 center = Vec2(light.x, light.z) * (1.0F - scale);
  const Vec2 beyond = glm::abs(Vec2(p.x, p.z) - center) - Vec2(0.5F * scale);
  return std::max(beyond.x, beyond.y);
}

void expect_square_shadow(const Stage& stage, const std::vector<float>& lit, const ShadowLight& light) {
  const SurfaceBuffer& surface = stage.deep.surface();
  std::size_t dark = 0;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] != 1) continue;
    const float away = distance_to_shadow(surface.position[i], light.position);
    const Vec3 way = surface.position[i] - light.position;
    const float distance = glm::length(way);
    // The filter's radius and two texels, seen on the floor from a slanting light.
    const float blur = distance * (light.softness + 2.0F * light.texel()) * distance / light.position.y;
    if (away > blur) {
      EXPECT_GT(lit[i], 0.999F) << away;
    }
    if (away < -blur) {
      EXPECT_LT(lit[i], 0.001F) << away;
    }
    dark += away < -blur ? 1 : 0;
  }
  EXPECT_GT(dark, 300U);
}

TEST_F(ShadowMapsTest, ShadowOfASquareFallsWhereGeometrySays) {
  Stage stage(*device_, square_over_floor(), looking(Vec3(0.5F, 6, 5), Vec3(0.5F, 0, 0)), 160, 120);
  const ShadowLight light = spot(Vec3(-2, 4, 1), Vec3(0, 0.5F, 0));
  expect_square_shadow(stage, stage.visibility(light), light);
}

TEST_F(ShadowMapsTest, PointLightCastsTheSameShadow) {
  Stage stage(*device_, square_over_floor(), looking(Vec3(0.5F, 6, 5), Vec3(0.5F, 0, 0)), 160, 120);
  const ShadowLight light = cube(Vec3(-2, 4, 1));
  expect_square_shadow(stage, stage.visibility(light), light);
}

TEST_F(ShadowMapsTest, EdgeOfAShadowIsHalfLit) {
  // Seen from afar under the square, so that pixels are alike on both sides of the edge.
  Stage stage(*device_, square_over_floor(), looking(Vec3(20, 12, 0), Vec3(0.6F, 0, 0), 0.06F), 300, 300);
  const ShadowLight light = spot(Vec3(0, 5, 0), Vec3(0), 0.5F, 0.02F, 512);
  const std::vector<float> lit = stage.visibility(light);
  const SurfaceBuffer& surface = stage.deep.surface();
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    const Vec3& p = surface.position[i];
    // A strip across one side of the shadow, symmetric around its outline and wider than the filter.
    if (surface.object[i] != 1 || std::abs(p.z) > 0.3F || p.x < 0.0F) continue;
    if (std::abs(distance_to_shadow(p, light.position)) > 0.15F) continue;
    sum += lit[i];
    count += 1.0;
  }
  EXPECT_GT(count, 500.0);
  // Pixels and texels of the strip are not symmetric to the last: a tenth of a texel's width over the strip's.
  EXPECT_NEAR(sum / count, 0.5, 0.02);
}

/// Share of the pixels that face the light by more than `cosine` and are darker than they should be; nothing is in
/// between.
double acne(const Stage& stage, const std::vector<float>& lit, const ShadowLight& light, float cosine) {
  const SurfaceBuffer& surface = stage.deep.surface();
  double dark = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == 0) continue;
    const Vec3 to_light = glm::normalize(light.position - surface.position[i]);
    if (glm::dot(to_light, surface.normal[i]) < cosine) continue;
    count += 1.0;
    dark += lit[i] < 0.98F ? 1.0 : 0.0;
  }
  EXPECT_GT(count, 1000.0);
  return dark / count;
}

TEST_F(ShadowMapsTest, SphereDoesNotShadowItselfEvenAtGrazingAngles) {
  Scene scene;
  add(scene, test::sphere_mesh(1.0F, 128), "ball");
  Stage stage(*device_, scene, looking(Vec3(0, 0, 5), Vec3(0), 0.5F), 256, 256);
  for (const Vec3& from : {Vec3(0, 4, 2), Vec3(4, 1, 0), Vec3(-3, 2, 3)}) {
    const ShadowLight light = spot(from, Vec3(0), 0.5F);
    // A facet of 1.4 degrees turns away from the light where the smooth normal still sees it by a cosine of 0.02.
    EXPECT_LT(acne(stage, stage.visibility(light), light, 0.1F), 1e-4);
    const ShadowLight point = cube(from);
    EXPECT_LT(acne(stage, stage.visibility(point), point, 0.1F), 1e-4);
  }
}

TEST_F(ShadowMapsTest, FloorDoesNotShadowItselfUnderALowLight) {
  Scene scene;
  add(scene, test::quad_mesh(), "floor", laid_down(0.0F, 5.0F));
  Stage stage(*device_, scene, looking(Vec3(0, 4, 6), Vec3(0)), 160, 120);
  for (const float softness : {0.004F, 0.02F, 0.1F}) {
    const ShadowLight light = spot(Vec3(-6, 0.8F, 0.3F), Vec3(0), 0.7F, softness, softness < 0.01F ? 1024 : 256);
    EXPECT_EQ(acne(stage, stage.visibility(light), light, 0.08F), 0.0) << softness;
  }
}

TEST_F(ShadowMapsTest, ShadowStartsAtTheFootOfABox) {
  Scene scene;
  add(scene, test::quad_mesh(), "floor", laid_down(0.0F, 10.0F));
  add(scene, test::box_mesh(), "box", moved(Vec3(0, 0.5F, 0), Vec3(0.5F)));
  Stage stage(*device_, scene, looking(Vec3(4, 6, 0.5F), Vec3(0.5F, 0, 0)), 320, 240);
  const ShadowLight light = spot(Vec3(-4, 4, 0), Vec3(0), 0.5F);
  const std::vector<float> lit = stage.visibility(light);
  const SurfaceBuffer& surface = stage.deep.surface();
  const float texel = light.texel() * glm::length(light.position - Vec3(0.5F, 0, 0));
  std::size_t checked = 0;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    const Vec3& p = surface.position[i];
    if (surface.object[i] != 1 || std::abs(p.z) > 0.3F) continue;
    // From the wall in shadow (x = 0.5) on: two texels, for the push along the normal, and not the filter.
    if (p.x < 0.5F + 2.0F * texel || p.x > 0.9F) continue;
    EXPECT_LT(lit[i], 0.02F) << p.x;
    ++checked;
  }
  EXPECT_GT(checked, 100U);
}

TEST_F(ShadowMapsTest, RoomAroundAPointLightIsLitWithoutSeams) {
  Scene scene;
  add(scene, test::box_mesh(), "room", moved(Vec3(0), Vec3(3, 2, 4)));
  Stage stage(*device_, scene, looking(Vec3(0, 0.3F, 3.5F), Vec3(0.4F, -0.2F, 0), 1.4F), 256, 192);
  const std::vector<float> lit = stage.visibility(cube(Vec3(0.3F, 0.2F, 0.1F)));
  const auto darkened = std::count_if(lit.begin(), lit.end(), [](float v) { return v < 0.999F; });
  // In the very corners a texel of the other wall, met at a grazing angle, may win one of the sixteen comparisons.
  EXPECT_LT(static_cast<double>(darkened) / static_cast<double>(lit.size()), 2e-4);
  EXPECT_GT(*std::min_element(lit.begin(), lit.end()), 0.9F);
}

TEST_F(ShadowMapsTest, ShadowsAcrossCubeFacesAgreeWithRays) {
  Scene scene;
  add(scene, test::box_mesh(), "room", moved(Vec3(0), Vec3(3)));
  add(scene, test::sphere_mesh(0.5F, 48), "ball", moved(Vec3(0.8F, 0.8F, 0)));  // on the border between +x and +y
  Object& egg = add(scene, test::sphere_mesh(0.4F, 48), "egg", moved(Vec3(-0.9F, 0.2F, -0.9F), Vec3(-1, 1.2F, 1)));
  egg.shadow_mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(test::sphere_mesh(0.3F, 6));
  Stage stage(*device_, scene, looking(Vec3(-2, -2, 2.5F), Vec3(2, 2, 0), 1.2F), 160, 160);
  const ShadowLight light = cube(Vec3(0), 0.02F);
  const std::vector<float> lit = stage.visibility(light);
  LUM_ASSERT_OK(const RayScene rays, RayScene::create(scene));
  const SurfaceBuffer& surface = stage.deep.surface();
  double sum = 0.0;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    const float slack = rays.shadow_slack(surface.object[i] - 1);
    const Vec3 receiver = shadow_receiver(light, surface.position[i], surface.normal[i], slack);
    std::vector<Segment> segments;
    for (int k = 0; k < 64; ++k) {
      segments.push_back({light.position, shadow_tap(light, receiver, surface.normal[i], vogel_disc(k, 64))});
    }
    std::vector<unsigned char> blocked(segments.size());
    rays.occluded(segments, blocked);
    const auto free = static_cast<float>(std::count(blocked.begin(), blocked.end(), 0));
    float traced = free / 64.0F;
    if (slack > 0.0F) {
      const Vec3 to_light = glm::normalize(light.position - surface.position[i]);
      traced *= share_before_own_shadow(glm::dot(to_light, surface.normal[i]));
    }
    const float difference = std::abs(traced - lit[i]);
    // Half a texel of the map is a twentieth of this filter's width; 16 comparisons against 64 rays.
    EXPECT_LT(difference, 0.15F) << i % 160 << "," << i / 160;
    sum += difference;
  }
  EXPECT_LT(sum / static_cast<double>(surface.pixels()), 0.002);
}

/// A box in the air over a floor; its own mesh, or that of another size in its stead.
Scene box_over_floor(float half, float shadow_half) {
  Scene scene;
  add(scene, test::quad_mesh(), "floor", laid_down(0.0F, 10.0F));
  Mesh shadow = test::box_mesh();
  for (Vec3& p : shadow.positions) p *= shadow_half / half;
  Object& box = add(scene, test::box_mesh(), "box", moved(Vec3(0, 1.5F, 0), Vec3(half)));
  if (shadow_half == half) return scene;
  box.shadow_mesh = static_cast<int>(scene.meshes.size());
  scene.meshes.push_back(shadow);
  return scene;
}

TEST_F(ShadowMapsTest, ShadowIsThatOfTheShadowMesh) {
  const Camera camera = looking(Vec3(0.5F, 6, 5), Vec3(0.5F, 0, 0));
  for (const auto& [half, shadow_half] : {std::pair(0.6F, 0.3F), std::pair(0.3F, 0.6F)}) {
    Stage proxy(*device_, box_over_floor(half, shadow_half), camera, 160, 120);
    Stage itself(*device_, box_over_floor(shadow_half, shadow_half), camera, 160, 120);
    for (const ShadowLight& light : {spot(Vec3(-2, 4, 1), Vec3(0, 0.5F, 0)), cube(Vec3(-2, 4, 1))}) {
      const std::vector<float> lit = proxy.visibility(light);
      const std::vector<float> expected = itself.visibility(light);
      std::size_t floor = 0;
      std::size_t dark = 0;
      for (std::size_t i = 0; i < lit.size(); ++i) {
        if (proxy.deep.surface().object[i] != 1 || itself.deep.surface().object[i] != 1) continue;
        // The same outline and the same side of it: the box hangs far over the floor.
        EXPECT_EQ(lit[i], expected[i]) << i % 160 << "," << i / 160;
        dark += lit[i] < 0.01F ? 1 : 0;
        ++floor;
      }
      EXPECT_GT(floor, 5000U);
      EXPECT_GT(dark, 200U);
    }
  }
}

TEST_F(ShadowMapsTest, ShadowIsThatOfTheShadowMeshWhereMeshesAreUnwrapped) {
  const Camera camera = looking(Vec3(0.5F, 6, 5), Vec3(0.5F, 0, 0));
  const ShadowLight light = spot(Vec3(-2, 4, 1), Vec3(0, 0.5F, 0));
  Stage plain(*device_, box_over_floor(0.3F, 0.6F), camera, 80, 60);
  Stage unwrapped(*device_, box_over_floor(0.3F, 0.6F), camera, 80, 60, true);
  EXPECT_EQ(unwrapped.visibility(light), plain.visibility(light));
}

/// A ball whose shadow is cast by a coarse one.
Scene ball_with_coarse_shadow(float shadow_radius) {
  Scene scene;
  Object& ball = add(scene, test::sphere_mesh(1.0F, 96), "ball");
  ball.shadow_mesh = 1;
  scene.meshes.push_back(test::sphere_mesh(shadow_radius, 6));
  return scene;
}

TEST_F(ShadowMapsTest, ShadowMeshNeverDarkensTheLitSideOfAConvexObjectAndLeavesTheOtherDark) {
  // Inside, across and around the ball: a coarse sphere of radius 1 has its corners on the ball and its faces inside.
  for (const float radius : {0.7F, 1.0F, 1.02F, 1.2F}) {
    Stage stage(*device_, ball_with_coarse_shadow(radius), looking(Vec3(0, 0, 5), Vec3(0), 0.5F), 256, 256);
    const SurfaceBuffer& surface = stage.deep.surface();
    for (const Vec3& from : {Vec3(0, 0.1F, 4), Vec3(0, 4, 2), Vec3(4, 1, 0), Vec3(-3, 2, 0.5F)}) {
      for (const ShadowLight& light : {spot(from, Vec3(0), 0.5F), cube(from)}) {
        const std::vector<float> lit = stage.visibility(light);
        // Corners that stand out of the ball on its far side may just show where light grazes it.
        EXPECT_LE(acne(stage, lit, light, 0.1F), radius == 1.02F ? 5e-4 : 0.0) << radius;
        EXPECT_EQ(acne(stage, lit, light, 0.3F), 0.0) << radius;
        for (std::size_t i = 0; i < lit.size(); ++i) {
          const Vec3 to_light = glm::normalize(from - surface.position[i]);
          if (surface.object[i] == 0 || glm::dot(to_light, surface.normal[i]) > -0.05F) continue;
          EXPECT_EQ(lit[i], 0.0F);
        }
      }
    }
  }
}

TEST_F(ShadowMapsTest, WhatTheMapDoesNotSeeIsLit) {
  Stage stage(*device_, square_over_floor(), looking(Vec3(0, 8, 0.01F), Vec3(0), 1.0F), 128, 128);
  const ShadowLight aside = spot(Vec3(0, 3, 0), Vec3(4, 0, 0), 0.2F);  // the square is outside of its map
  const ShadowLight upwards = spot(Vec3(0, 3, 0), Vec3(0, 9, 0));
  const ShadowLight none;
  for (const std::vector<float>& lit : stage.visibility(std::vector{aside, upwards, none})) {
    EXPECT_EQ(std::count(lit.begin(), lit.end(), 1.0F), static_cast<std::ptrdiff_t>(lit.size()));
  }
}

TEST_F(ShadowMapsTest, BackgroundIsLit) {
  Scene scene;
  add(scene, test::sphere_mesh(0.2F, 16), "ball");
  Stage stage(*device_, scene, looking(Vec3(0, 0, 5), Vec3(0)), 32, 32);
  EXPECT_EQ(stage.visibility(spot(Vec3(0, 3, 0), Vec3(0)))[0], 1.0F);
}

TEST_F(ShadowMapsTest, UnchangedLightKeepsItsMapAndItsVisibility) {
  Stage stage(*device_, square_over_floor(), looking(Vec3(0, 8, 0.01F), Vec3(0)), 64, 64);
  const ShadowLight first = spot(Vec3(0, 4, 1), Vec3(0));
  ShadowLight second = spot(Vec3(2, 4, 0), Vec3(0));
  const auto before = stage.visibility(std::vector{first, second});
  EXPECT_EQ(stage.maps.maps_drawn(), 2U);
  const double lookups = stage.maps.lookups();
  stage.visibility(std::vector{first, second});
  EXPECT_EQ(stage.maps.lookups(), lookups);
  second.position.x += 0.5F;
  const auto after = stage.visibility(std::vector{first, second});
  EXPECT_EQ(stage.maps.maps_drawn(), 3U);
  EXPECT_EQ(stage.maps.lookups(), lookups + static_cast<double>(stage.deep.sample_count()));
  EXPECT_EQ(after[0], before[0]);
  EXPECT_NE(after[1], before[1]);
}

TEST_F(ShadowMapsTest, LightsCanBeAddedAndTakenAwayAndReordered) {
  Stage stage(*device_, square_over_floor(), looking(Vec3(0, 8, 0.01F), Vec3(0)), 64, 64);
  const ShadowLight a = spot(Vec3(0, 4, 1), Vec3(0));
  const ShadowLight b = spot(Vec3(2, 4, 0), Vec3(0));
  const auto both = stage.visibility(std::vector{a, b});
  EXPECT_EQ(stage.visibility(std::vector{b})[0], both[1]);
  EXPECT_EQ(stage.visibility(std::vector{b, a})[1], both[0]);
  EXPECT_TRUE(stage.visibility(std::vector<ShadowLight>{}).empty());
}

TEST_F(ShadowMapsTest, EqualLightsShareOneMap) {
  Stage stage(*device_, square_over_floor(), looking(Vec3(0, 8, 0.01F), Vec3(0)), 64, 64);
  const ShadowLight key = spot(Vec3(0, 4, 1), Vec3(0));
  const auto rows = stage.visibility(std::vector{key, key, key});
  EXPECT_EQ(stage.maps.maps_drawn(), 1U);
  EXPECT_EQ(rows[0], rows[2]);
  EXPECT_LT(*std::min_element(rows[2].begin(), rows[2].end()), 0.01F);
}

TEST_F(ShadowMapsTest, MirroredAndInsideOutMeshesCastShadowsToo) {
  Scene scene;
  add(scene, test::quad_mesh(), "floor", laid_down(0.0F, 10.0F));
  Mesh square = test::quad_mesh();
  for (auto& triangle : square.triangles) std::swap(triangle[1], triangle[2]);
  add(scene, square, "square", laid_down(1.0F, 0.5F) * moved(Vec3(0), Vec3(-1, 1, 1)));
  Stage stage(*device_, scene, looking(Vec3(0.5F, 6, 5), Vec3(0.5F, 0, 0)), 160, 120);
  const ShadowLight light = spot(Vec3(-2, 4, 1), Vec3(0, 0.5F, 0));
  expect_square_shadow(stage, stage.visibility(light), light);
}

}  // namespace
}  // namespace luminist
