// The thread that a window posts to.
#include "studio/studio_thread.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include <fmt/format.h>

#include "studio/moving_session.h"

namespace luminist {
namespace {

class StudioThreadTest : public MovingSessionTest {
 protected:
  void SetUp() override {
    MovingSessionTest::SetUp();
    session_.reset();
    studio_ = std::make_unique<StudioThread>(StudioThread::Options{roots_, folder_.path() / "unsaved", {}});
    studio_->post("open", [this](Workbench& bench) { return bench.open(moving_, folder_.path()); });
    ASSERT_TRUE(until([this] { return studio_->latest()->facts != nullptr; }));
  }
  void TearDown() override {
    release();
    studio_.reset();
  }
  template <class Holds>
  bool until(const Holds& holds) {
    for (int i = 0; i < 3000 && !holds(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return holds();
  }
  /// What is posted from now on waits until release().
  void hold() {
    studio_->post("hold", [this](Workbench&) -> Result<void> {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return go_; });
      return {};
    });
    ASSERT_TRUE(until([this] { return studio_->activity().label == "hold"; }));
  }
  void release() {
    {
      const std::lock_guard lock(mutex_);
      go_ = true;
    }
    wake_.notify_one();
  }

  /// A session with that many steps.
  void take(std::size_t steps) {
    studio_->act("add a light", [steps](Session& session) -> Result<void> {
      NewLight plain;
      plain.from_paint = false;
      LUM_TRY_VOID(session.add_light(plain));
      for (std::size_t step = 1; step < steps; ++step) {
        LUM_TRY_VOID(session.set({fmt::format("ambient/color=0,0,{}", 0.01 * static_cast<double>(step))}));
      }
      return {};
    });
    ASSERT_TRUE(until([this, steps] { return studio_->latest()->history.undo_steps == steps; }));
  }
  /// Takes back that many steps, as a held key does; a step takes so long. returns how many of them were shown.
  std::size_t undo(std::size_t steps, std::chrono::milliseconds each) {
    hold();
    const std::uint64_t before = studio_->latest()->version;
    for (std::size_t step = 0; step < steps; ++step) {
      const auto slowly = [each](Session& session) {
        std::this_thread::sleep_for(each);
        return session.undo();
      };
      studio_->act_in_series("undo", slowly, Workbench::After::kFollow);
    }
    std::uint64_t between = before;  // the last version in which there was still something to take back
    release();
    EXPECT_TRUE(until([&] {
      const auto now = studio_->latest();
      if (now->history.undo_steps > 0) between = now->version;
      return now->history.undo_steps == 0;
    })) << "the last one is always shown";
    return static_cast<std::size_t>(between - before);
  }

  std::unique_ptr<StudioThread> studio_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool go_ = false;
};

TEST_F(StudioThreadTest, AHeldKeyDoesNotWaitForAPictureOfEachStep) {
  constexpr std::size_t kSteps = 40;
  take(kSteps);
  EXPECT_LT(undo(kSteps, std::chrono::milliseconds(0)), kSteps / 2);
  EXPECT_EQ(studio_->latest()->history.redo_steps, kSteps);
}

TEST_F(StudioThreadTest, AHeldKeyShowsSomeOfItsSteps) {
  constexpr std::size_t kSteps = 10;
  take(kSteps);
  EXPECT_GT(undo(kSteps, std::chrono::milliseconds(60)), 2U) << "one of two or three";
}

TEST_F(StudioThreadTest, LeavesOvertakenPreviewsOutAndMakesTheStripWhenIdle) {
  ASSERT_TRUE(until([this] { return studio_->latest()->frames != nullptr; }));
  studio_->want_strip(3, 12);
  EXPECT_TRUE(until([this] { return studio_->latest()->frames->strip.size() == 3; }));
  hold();
  for (int frame = 1; frame <= 20; ++frame) studio_->preview_frame(frame);
  EXPECT_EQ(studio_->activity().waiting, 1U);
  studio_->go_to(5);
  EXPECT_EQ(studio_->activity().waiting, 1U);  // in place of the preview
  release();
  EXPECT_TRUE(until([this] { return studio_->latest()->frames->frame == 5.0; }));
  EXPECT_FALSE(studio_->latest()->frames->previewed);
  studio_->preview_frame(7);
  EXPECT_TRUE(until([this] { return studio_->latest()->frames->previewed == 7.0; }));
  studio_->go_to(5);
  EXPECT_TRUE(until([this] { return !studio_->latest()->frames->previewed; }));
  EXPECT_EQ(studio_->latest()->history.undo_steps, 1U);  // previews and going nowhere are no gestures
}

}  // namespace
}  // namespace luminist
