#include <gtest/gtest.h>

#include "raster/raster_renderer.h"
#include "raster/small_scene.h"
#include "solve/degenerate_problem.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kProblems = 100;  // of all styles together

/// The small scene with a wall, so that lights can stand behind it; 24 x 18 pixels.
class RealGeometry : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(device_, Device::create_headless());
    LUM_ASSERT_OK(types_, LightTypes::load(AssetRoots::standard()));
    LUM_ASSERT_OK(const Style style, load_style(AssetRoots::standard(), GetParam()));
    Scene scene = small_scene(24);
    Mesh wall;
    wall.positions = {{-6.0F, -1.1F, -2.5F}, {6.0F, -1.1F, -2.5F}, {6.0F, 5.0F, -2.5F}, {-6.0F, 5.0F, -2.5F}};
    wall.normals.assign(4, Vec3(0.0F, 0.0F, 1.0F));
    wall.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.meshes.push_back(wall);
    Object object = scene.objects[1];
    object.name = "wall";
    object.mesh = 2;
    scene.objects.push_back(object);
    LUM_ASSERT_OK(renderer_, RasterRenderer::create(*device_, scene, scene.cameras[0], *types_, style,
                                                    AssetRoots::standard(), 24, 18));
    empty_.emplace(initial_state(*types_, style, renderer_->frame()));
  }

  std::optional<Device> device_;
  std::optional<LightTypes> types_;
  std::unique_ptr<RasterRenderer> renderer_;
  std::optional<ParamState> empty_;
};

TEST_P(RealGeometry, GivesNothingWorseThanTheStartOfDegenerateProblems) {
  LUM_ASSERT_OK(const Light light, make_light(*types_, "cinematic", "light", renderer_->frame()));
  for (std::uint64_t seed = 0; seed < kProblems / 2; ++seed) {
    LUM_ASSERT_OK(DegenerateProblem problem, degenerate_problem(*renderer_, *empty_, light, seed));
    problem.steps = std::min(problem.steps, 12);  // the engine is slower than the fake, and so are its steps
    SCOPED_TRACE(std::to_string(seed) + ": " + problem.what);
    solve_degenerate(*renderer_, problem);
    if (HasFatalFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Styles, RealGeometry, testing::Values("cinematic", "toon"));

}  // namespace
}  // namespace luminist
