#pragma once
// tests/studio/workbench_fixture.h -- a workbench on the session fixture's ball.
#include <memory>
#include <span>
#include <string>

#include "studio/session_fixture.h"
#include "studio/workbench.h"

namespace luminist {

class WorkbenchTest : public SessionTest {
 protected:
  void SetUp() override {
    SessionTest::SetUp();
    session_.reset();
    bench_ = std::make_unique<Workbench>(*device_, roots_, folder_.path() / "unsaved");
    LUM_EXPECT_OK(bench_->open(shot(), folder_.path()));
  }
  void TearDown() override { bench_.reset(); }

  std::shared_ptr<const StudioSnapshot> look() {
    auto snapshot = bench_->snapshot();
    EXPECT_TRUE(snapshot) << snapshot.error().message();
    return *snapshot;
  }
  std::string document_hash() {
    std::string hash;
    LUM_EXPECT_OK(bench_->act([&](Session& session) -> Result<void> {
      hash = session.project().document().hash();
      return {};
    }));
    return hash;
  }
  void add_dark_light() {
    LUM_EXPECT_OK(bench_->act([](Session& session) -> Result<void> {
      NewLight wanted;
      wanted.dark = true;
      LUM_TRY_VOID(session.add_light(wanted));
      return {};
    }));
  }
  /// The fixture's stroke as a hand draws it.
  void draw_stroke() {
    const Stroke whole = light_strokes().strokes.front();
    LUM_EXPECT_OK(bench_->begin_stroke({whole.brush, {whole.points.front()}}, folder_.path()));
    LUM_EXPECT_OK(bench_->extend_stroke(std::span(whole.points).subspan(1)));
    LUM_EXPECT_OK(bench_->end_stroke());
  }
  void rest() {
    for (int i = 0; i < 2000; ++i) {
      LUM_ASSERT_OK(const bool more, bench_->step(std::chrono::milliseconds(5)));
      if (!more) return;
    }
    ADD_FAILURE() << "the lights never come to rest";
  }

  std::unique_ptr<Workbench> bench_;
};

}  // namespace luminist
