#include "project/command_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "base/files.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

/// A log file of `count` records, written through the class.
std::string make_log(const TemporaryFolder& folder, int count) {
  const std::string path = folder.file("log.jsonl");
  CommandLog log;
  for (int i = 0; i < count; ++i) LUM_EXPECT_OK(log.append(fmt::format(R"({{"number":{}}})", i)));
  LUM_EXPECT_OK(log.write_to(path));
  return path;
}

void overwrite(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

TEST(CommandLog, ReadsBackWhatWasAppended) {
  const TemporaryFolder folder;
  const std::string path = make_log(folder, 2);
  {
    LUM_ASSERT_OK(CommandLog log, CommandLog::open(path, CommandLog::Access::kWrite));
    LUM_EXPECT_OK(log.append(R"({"number":2})"));
    LUM_EXPECT_OK(log.sync());
  }
  LUM_ASSERT_OK(const CommandLog log, CommandLog::open(path, CommandLog::Access::kRead));
  ASSERT_EQ(log.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    LUM_ASSERT_OK(const std::string text, log.read(i));
    EXPECT_EQ(text, fmt::format(R"({{"number":{}}})", i));
  }
}

TEST(CommandLog, CutAnywhereItOpensWithAPrefixOfItsRecords) {
  const TemporaryFolder folder;
  const std::string path = make_log(folder, 5);
  LUM_ASSERT_OK(const std::string whole, read_file(path));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    overwrite(path, whole.substr(0, length));
    LUM_ASSERT_OK(CommandLog log, CommandLog::open(path, CommandLog::Access::kWrite));
    const auto complete =
        static_cast<std::size_t>(std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
    ASSERT_EQ(log.size(), complete) << "cut at byte " << length;
    // What follows a torn line is a sound log again.
    LUM_EXPECT_OK(log.append(R"({"after":true})"));
    LUM_ASSERT_OK(const CommandLog again, CommandLog::open(path, CommandLog::Access::kRead));
    ASSERT_EQ(again.size(), complete + 1);
    ASSERT_EQ(again.torn_bytes(), 0U);
  }
}

TEST(CommandLog, ReportsTheLineOfDamageInTheMiddle) {
  const TemporaryFolder folder;
  const std::string path = make_log(folder, 5);
  LUM_ASSERT_OK(const std::string whole, read_file(path));
  std::string damaged = whole;
  damaged[whole.find("\"number\":2") + 9] = '7';
  overwrite(path, damaged);
  const Error error = error_of(CommandLog::open(path, CommandLog::Access::kRead));
  EXPECT_EQ(error.kind, ErrorKind::kBadContent);
  EXPECT_EQ(error.where, path + ":3");
}

TEST(CommandLog, NoticesALineThatWasTakenOut) {
  const TemporaryFolder folder;
  const std::string path = make_log(folder, 5);
  LUM_ASSERT_OK(const std::string whole, read_file(path));
  const std::size_t first = whole.find('\n') + 1;
  const std::size_t second = whole.find('\n', first) + 1;
  overwrite(path, whole.substr(0, first) + whole.substr(second));
  EXPECT_EQ(error_of(CommandLog::open(path, CommandLog::Access::kRead)).where, path + ":2");
}

TEST(CommandLog, EveryFlippedByteIsDroppedAtTheEndOrReported) {
  const TemporaryFolder folder;
  const std::string path = make_log(folder, 3);
  LUM_ASSERT_OK(const std::string whole, read_file(path));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x01);
    overwrite(path, damaged);
    const auto log = CommandLog::open(path, CommandLog::Access::kRead);
    if (!log) continue;
    // Without its line break the second line becomes part of the last one.
    const std::size_t intact = whole[at] == '\n' && at + 1 < whole.size() ? 1 : 2;
    ASSERT_EQ((*log).size(), intact) << "byte " << at;
    ASSERT_GT((*log).torn_bytes(), 0U);
  }
}

TEST(CommandLog, RefusesToAppendAfterAnotherProgramWrote) {
  const TemporaryFolder folder;
  const std::string path = make_log(folder, 2);
  LUM_ASSERT_OK(CommandLog log, CommandLog::open(path, CommandLog::Access::kWrite));
  std::ofstream(path, std::ios::app) << "x";
  EXPECT_EQ(error_of(log.append("{}")).kind, ErrorKind::kProject);
  EXPECT_EQ(log.size(), 2U);
}

TEST(CommandLog, ReadingLeavesATornLineInTheFile) {
  const TemporaryFolder folder;
  const std::string path = make_log(folder, 2);
  std::ofstream(path, std::ios::app) << "{\"ha";
  const auto size = std::filesystem::file_size(path);
  LUM_ASSERT_OK(const CommandLog log, CommandLog::open(path, CommandLog::Access::kRead));
  EXPECT_EQ(log.size(), 2U);
  EXPECT_EQ(log.torn_bytes(), 4U);
  EXPECT_EQ(std::filesystem::file_size(path), size);
}

}  // namespace
}  // namespace luminist
