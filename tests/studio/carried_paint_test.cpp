#include "studio/carried_paint.h"

#include <fstream>

#include "studio/moving_ball.h"
#include "support/ball_scene.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// The ball of ball_obj() rises by its diameter in one second; two cameras look at it from the front and from behind.
class CarriedPaintTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.file("ball.obj")) << ball_obj();
    std::ofstream(folder_.file("ball.mtl")) << ball_material();
    LUM_ASSERT_OK(Scene scene, moving_ball(folder_.file("ball.obj"), {0.0F, 2.0F, 0.0F}, diagnostics_));
    scene.cameras.resize(1);
    scene.cameras[0] = {.name = "front"};
    scene.cameras[0].world_from_camera[3] = Vec4(0.0F, 2.0F, 9.0F, 1.0F);
    scene.cameras.push_back(scene.cameras[0]);
    scene.cameras[1].name = "back";
    scene.cameras[1].world_from_camera = Mat4(Vec4(-1.0F, 0.0F, 0.0F, 0.0F), Vec4(0.0F, 1.0F, 0.0F, 0.0F),
                                              Vec4(0.0F, 0.0F, -1.0F, 0.0F), Vec4(0.0F, 2.0F, -9.0F, 1.0F));
    LUM_EXPECT_OK(save_scene(scene, folder_.file("rising.glb")));
    from_.scene = "rising.glb";
    to_ = from_;
  }
  Result<CarriedPaint> carry(const StrokeFile& strokes) {
    return carry_paint(AssetRoots::standard(), strokes, from_, to_, folder_.path(), diagnostics_);
  }
  /// On the picture of the front camera a unit at the ball's front, 8 away, is this much of its height.
  static float unit() { return 1.0F / (16.0F * std::tan(0.5F * Camera{}.fov_y)); }
  /// On the middle of the ball's front, at frame 0 one unit below the picture's middle.
  static Stroke middle() {
    Stroke stroke;
    stroke.brush.diameter = 0.05F;
    stroke.points = {{320.0F / 480.0F, 0.5F + unit()}};
    return stroke;
  }
  static StrokeFile file(std::vector<Stroke> strokes) { return {0.3F, 0.2F, std::move(strokes)}; }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
  Shot from_;
  Shot to_;
};

TEST_F(CarriedPaintTest, FollowsWhatMovesToAnotherFrame) {
  to_.frame = 24;
  LUM_ASSERT_OK(const CarriedPaint carried, carry(file({middle()})));
  ASSERT_EQ(carried.strokes.strokes.size(), 1U);
  const StrokePoint& point = carried.strokes.strokes[0].points.at(0);
  EXPECT_NEAR(point.x, middle().points[0].x, 1e-4F);
  // It is 2 units higher at the same depth, 8 and a hundredth for the facets: a thousandth of 0.34.
  EXPECT_NEAR(point.y, middle().points[0].y - 2.0F * unit(), 1e-3F);
  EXPECT_EQ(carried.strokes.nu, 0.3F);
  EXPECT_EQ(carried.strokes.delta, 0.2F);
  EXPECT_EQ(fate_line(carried.fates[0], 1), "stroke 1: 1 of 1 points");
}

TEST_F(CarriedPaintTest, TheOtherSideOfAThingIsNotSeen) {
  to_.camera = "back";
  LUM_ASSERT_OK(const CarriedPaint carried, carry(file({middle()})));
  EXPECT_TRUE(carried.strokes.strokes.empty());
  EXPECT_EQ(fate_line(carried.fates[0], 1), "stroke 1: left out (1 hidden)");
}

TEST_F(CarriedPaintTest, SaysWhichPointsAreOverNothing) {
  Stroke up = middle();
  up.points.push_back({up.points[0].x, 0.0F});
  LUM_ASSERT_OK(const CarriedPaint carried, carry(file({up})));
  EXPECT_GT(carried.fates[0].off_surface, 0);
  EXPECT_GT(carried.fates[0].shown, 0);
  EXPECT_EQ(carried.fates[0].hidden, 0);
  EXPECT_EQ(carried.strokes.strokes[0].points.size(), static_cast<std::size_t>(carried.fates[0].shown));
}

TEST_F(CarriedPaintTest, APeakIsNotTakenFromAnEarlierStrokeThanBefore) {
  Stroke floor = middle();
  floor.brush.gradient = 1.0F;
  floor.points = {{0.2F, 0.5F + 2.3F * unit()}};
  Stroke ball = middle();
  ball.brush.gradient = 1.0F;
  Stroke repeats = floor;
  repeats.brush.repeat_peak = true;
  LUM_ASSERT_OK(const CarriedPaint same, carry(file({floor, ball, repeats})));
  ASSERT_EQ(same.strokes.strokes.size(), 3U);
  EXPECT_TRUE(same.strokes.strokes[2].brush.repeat_peak);
  to_.camera = "back";  // the ball's front is hidden
  LUM_ASSERT_OK(const CarriedPaint carried, carry(file({floor, ball, repeats})));
  ASSERT_EQ(carried.strokes.strokes.size(), 2U);
  EXPECT_FALSE(carried.strokes.strokes[1].brush.repeat_peak);
}

TEST_F(CarriedPaintTest, CopiesStayOnTheirPicture) {
  Stroke copy = middle();
  copy.brush.tool = PaintTool::kCopy;
  copy.brush.copy_from = "edited.png";
  LUM_ASSERT_OK(const CarriedPaint carried, carry(file({copy})));
  EXPECT_TRUE(carried.strokes.strokes.empty());
  EXPECT_TRUE(carried.fates[0].copy);
}

TEST_F(CarriedPaintTest, NamesWhatIsWrong) {
  Stroke clipped = middle();
  clipped.brush.clip = "boll";
  const Error clip = error_of(carry(file({middle(), clipped})));
  EXPECT_EQ(clip.kind, ErrorKind::kBadContent);
  EXPECT_EQ(clip.field, "strokes[1].clip");
  EXPECT_EQ(clip.hint, "did you mean \"ball\"?");
  to_.camera = "bakc";
  EXPECT_EQ(error_of(carry(file({middle()}))).kind, ErrorKind::kUsage);
  to_ = from_;
  to_.frame = std::numeric_limits<double>::infinity();
  EXPECT_EQ(error_of(carry(file({middle()}))).field, "frame");
}

}  // namespace
}  // namespace luminist
