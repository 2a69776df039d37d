// What a light does not reach is in no shadow map (raster/shadow_maps.h).
#include <cmath>
#include <random>
#include <string>

#include "raster/shadow_stage.h"

namespace luminist {
namespace {

using test::add;
using test::laid_down;
using test::looking;
using test::moved;

TEST_F(ShadowMapsTest, WhatALightDoesNotReachIsLeftOutWithoutATrace) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(-1.0F, 1.0F);
  Scene apart;
  Mesh whole;
  for (int i = 0; i < 24; ++i) {
    const Mat4 place = i == 0 ? laid_down(0.0F, 6.0F)
                              : moved(Vec3(3.0F * number(random), 1.0F + number(random), 3.0F * number(random))) *
                                    laid_down(0.0F, 0.3F);
    const Mesh square = test::quad_mesh();
    add(apart, square, "square " + std::to_string(i), place);
    const auto first = static_cast<std::uint32_t>(whole.positions.size());
    for (const Vec3& position : square.positions) whole.positions.emplace_back(place * Vec4(position, 1.0F));
    whole.normals.insert(whole.normals.end(), square.positions.size(), Vec3(0.0F, 1.0F, 0.0F));
    for (const auto& [a, b, c] : square.triangles) whole.triangles.push_back({first + a, first + b, first + c});
  }
  Scene together;  // one box, which every light reaches
  add(together, whole, "squares", Mat4(1.0F));
  const Camera camera = looking(Vec3(0, 9, 0.01F), Vec3(0));
  Stage separate(*device_, apart, camera, 96, 96);
  Stage joined(*device_, together, camera, 96, 96);
  for (int i = 0; i < 30; ++i) {
    const Vec3 from(4.0F * number(random), 2.5F + number(random), 4.0F * number(random));
    const Vec3 at(2.0F * number(random), 0.0F, 2.0F * number(random));
    const ShadowLight light = i % 5 == 4 ? cube(from) : spot(from, at, 0.1F + 0.2F * std::abs(number(random)));
    const std::vector<float> one = separate.visibility(light);
    const std::vector<float> other = joined.visibility(light);
    std::size_t apart_pixels = 0;
    for (std::size_t pixel = 0; pixel < one.size(); ++pixel) {
      apart_pixels += std::abs(one[pixel] - other[pixel]) > 0.07F ? 1 : 0;  // a tap is a sixteenth
    }
    EXPECT_LT(apart_pixels, one.size() / 500) << i;
  }
}

}  // namespace
}  // namespace luminist
