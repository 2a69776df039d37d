#include "base/process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <random>
#include <thread>

#include "support/fixtures.h"

namespace luminist {
namespace {

using namespace std::chrono_literals;

ProcessRequest shell(const std::string& script, std::string& output) {
  ProcessRequest request;
  request.arguments = {"/bin/sh", "-c", script};
  request.on_output = [&output](std::string_view bytes) { output += bytes; };
  return request;
}

TEST(Process, GivesTheInputAndTakesTheOutputWhateverTheirSize) {
  std::mt19937 random(1);
  std::string large(3'000'000, '\0');  // many times what a pipe holds, both ways at once
  for (char& c : large) c = static_cast<char>(random());
  std::string output;
  ProcessRequest request = shell("cat", output);
  request.input = {"head", "", large, "tail"};
  LUM_ASSERT_OK(const ProcessEnd end, run_process(request));
  EXPECT_TRUE(end.ok());
  EXPECT_TRUE(output == "head" + large + "tail");
}

TEST(Process, ReportsTheExitStatusAndTheLastErrorLine) {
  std::string output;
  LUM_ASSERT_OK(const ProcessEnd end, run_process(shell("echo one >&2; echo two >&2; exit 3", output)));
  EXPECT_EQ(end.exit_status, 3);
  EXPECT_EQ(end.errors, "one\ntwo\n");
  EXPECT_EQ(end.description(), "ended with status 3: two");
}

TEST(Process, ReportsTheSignalThatEndedTheChild) {
  std::string output;
  LUM_ASSERT_OK(const ProcessEnd end, run_process(shell("kill -9 $$", output)));
  EXPECT_EQ(end.signal, SIGKILL);
  EXPECT_FALSE(end.ok());
}

TEST(Process, IsNotDisturbedByAChildThatDoesNotReadItsInput) {
  const std::string large(3'000'000, 'x');
  std::string output;
  ProcessRequest request = shell("echo done", output);
  request.input = {large};
  LUM_ASSERT_OK(const ProcessEnd end, run_process(request));  // SIGPIPE would have ended this test
  EXPECT_EQ(end.exit_status, 0);
  EXPECT_EQ(output, "done\n");
}

TEST(Process, EndsASilentChild) {
  std::string output;
  ProcessRequest request = shell("exec sleep 60", output);
  request.longest_silence = 100ms;
  LUM_ASSERT_OK(const ProcessEnd end, run_process(request));
  EXPECT_TRUE(end.timed_out);
  EXPECT_EQ(end.signal, SIGKILL);
}

TEST(Process, EndsAChildThatClosesItsOutputsAndLingers) {
  std::string output;
  ProcessRequest request = shell("exec 1>&- 2>&-; exec sleep 60", output);
  request.longest_silence = 100ms;
  LUM_ASSERT_OK(const ProcessEnd end, run_process(request));
  EXPECT_TRUE(end.timed_out);
}

TEST(Process, WaitsLongerThanTheLimitForAChildThatKeepsTalking) {
  std::string output;
  ProcessRequest request = shell("for i in 1 2 3 4 5 6; do echo $i; sleep 0.1; done", output);
  request.longest_silence = 400ms;
  LUM_ASSERT_OK(const ProcessEnd end, run_process(request));
  EXPECT_TRUE(end.ok());
  EXPECT_EQ(output, "1\n2\n3\n4\n5\n6\n");
}

TEST(Process, SaysWhatCannotBeStarted) {
  ProcessRequest request;
  request.arguments = {"/no/such/program"};
  const Error error = error_of(run_process(request));
  EXPECT_EQ(error.kind, ErrorKind::kChild);
  EXPECT_EQ(error.where, "/no/such/program");
}

TEST(Process, KeepsOnlyTheEndOfALongErrorOutput) {
  std::string output;
  LUM_ASSERT_OK(const ProcessEnd end,
                run_process(shell("i=0; while [ $i -lt 4000 ]; do echo line $i >&2; i=$((i+1)); done", output)));
  EXPECT_LE(end.errors.size(), 16384U);
  EXPECT_NE(end.errors.find("line 3999"), std::string::npos);
}

Result<ChildProcess> shell_process(const std::string& script) {
  return ChildProcess::start({"/bin/sh", "-c", script});
}

/// What a child says to a line, or "" if it did not say a whole one.
std::string answer_of(ChildProcess& child, const std::string& line, std::chrono::milliseconds patience = 20s) {
  std::string answer;
  const bool enough = child.ask(
      {line, "\n"},
      [&answer](std::string_view bytes) {
        answer += bytes;
        return answer.ends_with('\n');
      },
      patience);
  return enough ? answer : "";
}

TEST(ChildProcess, AnswersAgainAndAgain) {
  LUM_ASSERT_OK(ChildProcess child, shell_process("while read -r line; do echo \"$line, heard\"; done; exit 5"));
  EXPECT_EQ(answer_of(child, "one"), "one, heard\n");
  EXPECT_TRUE(child.waits());
  EXPECT_EQ(answer_of(child, "two"), "two, heard\n");
  EXPECT_EQ(child.end(20s).exit_status, 5);
}

TEST(ChildProcess, ThatIsSilentIsGivenUpAndKilled) {
  LUM_ASSERT_OK(ChildProcess child, shell_process("read -r line; exec sleep 60"));
  EXPECT_EQ(answer_of(child, "one", 100ms), "");
  const ProcessEnd end = child.end(20s);
  EXPECT_TRUE(end.timed_out);
  EXPECT_EQ(end.signal, SIGKILL);
}

TEST(ChildProcess, DoesNotWaitOnceItIsGone) {
  LUM_ASSERT_OK(ChildProcess child, shell_process("read -r line; echo last; exit 0"));
  EXPECT_EQ(answer_of(child, "one"), "last\n");
  EXPECT_EQ(answer_of(child, "two"), "");
  EXPECT_FALSE(child.waits());
}

TEST(ChildProcess, DoesNotWaitOnceItSaysWhatNobodyAsked) {
  LUM_ASSERT_OK(ChildProcess child,
                shell_process("read -r line; echo heard; read -r go < /dev/null; sleep 0.1; echo more; exec sleep 60"));
  EXPECT_EQ(answer_of(child, "one"), "heard\n");
  for (int i = 0; i < 1000 && child.waits(); ++i) std::this_thread::sleep_for(20ms);
  EXPECT_FALSE(child.waits());
}

TEST(ChildProcess, GetsAllOfItsInputEvenIfItAnswersBefore) {
  LUM_ASSERT_OK(ChildProcess child, shell_process("read -r line; echo early; cat > /dev/null"));
  const std::string large(3'000'000, 'x');  // more than the socket holds: it is given after the answer
  std::string answer;
  const auto enough = [&answer](std::string_view bytes) {
    answer += bytes;
    return true;
  };
  EXPECT_TRUE(child.ask({"one\n", large}, enough, 20s));
  EXPECT_EQ(answer, "early\n");
  LUM_ASSERT_OK(ChildProcess deaf, shell_process("read -r line; echo early; exec sleep 60"));
  EXPECT_FALSE(deaf.ask({"one\n", large}, enough, 200ms));
  EXPECT_TRUE(deaf.end(20s).timed_out);
}

TEST(ChildProcess, SaysOnlyWhatItSaidAboutTheLastQuestion) {
  LUM_ASSERT_OK(ChildProcess child, shell_process("read -r a; echo old >&2; echo 1; read -r b; exit 4"));
  EXPECT_EQ(answer_of(child, "one"), "1\n");
  EXPECT_EQ(answer_of(child, "two"), "");
  EXPECT_EQ(child.end(20s).description(), "ended with status 4");
}

}  // namespace
}  // namespace luminist
