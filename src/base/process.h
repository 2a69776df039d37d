#pragma once
// base/process.h -- running a child process: bytes in, bytes out, a limit on its patience.
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

struct ProcessRequest {
  std::vector<std::string> arguments;                 ///< [0] is the path of the executable
  std::vector<std::string_view> input;                ///< its standard input, one piece after another, then the end
  std::function<void(std::string_view)> on_output;    ///< takes its standard output as it comes
  std::chrono::milliseconds longest_silence{60'000};  ///< without output or progress on the input: then it is killed
};

struct ProcessEnd {
  int exit_status = 0;     ///< if no signal ended it
  int signal = 0;          ///< that ended it, or 0
  bool timed_out = false;  ///< it was silent for too long and was killed
  std::string errors;      ///< the last 16 KiB of its standard error

  [[nodiscard]] bool ok() const { return exit_status == 0 && signal == 0 && !timed_out; }
  /// "ended with status 3", "was ended by signal 11 (Segmentation fault)", "did not answer", with its last error line.
  [[nodiscard]] std::string description() const;
};

/// A child that is asked again and again. It ends with this: its input does, and if it lingers it is killed.
/// thread one at a time.
class ChildProcess {
 public:
  /// It inherits the environment and no open file. errors kChild if it cannot be started.
  static Result<ChildProcess> start(const std::vector<std::string>& arguments);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) noexcept;
  ~ChildProcess();

  /// Whether it is there, as far as can be told, and has said nothing that nobody asked for.
  [[nodiscard]] bool waits() const;
  /// Gives it all of the input and takes its output until `enough` says so of the last of it, or its outputs end, or it
  /// is silent for too long. returns whether it was enough; if not, what is left to do is to end it.
  bool ask(std::vector<std::string_view> input, const std::function<bool(std::string_view)>& enough,
           std::chrono::milliseconds longest_silence);
  /// The end of its input; waits for its own. One that was silent for too long is killed at once.
  ProcessEnd end(std::chrono::milliseconds patience);

 private:
  friend Result<ProcessEnd> run_process(const ProcessRequest& request);
  struct Child;
  explicit ChildProcess(std::unique_ptr<Child> child);
  std::unique_ptr<Child> child_;
};

/// Runs a child and waits for its end. A child that dies, or does not read its input, does not disturb this process
/// (no SIGPIPE). It inherits the environment and no open file.
/// errors kChild if it cannot be started. thread any.
Result<ProcessEnd> run_process(const ProcessRequest& request);

}  // namespace luminist
