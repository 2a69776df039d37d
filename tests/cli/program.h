#pragma once
// tests/cli/program.h -- the program as a user runs it.
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "base/files.h"
#include "support/ball_scene.h"
#include "support/fixtures.h"

namespace luminist {

struct Outcome {
  int status = 0;  ///< 128 + the signal that ended it
  std::string out;
  std::string err;
};

/// Runs a shell command in a folder; "$LUMINIST" is the program.
inline Outcome shell(const std::string& command, const std::filesystem::path& folder) {
  ::setenv("LUMINIST", LUMINIST_EXECUTABLE, 1);
  const std::filesystem::path err = folder / ".stderr";
  const std::string line = "cd '" + folder.string() + "' || exit 99\n( " + command + "\n) 2>'" + err.string() + "'";
  Outcome outcome;
  FILE* pipe = ::popen(line.c_str(), "r");
  if (pipe == nullptr) return {98, "", "no shell"};
  char buffer[4096];
  for (std::size_t got = 0; (got = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) outcome.out.append(buffer, got);
  const int status = ::pclose(pipe);
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (auto text = read_file(err)) outcome.err = *text;
  return outcome;
}

/// A folder with a scene (ball.obj), strokes (light.json) and a rig (rig.toml), in which the program runs.
class CliTest : public testing::Test {
 protected:
  CliTest() {
    write("ball.obj", ball_obj());
    write("ball.mtl", ball_material());
    write("light.json", R"({"strokes": [{"color": [1, 0.9, 0.8], "diameter": 0.5, "gradient": 1, "add_light": true,
                           "points": [[0.6, 0.4], [0.7, 0.5]]}]})");
    write("rig.toml", "[[light]]\nname = \"key\"\ntype = \"cinematic\"\n");
  }

  Outcome luminist(const std::string& words) { return shell("\"$LUMINIST\" " + words, folder_.path()); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_.file(name)) << text; }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(folder_.path() / name); }
  [[nodiscard]] std::string read(const std::string& name) const {
    auto text = read_file(folder_.path() / name);
    EXPECT_TRUE(text) << name;
    return text ? *text : "";
  }

  /// The program ended with that status and said why in one line that names the error.
  static void expect_error(const Outcome& outcome, int status) {
    EXPECT_EQ(outcome.status, status) << outcome.err;
    const std::string start = "luminist: error[E" + std::to_string(status) + "00]";
    const std::size_t line = outcome.err.find(start);
    ASSERT_NE(line, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("error[", line + start.size()), std::string::npos) << "more than one: " << outcome.err;
    EXPECT_EQ(outcome.err.find('\n', line) + 1, outcome.err.size()) << outcome.err;
  }

  TemporaryFolder folder_;
};

}  // namespace luminist
