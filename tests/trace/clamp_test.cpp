// What is taken off rare bright paths (the style's parameter "clamp").
#include <algorithm>

#include "trace/box_scene.h"

namespace luminist {
namespace {

float largest(const Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

bool near_mirror(const SurfaceBuffer& surface, std::size_t pixel) {
  const int x = static_cast<int>(pixel) % surface.width;
  const int y = static_cast<int>(pixel) / surface.width;
  for (int row = std::max(y - 1, 0); row <= std::min(y + 1, surface.height - 1); ++row) {
    for (int column = std::max(x - 1, 0); column <= std::min(x + 1, surface.width - 1); ++column) {
      if (surface.roughness[surface.index(column, row)] < 0.1F) return true;
    }
  }
  return false;
}

TEST(Clamp, BoundsWhatAPathBringsByWayOfAnotherSurface) {
  constexpr float kMost = 0.05F;
  LUM_ASSERT_OK(const PathShot shot, small_room(24, 24));
  shot.set("style/samples=1");
  const Image exact = shot.picture();
  shot.set("style/clamp=0.05");
  const Image held = shot.picture();
  shot.set("style/bounces=1");
  const Image direct = shot.picture();  // of the same paths
  const SurfaceBuffer& surface = shot.renderer->surface();
  int cut = 0;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (near_mirror(surface, i)) continue;  // what that shows is another surface's own light
    EXPECT_LE(largest(held.rgb(i) - direct.rgb(i)), kMost + 1e-5F);
    cut += largest(exact.rgb(i) - direct.rgb(i)) > kMost ? 1 : 0;
    if (largest(exact.rgb(i) - direct.rgb(i)) >= kMost) continue;
    EXPECT_EQ(held.rgb(i), exact.rgb(i));
  }
  EXPECT_GT(cut, 10);
}

TEST(Clamp, TakesNothingOffLightThatArrivesStraightOrIsSeenInAMirror) {
  Scene scene;
  const int wall = add_material(scene, matte(Vec3(0.8F)));
  Material mirror = matte(Vec3(1.0F));
  mirror.roughness = 0.0F;
  mirror.metallic = 1.0F;
  add_rectangle(scene, {-3.0F, -3.0F, 4.0F}, {0.0F, 6.0F, 0.0F}, {6.0F, 0.0F, 0.0F}, wall);  // behind the eye
  add_rectangle(scene, {-2.0F, -2.0F, -1.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 4.0F, 0.0F}, add_material(scene, mirror));
  add_rectangle(scene, {0.0F, -2.0F, -1.0F}, {2.0F, 0.0F, 0.0F}, {0.0F, 4.0F, 0.0F}, wall);
  LUM_ASSERT_OK(const PathShot shot, PathShot::create(std::move(scene), camera_at({0.0F, 0.0F, 1.0F}, 1.2F), 16, 16));
  shot.add_light("point", "lamp");
  shot.set("lights/lamp/position=0.3,0.4,1.5");
  shot.set("lights/lamp/color=3,3,3");
  shot.set("style/samples=4");
  shot.set("style/bounces=1");
  const Image straight = shot.picture();
  shot.set("style/clamp=0.000001");
  EXPECT_EQ(shot.picture().data, straight.data);
  shot.set("style/bounces=2");
  const Image mirrored = shot.picture();
  EXPECT_GT(largest(mirrored.rgb(8 * 16 + 3)), 0.1F);  // the wall behind the eye, in the mirror
  shot.set("style/clamp=0");
  for (int y = 0; y < 16; ++y) {
    const std::size_t pixel = static_cast<std::size_t>(y) * 16 + 3;
    EXPECT_EQ(shot.picture().rgb(pixel), mirrored.rgb(pixel));
  }
}

}  // namespace
}  // namespace luminist
