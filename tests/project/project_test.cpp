#include "project/project.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <random>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "support/fixtures.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

Document small_document() {
  Document document;
  document.set("lights/key/color", "[1.0,1.0,1.0]");
  document.set("from/the/future", R"({"kept":true})");
  return document;
}

Project new_project() {
  return Project::start(small_document(), R"({"do":"open"})");
}

Command set_command(const Project& project, const std::string& path, const std::string& value) {
  return {"Set " + path, R"({"do":"set"})", {{path, std::string(project.document().get(path)), value}}};
}

/// One random action: mostly commands on a few paths, some undoing and redoing.
void act(Project& project, std::mt19937& random) {
  const unsigned choice = random() % 10;
  if (choice < 6) {
    const std::string path = fmt::format("path/{}", random() % 20);
    const std::string value = random() % 5 == 0 ? "" : std::to_string(random());
    LUM_EXPECT_OK(project.execute(set_command(project, path, value)));
  } else if (choice < 9 && project.undo_steps() > 0) {
    LUM_EXPECT_OK(project.undo());
  } else if (project.redo_steps() > 0) {
    LUM_EXPECT_OK(project.redo());
  }
}

TEST(Project, UndoesAndRedoes) {
  Project project = new_project();
  const std::string start = project.document().hash();
  LUM_EXPECT_OK(project.execute(set_command(project, "a", "1")));
  LUM_EXPECT_OK(project.execute(set_command(project, "a", "2")));
  const std::string end = project.document().hash();
  LUM_ASSERT_OK(const std::vector<Edit> edits, project.undo());
  ASSERT_EQ(edits.size(), 1U);
  EXPECT_EQ(edits[0].after, "1");
  LUM_EXPECT_OK(project.undo());
  EXPECT_EQ(project.document().hash(), start);
  EXPECT_EQ(error_of(project.undo()).kind, ErrorKind::kNothingToDo);
  LUM_EXPECT_OK(project.redo());
  LUM_EXPECT_OK(project.redo());
  EXPECT_EQ(project.document().hash(), end);
  EXPECT_EQ(error_of(project.redo()).kind, ErrorKind::kNothingToDo);
}

TEST(Project, ANewCommandEndsRedoing) {
  Project project = new_project();
  LUM_EXPECT_OK(project.execute(set_command(project, "a", "1")));
  LUM_EXPECT_OK(project.undo());
  LUM_EXPECT_OK(project.execute(set_command(project, "b", "1")));
  EXPECT_EQ(project.redo_steps(), 0U);
  EXPECT_EQ(project.undo_steps(), 1U);
  LUM_ASSERT_OK(const Command command, project.command(0));
  EXPECT_EQ(command.label, "Set b");
}

TEST(Project, TenThousandRandomActionsUndoneAreTheStart) {
  const TemporaryFolder folder;
  Project project = new_project();
  const std::string start = project.document().hash();
  LUM_EXPECT_OK(project.save_as(folder.path() / "a.lum"));
  std::mt19937 random(1);
  for (int i = 0; i < 10000; ++i) act(project, random);
  const std::string end = project.document().hash();
  const std::size_t steps = project.undo_steps();
  while (project.redo_steps() > 0) LUM_EXPECT_OK(project.redo());
  while (project.undo_steps() > 0) LUM_EXPECT_OK(project.undo());
  EXPECT_EQ(project.document().hash(), start);
  while (project.undo_steps() < steps) LUM_EXPECT_OK(project.redo());
  EXPECT_EQ(project.document().hash(), end);
}

TEST(Project, SurvivesARestartWithItsHistory) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  std::string hash;
  std::string start;
  {
    Project project = new_project();
    start = project.document().hash();
    LUM_EXPECT_OK(project.execute(set_command(project, "a", "1")));
    LUM_EXPECT_OK(project.save_as(path));
    std::mt19937 random(2);
    for (int i = 0; i < 300; ++i) act(project, random);
    LUM_EXPECT_OK(project.save());
    for (int i = 0; i < 50; ++i) act(project, random);  // not saved, and not lost either
    hash = project.document().hash();
  }
  ASSERT_TRUE(fs::exists(path / "checkpoint.json"));
  for (const bool with_checkpoint : {true, false}) {
    if (!with_checkpoint) fs::remove(path / "checkpoint.json");
    LUM_ASSERT_OK(Project project, Project::open(path, Project::Access::kWrite));
    EXPECT_EQ(project.document().hash(), hash);
    std::size_t undone = 0;
    while (project.undo_steps() > 0) {
      LUM_EXPECT_OK(project.undo());
      ++undone;
    }
    EXPECT_EQ(project.document().hash(), start);
    while (undone-- > 0) LUM_EXPECT_OK(project.redo());
    EXPECT_EQ(project.document().hash(), hash);
  }
}

