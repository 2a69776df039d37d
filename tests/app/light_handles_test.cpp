#include "app/light_handles.h"

#include <gtest/gtest.h>

#include "studio/workbench_fixture.h"

namespace luminist {
namespace {

/// A light that paint has found, under the hand.
class LightHandlesTest : public WorkbenchTest {
 protected:
  void SetUp() override {
    WorkbenchTest::SetUp();
    add_dark_light();
    draw_stroke();
    rest();
    desk_.now = look();
    desk_.selected = "light";
    const Image& picture = desk_.now->painted->color;
    desk_.view.place({Vec2(0.0F), Vec2(800.0F, 600.0F)}, picture.width, picture.height);
    const auto pose = pose_of(*desk_.now->shown->rig.find("light"), desk_.now->facts->frame);
    const auto aim = aim_point(desk_.now->facts->surface, *pose);
    ring_ = desk_.view.to_screen(*project(desk_.now->facts->camera, *aim, picture.width, picture.height));
    EXPECT_FALSE(handles_.scroll(desk_, ring_, 1.0F)) << "the wheel zooms there";  // and the light is seen
  }

  Desk desk_;
  LightHandles handles_;
  Vec2 ring_{0.0F};
};

TEST_F(LightHandlesTest, StandAsideForTheBrushButForTheBall) {
  const Vec2 ball(60.0F, 540.0F);  // in the corner
  EXPECT_TRUE(handles_.over(desk_, ring_));
  EXPECT_TRUE(handles_.over(desk_, ball));
  desk_.handles_aside = true;
  EXPECT_FALSE(handles_.over(desk_, ring_)) << "the next stroke may begin where the light shines";
  EXPECT_TRUE(handles_.over(desk_, ball));
}

TEST_F(LightHandlesTest, ComeBackByTheKeyThatHidesThemOtherwise) {
  desk_.handles_aside = true;
  perform(desk_, Deed::kHandles);
  EXPECT_TRUE(handles_.over(desk_, ring_));
  EXPECT_TRUE(desk_.shape_handles);
  perform(desk_, Deed::kHandles);
  EXPECT_FALSE(desk_.shape_handles);
}

}  // namespace
}  // namespace luminist
