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

  std::unique_ptr<StudioThread> studio_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool go_ = false;
};

TEST_F(StudioThreadTest, AHeldKeyDoesNotWaitForAPictureOfEachStep) {
  constexpr std::size_t kSteps = 40;
  studio_->act("add a light", [](Session& session) -> Result<void> {
    NewLight plain;
    plain.from_paint = false;
    LUM_TRY_VOID(session.add_light(plain));
    for (std::size_t step = 1; step < kSteps; ++step) {
      LUM_TRY_VOID(session.set({fmt::format("ambient/color=0,0,{}", 0.01 * static_cast<double>(step))}));
    }
    return {};
  });
  ASSERT_TRUE(until([this] { return studio_->latest()->history.undo_steps == kSteps; }));
  hold();
  const std::uint64_t before = studio_->latest()->version;
  for (std::size_t step = 0; step < kSteps; ++step) {
    studio_->act_in_series(
        "undo", [](Session& session) { return session.undo(); }, Workbench::After::kFollow);
  }
  release();
  ASSERT_TRUE(until([this] { return studio_->latest()->history.undo_steps == 0; })) << "the last one is always shown";
  EXPECT_LT(studio_->latest()->version - before, kSteps / 2);
  EXPECT_EQ(studio_->latest()->history.redo_steps, kSteps);
}

}  // namespace
}  // namespace luminist