TEST(Project, IgnoresACheckpointThatDoesNotFitTheLog) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  Project project = new_project();
  LUM_EXPECT_OK(project.save_as(path));
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) act(project, random);
  LUM_EXPECT_OK(project.save());
  const std::string hash = project.document().hash();
  LUM_ASSERT_OK(const std::string checkpoint, read_file(path / "checkpoint.json"));
  auto foreign = nlohmann::json::parse(checkpoint);
  foreign["seal"] = "0000000000000000";
  foreign["document"] = nlohmann::json::object();
  for (const std::string& bytes : {std::string("{"), std::string("[]"), foreign.dump(), checkpoint.substr(0, 200)}) {
    std::ofstream(path / "checkpoint.json", std::ios::trunc) << bytes;
    LUM_ASSERT_OK(const Project opened, Project::open(path, Project::Access::kRead));
    EXPECT_EQ(opened.document().hash(), hash);
  }
}

TEST(Project, CutAnywhereItsLogOpensInAnEarlierState) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  std::vector<std::string> states;
  {
    Project project = new_project();
    states.push_back(project.document().hash());
    std::mt19937 random(4);
    LUM_EXPECT_OK(project.save_as(path));
    const auto note = [&] { states.push_back(project.document().hash()); };
    for (int i = 0; i < 4; ++i) {
      LUM_EXPECT_OK(project.execute(set_command(project, "a", std::to_string(i))));
      note();
    }
    LUM_EXPECT_OK(project.undo());
    note();
    LUM_EXPECT_OK(project.redo());
    note();
  }
  LUM_ASSERT_OK(const std::string whole, read_file(path / "log.jsonl"));
  for (std::size_t length = whole.size(); length-- > 0;) {
    std::ofstream(path / "log.jsonl", std::ios::trunc | std::ios::binary) << whole.substr(0, length);
    const auto lines =
        static_cast<std::size_t>(std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length), '\n'));
    const auto project = Project::open(path, Project::Access::kRead);
    if (lines == 0) {
      EXPECT_EQ(error_of(project).kind, ErrorKind::kBadContent);
      continue;
    }
    ASSERT_TRUE(project) << project.error().message();
    ASSERT_EQ((*project).document().hash(), states[lines - 1]) << "cut at byte " << length;
  }
}

/// Writes commands without end and tells through the pipe how many were accepted.
[[noreturn]] void write_for_ever(const fs::path& path, int pipe_end) {
  auto project = Project::open(path, Project::Access::kWrite);
  if (!project) ::_exit(1);
  for (std::uint32_t i = 0;; ++i) {
    if (!(*project).execute(set_command(*project, "count", std::to_string(i)))) ::_exit(2);
    if (::write(pipe_end, &i, sizeof i) != sizeof i) ::_exit(3);
  }
}

TEST(Project, AKilledWriterLosesNothingThatItAcknowledged) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  {
    Project project = new_project();
    LUM_EXPECT_OK(project.save_as(path));
  }
  for (int round = 0; round < 10; ++round) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) write_for_ever(path, ends[1]);
    ::close(ends[1]);
    std::uint32_t acknowledged = 0;
    for (int i = 0; i < 50 * (round + 1); ++i) ASSERT_EQ(::read(ends[0], &acknowledged, 4), 4);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    while (::read(ends[0], &acknowledged, 4) == 4) continue;
    ::close(ends[0]);
    LUM_ASSERT_OK(const Project project, Project::open(path, Project::Access::kWrite));
    EXPECT_GE(std::stoul(std::string(project.document().get("count"))), acknowledged);
  }
}

TEST(Project, ASecondWriterIsRefusedAndAReaderIsNot) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  Project project = new_project();
  LUM_EXPECT_OK(project.save_as(path));
  const Error error = error_of(Project::open(path, Project::Access::kWrite));
  EXPECT_EQ(error.kind, ErrorKind::kProject);
  EXPECT_NE(error.what.find(std::to_string(::getpid())), std::string::npos) << error.what;
  LUM_ASSERT_OK(Project reader, Project::open(path, Project::Access::kRead));
  EXPECT_EQ(error_of(reader.execute(set_command(reader, "a", "1"))).kind, ErrorKind::kProject);
  EXPECT_EQ(error_of(reader.save()).kind, ErrorKind::kProject);
}

TEST(Project, OfManyWritersExactlyOneGetsIn) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  {
    Project project = new_project();
    LUM_EXPECT_OK(project.save_as(path));
  }
  for (int race = 0; race < 50; ++race) {
    int start[2];
    int done[2];
    ASSERT_EQ(::pipe(start) + ::pipe(done), 0);
    std::vector<pid_t> children;
    for (int i = 0; i < 4; ++i) {
      children.push_back(::fork());
      if (children.back() != 0) continue;
      ::close(start[1]);
      char wait = 0;
      (void)!::read(start[0], &wait, 1);  // all leave when the parent closes the pipe
      const auto project = Project::open(path, Project::Access::kWrite);
      const char answer = project ? '1' : project.error().kind == ErrorKind::kProject ? '0' : '?';
      (void)!::write(done[1], &answer, 1);
      (void)!::read(done[0], nullptr, 0);
      ::pause();  // holds the lock until it is killed
      ::_exit(0);
    }
    ::close(start[0]);
    ::close(start[1]);
    std::string answers;
    for (char answer = 0; answers.size() < 4 && ::read(done[0], &answer, 1) == 1;) answers.push_back(answer);
    for (const pid_t child : children) ::kill(child, SIGKILL), ::waitpid(child, nullptr, 0);
    ::close(done[0]);
    ::close(done[1]);
    EXPECT_EQ(std::count(answers.begin(), answers.end(), '1'), 1) << answers;
    EXPECT_EQ(std::count(answers.begin(), answers.end(), '0'), 3) << answers;
  }
}

