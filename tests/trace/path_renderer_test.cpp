#include "trace/path_renderer.h"

#include <tbb/global_control.h>

#include <cmath>
#include <numeric>

#include "render/metric.h"
#include "trace/box_scene.h"
#include "trace/denoise.h"

namespace luminist {
namespace {

std::vector<std::uint32_t> all_pixels(const PathRenderer& renderer) {
  std::vector<std::uint32_t> pixels(renderer.surface().pixels());
  std::iota(pixels.begin(), pixels.end(), 0U);
  return pixels;
}

double brightness(const Vec3& color) {
  return static_cast<double>(color.x + color.y + color.z) / 3.0;
}

double rms(const Image& a, const Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.data.size(); ++i) sum += std::pow(static_cast<double>(a.data[i] - b.data[i]), 2.0);
  return std::sqrt(sum / static_cast<double>(a.data.size()));
}

Target target_of(Image picture) {
  Target target;
  target.color = picture;
  target.before = picture;
  target.importance = Image(picture.width, picture.height, 1, 1.0F);
  target.stroke.assign(picture.pixels(), 0);
  return target;
}

TEST(PathNoise, FallsAtLeastAsChanceWouldWithTheNumberOfSamples) {
  LUM_ASSERT_OK(const PathShot shot, small_room(12, 12));
  shot.set("style/seed=1000");
  shot.set("style/samples=2048");
  const Image reference = shot.picture();
  const auto error_of_samples = [&](int samples) {
    shot.set("style/samples=" + std::to_string(samples));
    double square = 0.0;
    for (int seed = 1; seed <= 4; ++seed) {
      shot.set("style/seed=" + std::to_string(seed));
      square += std::pow(rms(shot.picture(), reference), 2.0);
    }
    return std::sqrt(square / 4.0);
  };
  const double few = error_of_samples(4);
  const double many = error_of_samples(64);
  // Chance: a quarter of the error for sixteen times the samples. Four pictures of 144 pixels know it to some 10 %.
  EXPECT_LT(many, 0.25 * 1.1 * few);
  EXPECT_GT(many, 0.0);
}

TEST(PathNoise, HasTheMeanOfALongRun) {
  constexpr int kSeeds = 32;
  constexpr int kSamples = 64;
  constexpr int kLong = 8192;
  LUM_ASSERT_OK(const PathShot shot, small_room(8, 8));
  // A small panel in a mirror makes caustics of rare bright paths, of which 32 means of 64 know no variance.
  shot.set("lights/panel/size=1.6");
  shot.set("style/samples=" + std::to_string(kSamples));
  std::vector<double> sum(64, 0.0);
  std::vector<double> squares(64, 0.0);
  for (int seed = 1; seed <= kSeeds; ++seed) {
    shot.set("style/seed=" + std::to_string(seed));
    const Image picture = shot.picture();
    for (std::size_t i = 0; i < 64; ++i) {
      const double v = brightness(picture.rgb(i));
      sum[i] += v, squares[i] += v * v;
    }
  }
  std::vector<std::uint32_t> pixels = all_pixels(*shot.renderer);
  shot.set("style/kept=1024");
  std::vector<double> reference(64, 0.0);
  for (int part = 0; part < kLong / 1024; ++part) {  // other paths, by the other way of summing them
    shot.set("style/seed=" + std::to_string(1000 + part));
    std::vector<Vec3> colors(64);
    LUM_EXPECT_OK(shot.renderer->colors_at(*shot.state, {}, pixels, colors));
    for (std::size_t i = 0; i < 64; ++i) reference[i] += brightness(colors[i]) * 1024 / kLong;
  }
  double chi = 0.0;
  double shift = 0.0;
  for (std::size_t i = 0; i < 64; ++i) {
    const double mean = sum[i] / kSeeds;
    const double variance = (squares[i] / kSeeds - mean * mean) * kSeeds / (kSeeds - 1);
    // The long run has noise, too: at most that of so many independent samples.
    const double noise = std::sqrt(variance * (1.0 / kSeeds + static_cast<double>(kSamples) / kLong) + 1e-12);
    const double z = (mean - reference[i]) / noise;
    chi += z * z;
    shift += z;
  }
  // Of 64 t-distributed numbers with 31 degrees of freedom the squares sum to 68 +- 12.5, the numbers to 0 +- 8.3.
  EXPECT_LT(chi, 68.0 + 4.0 * 12.5);
  EXPECT_GT(chi, 68.0 - 4.0 * 12.5) << "the noise is not overstated either";
  EXPECT_LT(std::abs(shift), 4.0 * 8.3);
}

TEST(PathRenderer, MakesTheSameBitsWithAnyNumberOfThreads) {
  std::vector<Image> pictures;
  std::vector<double> errors;
  std::vector<std::vector<Vec3>> colors;
  for (const std::size_t threads : {1U, 2U, 5U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    LUM_ASSERT_OK(const PathShot shot, small_room(24, 20));
    shot.set("style/samples=6");
    shot.set("style/kept=4");
    pictures.push_back(shot.picture());
    LUM_ASSERT_OK(const double epsilon, shot.renderer->error(*shot.state, target_of(Image(24, 20, 3, 0.3F))));
    errors.push_back(epsilon);
    const Candidate candidate{shot.state.get()};
    colors.emplace_back(shot.renderer->surface().pixels());
    LUM_EXPECT_OK(shot.renderer->evaluate({&candidate, 1}, {7, all_pixels(*shot.renderer)}, {}, colors.back()));
  }
  for (std::size_t i = 1; i < pictures.size(); ++i) {
    EXPECT_EQ(pictures[i].data, pictures[0].data);
    EXPECT_EQ(errors[i], errors[0]);
    EXPECT_EQ(colors[i], colors[0]);
  }
}

TEST(PathRenderer, KeepsTheFirstPathsOfThePicture) {
  LUM_ASSERT_OK(const PathShot shot, small_room(20, 16));
  shot.set("style/samples=8");
  shot.set("style/kept=8");
  shot.set("ambient/color=0.1,0.2,0.3");
  const Image picture = shot.picture();
  std::vector<Vec3> kept(shot.renderer->surface().pixels());
  LUM_EXPECT_OK(shot.renderer->colors_at(*shot.state, {}, all_pixels(*shot.renderer), kept));
  // The same paths, summed in another order.
  for (std::size_t i = 0; i < kept.size(); ++i) {
    ASSERT_LT(glm::distance(kept[i], picture.rgb(i)), 1e-4F * (1.0F + glm::length(kept[i]))) << i;
  }
}

TEST(PathRenderer, ItsErrorIsTheMetricsOfTheKeptPicture) {
  LUM_ASSERT_OK(const PathShot shot, small_room(20, 16));
  std::vector<Vec3> kept(shot.renderer->surface().pixels());
  LUM_EXPECT_OK(shot.renderer->colors_at(*shot.state, {}, all_pixels(*shot.renderer), kept));
  Image picture(20, 16, 3);
  for (std::size_t i = 0; i < kept.size(); ++i) picture.set_rgb(i, kept[i]);
  const Target target = target_of(Image(20, 16, 3, 0.25F));
  LUM_ASSERT_OK(const double epsilon, shot.renderer->error(*shot.state, target));
  EXPECT_NEAR(epsilon, picture_error(picture, target, {}), 1e-6) << "sums of single precision in two orders";
}

TEST(PathRenderer, SumsItsLightsAndIsLinearInTheirColours) {
  LUM_ASSERT_OK(const PathShot shot, small_room(20, 16));
  shot.add_light("cinematic", "spot");
  shot.set("lights/spot/position=0,0,0.9");
  shot.set("lights/spot/direction=0,0,-1");
  ParamState tinted = *shot.state;
  LUM_EXPECT_OK(set_path(tinted, "lights/panel/color=0.5,2,0"));
  const std::array<Candidate, 5> candidates{Candidate{shot.state.get()}, Candidate{shot.state.get(), 0},
                                            Candidate{shot.state.get(), 1},
                                            Candidate{shot.state.get(), Candidate::kNoLights}, Candidate{&tinted, 0}};
  const std::size_t count = shot.renderer->surface().pixels();
  std::vector<Vec3> out(candidates.size() * count);
  LUM_EXPECT_OK(shot.renderer->evaluate(candidates, {7, all_pixels(*shot.renderer)}, {}, out));
  float light = 0.0F;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 sum = out[count + i] + out[2 * count + i] + out[3 * count + i];
    ASSERT_LT(glm::distance(out[i], sum), 1e-5F * (1.0F + glm::length(sum)));
    ASSERT_LT(glm::distance(out[4 * count + i], Vec3(0.5F, 2.0F, 0.0F) * out[count + i]), 1e-5F);
    light += out[2 * count + i].x;
  }
  EXPECT_GT(light, 0.1F) << "the spot is in the picture";
}

TEST(PathRenderer, ALightThatOnlyChangesItsColourCostsNoRays) {
  LUM_ASSERT_OK(const PathShot shot, small_room(20, 16));
  const Target target = target_of(Image(20, 16, 3, 0.25F));
  LUM_ASSERT_OK(const double before, shot.renderer->error(*shot.state, target));
  const double rays = shot.renderer->work().shadow_queries;
  shot.set("lights/panel/color=0.2,0.4,2");
  shot.set("lights/panel/intensity=1.5");
  LUM_ASSERT_OK(const double after, shot.renderer->error(*shot.state, target));
  EXPECT_EQ(shot.renderer->work().shadow_queries, rays);
  EXPECT_NE(after, before);
  shot.set("lights/panel/size=0.6");
  LUM_EXPECT_OK(shot.renderer->error(*shot.state, target));
  EXPECT_GT(shot.renderer->work().shadow_queries, rays);
}

TEST(PathRenderer, PixelsThatCountLessGetFewerSamples) {
  EXPECT_EQ(samples_for(0.0, 64), 0);
  EXPECT_EQ(samples_for(1e-9, 64), 1);
  EXPECT_EQ(samples_for(0.25, 64), 32);
  EXPECT_EQ(samples_for(1.0, 64), 64);
  LUM_ASSERT_OK(const PathShot shot, small_room(20, 16));
  Image importance(20, 16, 1, 1.0F);
  for (std::size_t i = 0; i < 160; ++i) importance.data[i] = 0.0F;
  const double before = shot.renderer->work().shadow_queries;
  const Image whole = shot.picture();
  const double all = shot.renderer->work().shadow_queries - before;
  LUM_ASSERT_OK(const Image part, shot.renderer->render_where(*shot.state, importance));
  const double some = shot.renderer->work().shadow_queries - before - all;
  EXPECT_LT(some, 0.7 * all);
  for (std::size_t i = 0; i < 160; ++i) EXPECT_EQ(part.rgb(i), Vec3(0.0F));
  for (std::size_t i = 160; i < 320; ++i) EXPECT_EQ(part.rgb(i), whole.rgb(i));
}

TEST(PathRenderer, TellsItsProgressAndCanBeCancelled) {
  LUM_ASSERT_OK(const PathShot shot, small_room(10, 8));
  shot.set("style/samples=20");
  std::vector<int> seen;
  Image last;
  shot.renderer->set_watch([&](const PathProgress& progress) {
    seen.push_back(progress.samples);
    last = *progress.so_far;
    return progress.of == 20;
  });
  const Image picture = shot.picture();
  EXPECT_EQ(seen, (std::vector<int>{1, 2, 4, 8, 16, 20}));
  EXPECT_EQ(last.data, picture.data);
  shot.renderer->set_watch([](const PathProgress& progress) { return progress.samples < 4; });
  EXPECT_EQ(shot.picture().data, picture.data) << "it is still known";
  shot.set("style/seed=2");
  EXPECT_EQ(error_of(shot.renderer->render(*shot.state)).kind, ErrorKind::kCancelled);
}

TEST(PathRenderer, NamesTheLightTypesThatItLacks) {
  LUM_ASSERT_OK(const PathShot shot, small_room(4, 4));
  shot.state->rig.lights.front().type = "laser";
  const Error error = error_of(shot.renderer->render(*shot.state));
  EXPECT_EQ(error.kind, ErrorKind::kStyle);
  EXPECT_NE(error.what.find("laser"), std::string::npos);
}

TEST(PathRenderer, KeepsFewerPathsOfAPictureWhereMemoryIsShortAndAllOfSamples) {
  LUM_ASSERT_OK(const LightTypes types, LightTypes::load(AssetRoots::standard()));
  LUM_ASSERT_OK(const Style style, load_style(AssetRoots::standard(), "path"));
  Scene scene;
  add_cube(scene, add_material(scene, matte(Vec3(0.5F), Vec3(1.0F))));
  LUM_ASSERT_OK(const auto small, PathRenderer::create(scene, camera_at(Vec3(0.0F), 1.0F), style, 64, 64, 4U << 20));
  LUM_ASSERT_OK(const auto large, PathRenderer::create(scene, camera_at(Vec3(0.0F), 1.0F), style, 64, 64));
  const ParamState state = initial_state(types, style, small->frame());
  const Target target = target_of(Image(64, 64, 3, 0.0F));
  LUM_ASSERT_OK(const double few, small->error(state, target));
  LUM_ASSERT_OK(const double all, large->error(state, target));
  EXPECT_NE(few, all);
  EXPECT_NEAR(few, all, 0.05 * all) << "4096 pixels of one path each";
  const Candidate candidate{&state};
  const SampleSet samples{3, {100, 2000, 4000}};
  std::vector<Vec3> a(3);
  std::vector<Vec3> b(3);
  LUM_EXPECT_OK(small->evaluate({&candidate, 1}, samples, {}, a));
  LUM_EXPECT_OK(large->evaluate({&candidate, 1}, samples, {}, b));
  EXPECT_EQ(a, b);
}

TEST(PathRenderer, SavesPathsWhereRaysAreSaved) {
  LUM_ASSERT_OK(const PathShot shot, small_room(12, 10));
  const Candidate candidate{shot.state.get()};
  const SampleSet samples{3, all_pixels(*shot.renderer)};
  const auto looked_at = [&](int kept, int rays) {
    shot.set("style/kept=" + std::to_string(kept));
    std::vector<Vec3> colors(samples.pixels.size());
    LUM_EXPECT_OK(shot.renderer->evaluate({&candidate, 1}, samples, {.shadow_rays = rays}, colors));
    return colors;
  };
  const std::vector<Vec3> all = looked_at(8, 8);
  EXPECT_EQ(looked_at(8, 100), all) << "there are no more than are kept";
  EXPECT_NE(looked_at(8, 4), all);
  EXPECT_EQ(looked_at(8, 4), looked_at(4, 8));
  EXPECT_EQ(looked_at(8, 1), looked_at(1, 8));
  EXPECT_EQ(looked_at(2, 1), looked_at(1, 8)) << "one at least";
}

TEST(Denoise, BringsFewSamplesNearerToMany) {
  LUM_ASSERT_OK(const PathShot shot, small_room(48, 48));
  shot.set("lights/panel/size=1.6");  // a small one in a mirror makes caustics that are specks for ever
  shot.set("style/samples=8");
  const Image noisy = shot.picture();
  const Image smooth = denoised(noisy, shot.renderer->surface());
  shot.set("style/samples=256");
  shot.set("style/seed=9");
  const Image reference = shot.picture();
  // The panel itself, seen by the eye, is bright and stays: leave it out.
  Image clipped[3] = {noisy, smooth, reference};
  for (Image& image : clipped) {
    for (float& value : image.data) value = std::min(value, 1.0F);
  }
  EXPECT_LT(rms(clipped[1], clipped[2]), 0.7 * rms(clipped[0], clipped[2]));
}

TEST(Denoise, LeavesAnEvenPictureAsItIs) {
  LUM_ASSERT_OK(const PathShot shot, small_room(16, 16));
  Image even(16, 16, 3);
  const SurfaceBuffer& surface = shot.renderer->surface();
  for (std::size_t i = 0; i < even.pixels(); ++i) even.set_rgb(i, 0.5F * (surface.albedo[i] + surface.specular[i]));
  const Image same = denoised(even, surface);
  for (std::size_t i = 0; i < even.data.size(); ++i) EXPECT_NEAR(same.data[i], even.data[i], 1e-5F);
}

TEST(PathLinks, ALightLightsOnlyWhatItIsLinkedTo) {
  LUM_ASSERT_OK(const PathShot shot, small_room(16, 16));
  shot.set("style/bounces=1");
  const Image open = shot.picture();
  shot.state->rig.lights[0].objects = {"rectangle-2"};  // the floor
  const Image linked = shot.picture();
  std::vector<Vec3> kept(linked.pixels());
  LUM_EXPECT_OK(shot.renderer->colors_at(*shot.state, {}, all_pixels(*shot.renderer), kept));
  const SurfaceBuffer& surface = shot.renderer->surface();
  // A pixel shows nothing else where its neighbours show the same object.
  const auto inside = [&](std::size_t i) {
    const int x = static_cast<int>(i) % surface.width;
    const int y = static_cast<int>(i) / surface.width;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const bool in_picture = x + dx >= 0 && y + dy >= 0 && x + dx < surface.width && y + dy < surface.height;
        if (!in_picture || surface.object[surface.index(x + dx, y + dy)] != surface.object[i]) return false;
      }
    }
    return true;
  };
  int floor = 0;
  int others = 0;
  for (std::size_t i = 0; i < linked.pixels(); ++i) {
    // The panel itself is seen under the ceiling.
    if (!inside(i) || surface.object_names[surface.object[i]] == "rectangle-3") continue;
    if (surface.object_names[surface.object[i]] == "rectangle-2") {
      EXPECT_EQ(linked.rgb(i), open.rgb(i));
      floor += linked.rgb(i) != Vec3(0.0F) ? 1 : 0;
    } else {
      EXPECT_EQ(linked.rgb(i), Vec3(0.0F));
      EXPECT_EQ(kept[i], Vec3(0.0F));
      others += open.rgb(i) != Vec3(0.0F) ? 1 : 0;
    }
  }
  EXPECT_GT(floor, 0);
  EXPECT_GT(others, 0);
}

}  // namespace
}  // namespace luminist
