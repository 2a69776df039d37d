#include "bench/run_store.h"

#include <gtest/gtest.h>

#include <fstream>

#include "bench/bench_report.h"
#include "bench/painted.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

BenchKey key(std::uint64_t seed) {
  return {"table1", "bust", "18 full", "fast", 64, 48, "200 RE", seed};
}

BenchRun some_run() {
  BenchRun run;
  run.dofs = 18;
  run.success = true;
  run.epsilon_start = 0.5;
  run.epsilon = 0.01;
  run.equivalents = 2.5;
  run.convergence = {{1.0, 1, 0.1, 0.5}, {2.5, 2, 0.2, 0.01}};
  return run;
}

TEST(RunStore, ARunThatIsThereIsNotMadeAgain) {
  const TemporaryFolder folder;
  int made = 0;
  const auto make = [&]() -> Result<BenchRun> {
    ++made;
    return some_run();
  };
  for (int round = 0; round < 2; ++round) {
    LUM_ASSERT_OK(RunStore store, RunStore::open(folder.file("runs.jsonl"), false));
    LUM_ASSERT_OK(const BenchRun run, store.find_or_make(key(1), make));
    EXPECT_EQ(run.key.text(), key(1).text());
    EXPECT_DOUBLE_EQ(run.equivalents, 2.5);
    ASSERT_EQ(run.convergence.size(), 2U);
    EXPECT_DOUBLE_EQ(run.convergence[1].epsilon, 0.01);
  }
  EXPECT_EQ(made, 1);
}

TEST(RunStore, AnotherSeedIsAnotherRun) {
  const TemporaryFolder folder;
  int made = 0;
  const auto make = [&]() -> Result<BenchRun> {
    ++made;
    return some_run();
  };
  LUM_ASSERT_OK(RunStore store, RunStore::open(folder.file("runs.jsonl"), false));
  LUM_EXPECT_OK(store.find_or_make(key(1), make));
  LUM_EXPECT_OK(store.find_or_make(key(2), make));
  EXPECT_EQ(made, 2);
}

TEST(RunStore, ATornLastLineIsIgnoredAndDoesNotSpoilTheNext) {
  const TemporaryFolder folder;
  const std::string file = folder.file("runs.jsonl");
  const auto make = [] { return Result<BenchRun>(some_run()); };
  {
    LUM_ASSERT_OK(RunStore store, RunStore::open(file, false));
    LUM_EXPECT_OK(store.find_or_make(key(1), make));
  }
  std::ofstream(file, std::ios::app) << R"({"key": {"bench": "tab)";
  {
    LUM_ASSERT_OK(RunStore store, RunStore::open(file, false));
    EXPECT_EQ(store.size(), 1U);
    LUM_EXPECT_OK(store.find_or_make(key(2), make));
  }
  LUM_ASSERT_OK(const RunStore store, RunStore::open(file, false));
  EXPECT_EQ(store.size(), 2U);
}

TEST(RunStore, FreshForgetsWhatWasThere) {
  const TemporaryFolder folder;
  const std::string file = folder.file("runs.jsonl");
  {
    LUM_ASSERT_OK(RunStore store, RunStore::open(file, false));
    LUM_EXPECT_OK(store.find_or_make(key(1), [] { return Result<BenchRun>(some_run()); }));
  }
  LUM_ASSERT_OK(const RunStore store, RunStore::open(file, true));
  EXPECT_EQ(store.size(), 0U);
}

TEST(BenchReport, ARunThatMissedItsGoalGivesABound) {
  BenchRun missed = some_run();
  missed.success = false;
  const BenchReport report{{missed, missed, some_run()}};
  EXPECT_TRUE(report.equivalents().at_least);
  EXPECT_NEAR(report.success(), 1.0 / 3.0, 1e-12);
  EXPECT_NE(to_json_line(report).find("\"at_least\":true"), std::string::npos);
}

TEST(BenchReport, TimeAtAnotherSizeFollowsByCounts) {
  BenchRun fast = some_run();
  fast.key = key(1);
  fast.seconds = 0.1;
  fast.evaluation_seconds = 0.02;
  BenchRun slow = some_run();
  slow.key = key(1);
  slow.key.width = 32;
  slow.evals = 1000;
  slow.equivalents = 1000.0;
  slow.seconds = 3.0;
  const SpeedUp by_counts = speed_up({{slow}}, {{fast}});
  EXPECT_FALSE(by_counts.measured);
  EXPECT_NEAR(by_counts.work.value, 400.0, 1e-9);
  EXPECT_NEAR(by_counts.time.value, 200.0, 1e-9);  // 1,000 pictures of 0.02 s over 0.1 s
  slow.key.width = fast.key.width;
  EXPECT_NEAR(speed_up({{slow}}, {{fast}}).time.value, 30.0, 1e-9);
}

TEST(Painted, ARunIsJudgedByTheFirstPointThatReachesTheGoal) {
  BenchRun run = some_run();
  run.convergence = {{1.0, 1, 0.1, 0.5}, {2.0, 2, 0.2, 0.12}, {9.0, 5, 0.9, 0.1}};
  run.total_equivalents = 20.0;
  const double goal = painted_goal(0.5, 0.1);
  EXPECT_NEAR(goal, 0.12, 1e-12);
  const BenchRun reached = judged(run, goal + 1e-12);
  EXPECT_TRUE(reached.success);
  EXPECT_DOUBLE_EQ(reached.equivalents, 2.0);
  const BenchRun missed = judged(run, 0.05);
  EXPECT_FALSE(missed.success);
  EXPECT_DOUBLE_EQ(missed.equivalents, 20.0);
}

}  // namespace
}  // namespace luminist
