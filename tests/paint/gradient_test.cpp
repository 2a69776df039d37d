#include "paint/gradient.h"

#include <gtest/gtest.h>

#include "paint/ball.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

constexpr int kBallSide = 101;  // odd: the middle pixel's centre is the middle of the ball

class GradientTest : public ::testing::Test {
 protected:
  static Brush brush(float gamma) {
    Brush b;
    b.gradient = gamma;
    return b;
  }
  [[nodiscard]] Result<Gradient> create(const Stroke& stroke, const ObjectMask& mask = {},
                                        const std::optional<Peak>& last = std::nullopt) const {
    return Gradient::create(stroke, surface_, mask, last);
  }
  [[nodiscard]] Vec3 mirrored(int x, int y) const {
    const std::size_t i = surface_.index(x, y);
    const Vec3 to_eye = glm::normalize(surface_.eye - surface_.position[i]);
    return glm::reflect(-to_eye, surface_.normal[i]);
  }
  SurfaceBuffer surface_ = ball_surface(kBallSide, kBallSide);
};

TEST_F(GradientTest, OfADiffusePeakIsTheCosineOfTheTurningNormal) {
  LUM_ASSERT_OK(const Gradient g, create(click(brush(1.0F), 0.5F, 0.5F)));
  const Vec3 peak = surface_.normal[surface_.index(50, 50)];
  for (const auto& [x, y] : {std::pair{50, 50}, {60, 50}, {50, 80}, {30, 35}}) {
    EXPECT_FLOAT_EQ(g.factor(surface_, x, y), glm::dot(surface_.normal[surface_.index(x, y)], peak));
  }
}

TEST_F(GradientTest, GammaMixesItWithNoGradient) {
  LUM_ASSERT_OK(const Gradient full, create(click(brush(1.0F), 0.5F, 0.5F)));
  LUM_ASSERT_OK(const Gradient third, create(click(brush(0.3F), 0.5F, 0.5F)));
  LUM_ASSERT_OK(const Gradient none, create(click(brush(0.0F), 0.5F, 0.5F)));
  EXPECT_FLOAT_EQ(third.factor(surface_, 70, 40), 0.7F + 0.3F * full.factor(surface_, 70, 40));
  EXPECT_EQ(none.factor(surface_, 70, 40), 1.0F);
}

TEST_F(GradientTest, IsZeroWhereTheNormalTurnsAwayFromThePeak) {
  LUM_ASSERT_OK(const Gradient g, create(click(brush(1.0F), 0.12F, 0.5F)));  // near the left silhouette
  ASSERT_LT(glm::dot(surface_.normal[surface_.index(88, 50)], g.peak()->direction), 0.0F);
  EXPECT_EQ(g.factor(surface_, 88, 50), 0.0F);
}

TEST_F(GradientTest, OfASpecularPeakIsTheCosineOfTheTurningMirrorDirection) {
  Brush b = brush(1.0F);
  b.peak = PeakKind::kSpecular;
  LUM_ASSERT_OK(const Gradient g, create(click(b, 0.65F, 0.4F)));
  for (const auto& [x, y] : {std::pair{65, 40}, {60, 42}, {50, 50}, {80, 30}}) {
    EXPECT_NEAR(g.factor(surface_, x, y), std::max(0.0F, glm::dot(mirrored(x, y), mirrored(65, 40))), 1e-6F);
  }
  EXPECT_FLOAT_EQ(g.factor(surface_, 65, 40), 1.0F);
}

TEST_F(GradientTest, FadesFasterFromASpecularPeakThanFromADiffuseOne) {
  Brush b = brush(1.0F);
  LUM_ASSERT_OK(const Gradient diffuse, create(click(b, 0.5F, 0.5F)));
  b.peak = PeakKind::kSpecular;
  LUM_ASSERT_OK(const Gradient specular, create(click(b, 0.5F, 0.5F)));
  EXPECT_LT(specular.factor(surface_, 65, 50), diffuse.factor(surface_, 65, 50) - 0.1F);
}

TEST_F(GradientTest, OnTheBackgroundIsZero) {
  LUM_ASSERT_OK(const Gradient g, create(click(brush(1.0F), 0.5F, 0.5F)));
  EXPECT_EQ(g.factor(surface_, 0, 0), 0.0F);
}

TEST_F(GradientTest, OfAStrokeThatStartsBesideTheSurfaceStartsWhereItMeetsIt) {
  const Stroke stroke{brush(1.0F), {{0.0F, 0.505F}, {0.505F, 0.505F}}};
  LUM_ASSERT_OK(const Gradient g, create(stroke));
  std::size_t first = surface_.index(0, 51);
  while (surface_.object[first] == 0) ++first;
  EXPECT_EQ(g.peak()->direction, surface_.normal[first]);
}

TEST_F(GradientTest, StartsOnTheClippedObject) {
  const Stroke stroke{brush(1.0F), {{0.25F, 0.505F}, {0.75F, 0.505F}}};
  LUM_ASSERT_OK(const Gradient g, create(stroke, ObjectMask{false, false, true}));
  EXPECT_GE(g.peak()->direction.x, 0.0F);
}

TEST_F(GradientTest, ThatMeetsNoSurfaceIsAnError) {
  const Error error = error_of(create(click(brush(0.5F), 0.02F, 0.02F)));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.field, "gradient");
}

TEST_F(GradientTest, RepeatsTheLastPeakAndItsKind) {
  Brush b = brush(1.0F);
  b.repeat_peak = true;
  const Peak last{PeakKind::kSpecular, {0.0F, 1.0F, 0.0F}};
  LUM_ASSERT_OK(const Gradient g, create(click(b, 0.5F, 0.5F), {}, last));
  EXPECT_EQ(g.peak()->kind, PeakKind::kSpecular);
  EXPECT_EQ(g.peak()->direction, last.direction);
  LUM_ASSERT_OK(const Gradient first, create(click(b, 0.5F, 0.5F)));  // nothing to repeat: its own start
  EXPECT_EQ(first.peak()->direction, surface_.normal[surface_.index(50, 50)]);
}

TEST_F(GradientTest, OnTheScreenRunsOutFromTheFirstPointToTheLast) {
  Brush b = brush(1.0F);
  b.screen_gradient = true;
  const float pixel = 1.0F / kBallSide;
  const Stroke stroke{b, {{20.5F * pixel, 0.0F}, {50.0F * pixel, 0.9F}, {80.5F * pixel, 0.0F}}};
  LUM_ASSERT_OK(const Gradient g, create(stroke));
  EXPECT_NEAR(g.factor(surface_, 10, 7), 1.0F, 1e-5F);
  EXPECT_NEAR(g.factor(surface_, 20, 7), 1.0F, 1e-5F);
  EXPECT_NEAR(g.factor(surface_, 35, 90), 0.75F, 1e-5F);
  EXPECT_NEAR(g.factor(surface_, 80, 7), 0.0F, 1e-5F);
  EXPECT_NEAR(g.factor(surface_, 95, 7), 0.0F, 1e-5F);
  EXPECT_FALSE(g.peak());
}

TEST_F(GradientTest, OnTheScreenDoesNotRunOutUnderAClick) {
  Brush b = brush(1.0F);
  b.screen_gradient = true;
  LUM_ASSERT_OK(const Gradient g, create(click(b, 0.1F, 0.1F)));
  EXPECT_EQ(g.factor(surface_, 90, 90), 1.0F);
}

}  // namespace
}  // namespace luminist
