#include "studio/farm.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "support/fixtures.h"

namespace luminist {
namespace {

std::string run(const std::string& command) {
  std::string output;
  FILE* pipe = ::popen(command.c_str(), "r");
  EXPECT_NE(pipe, nullptr);
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return output;
}

/// A program that prints its arguments, one a line.
class FarmTest : public testing::Test {
 protected:
  FarmTest() {
    const std::string program = folder_.file("say it's.sh");
    std::ofstream(program) << "#!/bin/sh\nfor word in \"$@\"; do echo \"$word\"; done\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    job_.program = program;
    job_.arguments = {"a scene's.glb", "--set", "lights/key/color=1,0,0", "-o", "f.####.exr"};
  }
  TemporaryFolder folder_;
  FarmJob job_;
};

TEST_F(FarmTest, EveryFrameIsInOneCommand) {
  job_.range = {3, 20, 4};  // 3 7 11 15 19
  job_.chunk = 2;
  const std::vector<std::string> commands = farm_commands(job_);
  ASSERT_EQ(commands.size(), 3U);
  std::vector<int> frames;
  for (const std::string& command : commands) {
    const std::string said = run(command);
    EXPECT_EQ(said.rfind("render\na scene's.glb\n--set\nlights/key/color=1,0,0\n-o\nf.####.exr\n--frames=", 0), 0U);
    const std::string range = said.substr(said.rfind('=') + 1, said.size() - said.rfind('=') - 2);
    LUM_ASSERT_OK(const FrameRange part, FrameRange::parse(range));
    for (const int frame : part.frames()) frames.push_back(frame);
  }
  EXPECT_EQ(frames, job_.range.frames());
}

TEST_F(FarmTest, TheSlurmScriptRunsTheChunkOfItsTask) {
  job_.range = {0, 9, 1};
  job_.chunk = 4;
  LUM_EXPECT_OK(write_farm_job(job_, folder_.path() / "job"));
  const std::string script = folder_.file("job/job.sh");
  LUM_ASSERT_OK(const std::string text, read_file(script));
  EXPECT_NE(text.find("#SBATCH --array=0-2\n"), std::string::npos);
  const std::string said = run("SLURM_ARRAY_TASK_ID=2 '" + script + "'");
  EXPECT_NE(said.find("--frames=8-9\n"), std::string::npos);
  LUM_ASSERT_OK(const std::string commands, read_file(folder_.file("job/commands.txt")));
  EXPECT_EQ(std::count(commands.begin(), commands.end(), '\n'), 3);
}

}  // namespace
}  // namespace luminist