TEST(Project, RespectsALockFromAnotherMachineAndTakesOverADeadOne) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  {
    Project project = new_project();
    LUM_EXPECT_OK(project.save_as(path));
  }
  std::ofstream(path / "lock", std::ios::trunc) << R"({"host":"some other machine","pid":1,"start":1})";
  EXPECT_EQ(error_of(Project::open(path, Project::Access::kWrite)).kind, ErrorKind::kProject);
  char host[256] = {};
  ASSERT_EQ(::gethostname(host, sizeof host - 1), 0);
  std::ofstream(path / "lock", std::ios::trunc) << nlohmann::json{{"host", host}, {"pid", 1}, {"start", 987654321}};
  LUM_EXPECT_OK(Project::open(path, Project::Access::kWrite));
  std::ofstream(path / "lock", std::ios::trunc) << "{\"host\":5}";
  LUM_EXPECT_OK(Project::open(path, Project::Access::kWrite));
}

TEST(Project, OfANewerVersionIsReadAndNotWritten) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  fs::create_directory(path);
  CommandLog log;
  LUM_EXPECT_OK(log.append(R"({"start":{"format":2,"new":1},"action":{},"document":{"a":1},"more":[]})"));
  LUM_EXPECT_OK(log.append(R"({"teleport":{"to":"b"}})"));
  LUM_EXPECT_OK(log.write_to(path / "log.jsonl"));
  const Error error = error_of(Project::open(path, Project::Access::kWrite));
  EXPECT_EQ(error.kind, ErrorKind::kProject);
  EXPECT_EQ(error.where, (path / "log.jsonl").string() + ":1");
  LUM_ASSERT_OK(const Project project, Project::open(path, Project::Access::kRead));
  EXPECT_EQ(project.document().get("a"), "1");
  EXPECT_EQ(project.unknown_records(), 1U);
}

TEST(Project, KeepsWhatItDoesNotKnow) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  {
    Project project = new_project();
    LUM_EXPECT_OK(project.execute(set_command(project, "a", "1")));
    LUM_EXPECT_OK(project.save_as(path));
    LUM_EXPECT_OK(project.save_as(folder.path() / "b.lum"));
  }
  LUM_ASSERT_OK(const Project project, Project::open(folder.path() / "b.lum", Project::Access::kRead));
  EXPECT_EQ(project.document().get("from/the/future"), R"({"kept":true})");
}

TEST(Project, TidiesUpAfterAWriterThatDied) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  {
    Project project = new_project();
    LUM_EXPECT_OK(project.tiles().put("paint"));
    LUM_EXPECT_OK(project.save_as(path));
  }
  const fs::path tile_folder = fs::directory_iterator(path / "tiles")->path();
  for (const fs::path& leftover : {path / ".lum-1-ab", tile_folder / ".lum-1-cd"}) std::ofstream(leftover) << "x";
  LUM_EXPECT_OK(Project::open(path, Project::Access::kRead));
  EXPECT_TRUE(fs::exists(path / ".lum-1-ab"));
  LUM_EXPECT_OK(Project::open(path, Project::Access::kWrite));
  EXPECT_FALSE(fs::exists(path / ".lum-1-ab"));
  EXPECT_FALSE(fs::exists(tile_folder / ".lum-1-cd"));
  EXPECT_EQ(std::distance(fs::directory_iterator(tile_folder), fs::directory_iterator()), 1);
}

TEST(Project, DoesNotOverwriteAFolderThatIsNoProject) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "holiday.lum");
  std::ofstream(folder.path() / "holiday.lum" / "photo") << "x";
  Project project = new_project();
  EXPECT_EQ(error_of(project.save_as(folder.path() / "holiday.lum")).kind, ErrorKind::kUnwritable);
  EXPECT_EQ(error_of(project.save_as(folder.path() / "name")).kind, ErrorKind::kUsage);
  EXPECT_EQ(error_of(project.save()).kind, ErrorKind::kUsage);
  std::ofstream(folder.file("file")) << "x";
  EXPECT_EQ(error_of(project.save_as(folder.path() / "file" / "a.lum")).kind, ErrorKind::kUnwritable);
}

TEST(Project, AnEditOutsideIsNoticedBeforeItIsLost) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.lum";
  Project project = new_project();
  LUM_EXPECT_OK(project.save_as(path));
  std::ofstream(path / "log.jsonl", std::ios::app) << "foreign\n";
  const std::string hash = project.document().hash();
  EXPECT_EQ(error_of(project.execute(set_command(project, "a", "1"))).kind, ErrorKind::kProject);
  EXPECT_EQ(project.document().hash(), hash);
  EXPECT_EQ(error_of(project.save()).kind, ErrorKind::kProject);
}

}  // namespace
}  // namespace luminist
