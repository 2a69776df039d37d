// Paths on turned materials are those of a scene whose materials were made so.
#include <algorithm>
#include <numeric>

#include "trace/box_scene.h"

namespace luminist {
namespace {

constexpr int kWidth = 24;
constexpr int kHeight = 18;

/// Coloured walls, a glossy floor and a mirror; materials "material", "material-2"...
Scene walls() {
  Scene scene;
  add_cube(scene, add_material(scene, matte(Vec3(0.7F))));
  scene.objects[0].material = add_material(scene, matte({0.7F, 0.15F, 0.1F}));
  add_floor_and_mirror(scene);
  return scene;
}

Result<PathShot> shot_of(Scene scene) {
  LUM_TRY(PathShot shot, PathShot::create(std::move(scene), camera_at({0.0F, 0.0F, 0.98F}, 1.5F), kWidth, kHeight));
  shot.add_light("area", "panel");
  shot.set("lights/panel/position=0.2,0.99,0");
  shot.set("lights/panel/size=0.5");
  shot.set("ambient/color=0.2,0.2,0.2");
  shot.set("style/samples=4");
  shot.set("style/denoise=0");
  return shot;
}

class TurnedPaths : public testing::Test {
 protected:
  void SetUp() override {
    LUM_ASSERT_OK(PathShot shot, shot_of(walls()));
    shot_.emplace(std::move(shot));
    LUM_ASSERT_OK(const auto schema, load_material_schema(AssetRoots::standard()));
    shot_->state->materials = material_params(walls().materials, *schema);
  }
  void turn() {
    shot_->set("materials/material/tint=0.9,0.6,0.4");
    shot_->set("materials/material-3/roughness=0.25");
    shot_->set("materials/material-3/specular=3");
    shot_->set("materials/material-4/roughness=0.3");  // of a mirror
  }
  [[nodiscard]] std::vector<Vec3> kept(PathRenderer& renderer, const ParamState& state) const {
    SampleSet samples{9, std::vector<std::uint32_t>(std::size_t{kWidth} * kHeight)};
    std::iota(samples.pixels.begin(), samples.pixels.end(), 0U);
    const Candidate candidate{&state};
    std::vector<Vec3> colors(samples.pixels.size());
    LUM_EXPECT_OK(renderer.evaluate({&candidate, 1}, samples, {}, colors));
    return colors;
  }
  static double mean_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(glm::distance(a[i], b[i]));
    return sum / static_cast<double>(a.size());
  }

  std::optional<PathShot> shot_;
};

TEST_F(TurnedPaths, AreThoseOfTheSceneThatWasMadeSo) {
  const std::vector<Vec3> before = kept(*shot_->renderer, *shot_->state);
  turn();
  const std::vector<Vec3> turned = kept(*shot_->renderer, *shot_->state);
  LUM_ASSERT_OK(const PathShot made, shot_of(with_materials(walls(), shot_->state->materials)));
  // The same numbers choose the same paths: only rounding sends a few of them elsewhere.
  EXPECT_LT(mean_difference(turned, kept(*made.renderer, *made.state)), 1e-3);
  EXPECT_GT(mean_difference(turned, before), 0.03);
  const Image a = shot_->picture();
  const Image b = made.picture();
  double sum = 0.0;
  for (std::size_t i = 0; i < a.data.size(); ++i) sum += std::abs(static_cast<double>(a.data[i]) - b.data[i]);
  EXPECT_LT(sum / static_cast<double>(a.data.size()), 1e-3);
}

TEST_F(TurnedPaths, ComeBackToTheBitWithTheMaterials) {
  const std::vector<Vec3> before = kept(*shot_->renderer, *shot_->state);
  const Image picture = shot_->picture();
  const std::unique_ptr<ParamState> own = std::make_unique<ParamState>(*shot_->state);
  turn();
  EXPECT_NE(kept(*shot_->renderer, *shot_->state), before);
  EXPECT_NE(shot_->picture().data, picture.data);
  *shot_->state = *own;
  EXPECT_EQ(kept(*shot_->renderer, *shot_->state), before);
  EXPECT_EQ(shot_->picture().data, picture.data);
  shot_->state->materials.clear();
  EXPECT_EQ(kept(*shot_->renderer, *shot_->state), before) << "none are the scene's own, too";
}

TEST_F(TurnedPaths, OfOneBatchAreEachCandidatesOwn) {
  SampleSet samples{11, {20, 100, 200, 300}};
  std::vector<ParamState> states(4, *shot_->state);
  LUM_EXPECT_OK(set_path(states[1], "materials/material/tint=0.3,0.3,0.3"));
  LUM_EXPECT_OK(set_path(states[3], "materials/material-3/roughness=0.2"));
  std::vector<Candidate> candidates;
  for (const ParamState& state : states) candidates.push_back({&state});
  std::vector<Vec3> together(states.size() * samples.pixels.size());
  LUM_EXPECT_OK(shot_->renderer->evaluate(candidates, samples, {}, together));
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    std::vector<Vec3> alone(samples.pixels.size());
    LUM_EXPECT_OK(shot_->renderer->evaluate({&candidates[k], 1}, samples, {}, alone));
    EXPECT_TRUE(
        std::equal(alone.begin(), alone.end(), together.begin() + static_cast<std::ptrdiff_t>(k * alone.size())))
        << k;
  }
}

}  // namespace
}  // namespace luminist
