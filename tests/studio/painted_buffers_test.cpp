#include "studio/painted_buffers.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace luminist {
namespace {

class PaintedBuffersTest : public testing::Test {
 protected:
  PaintedBuffersTest() {
    target_.color = Image(6, 5, 3, 0.25F);
    target_.importance = Image(6, 5, 1, 0.1F);
    target_.stroke.assign(30, 0);
  }
  static void paint(Target& target, int x, int y, float value) {
    const std::size_t pixel = target.color.index(x, y);
    target.color.set_rgb(pixel, Vec3(value));
    target.importance.data[pixel] = 1.0F;
    target.stroke[pixel] = 1;
  }
  void fill_all() {
    std::vector<std::shared_ptr<const PaintedPictures>> held;
    for (int i = 0; i < 4; ++i) held.push_back(buffers_.show(target_));
  }
  void expect_shown(const Target& target) {
    const auto shown = buffers_.show(target);
    EXPECT_EQ(shown->color.data, target.color.data);
    EXPECT_EQ(shown->importance.data, target.importance.data);
    EXPECT_EQ(shown->stroke, target.stroke);
  }

  Target target_;
  PaintedBuffers buffers_;
};

TEST_F(PaintedBuffersTest, ShowWhatIsPaintedWhoeverHoldsWhichOfThem) {
  std::vector<std::shared_ptr<const PaintedPictures>> held;
  for (int i = 0; i < 20; ++i) {
    paint(target_, i % 6, i % 5, 0.01F * static_cast<float>(i));
    buffers_.note({i % 6, i % 5, i % 6 + 1, i % 5 + 1});
    expect_shown(target_);
    held.push_back(buffers_.show(target_));
    if (held.size() > static_cast<std::size_t>(i % 7)) held.erase(held.begin());
  }
}

TEST_F(PaintedBuffersTest, OneThatNobodyHoldsIsUsedAgain) {
  std::set<const PaintedPictures*> used;
  std::shared_ptr<const PaintedPictures> latest;
  std::shared_ptr<const PaintedPictures> drawn;
  for (int i = 0; i < 20; ++i) {
    drawn = std::exchange(latest, buffers_.show(target_));
    used.insert(latest.get());
  }
  EXPECT_EQ(used.size(), 3U) << "the thread's, the window's, and one to fill";
}

TEST_F(PaintedBuffersTest, WhatTheyHoldForOthersStaysAsItIs) {
  const auto before = buffers_.show(target_);
  paint(target_, 2, 3, 0.9F);
  buffers_.note({2, 3, 3, 4});
  expect_shown(target_);
  EXPECT_EQ(before->stroke, std::vector<std::uint32_t>(30, 0));
}

TEST_F(PaintedBuffersTest, OfAnotherTargetTheRowsThatDifferAreShown) {
  fill_all();
  Target other = target_;
  paint(other, 5, 1, 0.7F);
  other.importance.data[other.importance.index(0, 4)] = 0.5F;
  buffers_.note_change(&target_, other);
  std::vector<std::shared_ptr<const PaintedPictures>> held;
  for (int i = 0; i < 4; ++i) {
    expect_shown(other);
    held.push_back(buffers_.show(other));
  }
  EXPECT_EQ(std::set(held.begin(), held.end()).size(), 4U);
  held.clear();
  buffers_.note_change(nullptr, target_);
  for (int i = 0; i < 4; ++i) expect_shown(target_);
  Target larger;
  larger.color = Image(8, 5, 3, 0.5F);
  larger.importance = Image(8, 5, 1, 0.2F);
  larger.stroke.assign(40, 2);
  buffers_.note_change(&target_, larger);
  expect_shown(larger);
}

TEST_F(PaintedBuffersTest, WhereTheSameIsPaintedNothingIsCopied) {
  fill_all();
  Target same = target_;
  buffers_.note_change(&target_, same);
  paint(same, 1, 1, 0.8F);  // not noted
  EXPECT_EQ(buffers_.show(same)->color.data, target_.color.data);
}

}  // namespace
}  // namespace luminist
