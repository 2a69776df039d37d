#include "base/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "base/descriptor.h"

namespace luminist {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kChunk = 1U << 18U;
constexpr std::size_t kKeptErrors = 1U << 14U;

struct Child {
  pid_t pid = -1;
  Descriptor in, out, err;  ///< our ends
};

Error cannot_start(const std::string& path, int error_number) {
  return {ErrorKind::kChild, fmt::format("cannot start: {}", std::strerror(error_number)), path, "", ""};
}

Result<Child> start(const std::vector<std::string>& arguments) {
  std::array<int, 2> in{-1, -1}, out{-1, -1}, err{-1, -1};
  // A socket, not a pipe: writing to a child that is gone can then fail without raising SIGPIPE.
  const bool made = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in.data()) == 0 &&
                    ::pipe2(out.data(), O_CLOEXEC) == 0 && ::pipe2(err.data(), O_CLOEXEC) == 0;
  const int pipe_error = errno;
  Child child{-1, Descriptor(in[0]), Descriptor(out[0]), Descriptor(err[0])};
  const Descriptor child_in(in[1]), child_out(out[1]), child_err(err[1]);
  if (!made) return cannot_start(arguments[0], pipe_error);

  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&actions, child_in.get(), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, child_out.get(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, child_err.get(), STDERR_FILENO);
  ::posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);  // libraries open files without asking
  sigset_t defaults, unblocked;
  ::sigemptyset(&unblocked);
  ::sigemptyset(&defaults);
  for (const int s : {SIGPIPE, SIGALRM, SIGTERM, SIGXFSZ}) ::sigaddset(&defaults, s);
  ::posix_spawnattr_setsigdefault(&attributes, &defaults);
  ::posix_spawnattr_setsigmask(&attributes, &unblocked);
  // A group of its own: Ctrl-C on the terminal is for us, who may still want the child to write what was found.
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);

  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));  // exec's type
  argv.push_back(nullptr);
  const int failed = ::posix_spawn(&child.pid, argv[0], &actions, &attributes, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (failed != 0) return cannot_start(arguments[0], failed);
  return child;
}

/// Moves bytes between us and the child until both its outputs are at their end or it has been silent for too long.
class Exchange {
 public:
  Exchange(const ProcessRequest& request, Child& child, ProcessEnd& end)
      : request_(&request), child_(&child), end_(&end), pieces_(request.input), buffer_(kChunk, '\0') {}

  void run() {
    Clock::time_point deadline = Clock::now() + request_->longest_silence;
    while (child_->out.open() || child_->err.open()) {
      while (!pieces_.empty() && pieces_.front().empty()) pieces_.erase(pieces_.begin());
      if (pieces_.empty()) child_->in.reset();
      std::array<pollfd, 3> fds{pollfd{child_->out.get(), POLLIN, 0}, pollfd{child_->err.get(), POLLIN, 0},
                                pollfd{child_->in.get(), POLLOUT, 0}};  // poll skips a descriptor of -1
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
      const int ready = left <= 0 ? 0 : ::poll(fds.data(), fds.size(), static_cast<int>(std::min<long>(left, 1 << 30)));
      if (ready < 0 && errno == EINTR) continue;
      if (ready <= 0) {
        end_->timed_out = true;
        return;
      }
      bool progress = false;
      if (fds[0].revents != 0) progress |= take(child_->out, [this](std::string_view s) { on_output(s); });
      if (fds[1].revents != 0) take(child_->err, [this](std::string_view s) { on_errors(s); });
      if (fds[2].revents != 0) progress |= give();
      if (progress) deadline = Clock::now() + request_->longest_silence;
    }
  }

 private:
  template <class Sink>
  bool take(Descriptor& from, Sink sink) {
    const ssize_t got = ::read(from.get(), buffer_.data(), buffer_.size());
    if (got > 0) sink(std::string_view(buffer_.data(), static_cast<std::size_t>(got)));
    if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) from.reset();
    return got > 0;
  }
  bool give() {
    std::string_view& piece = pieces_.front();
    const ssize_t sent =
        ::send(child_->in.get(), piece.data(), std::min(piece.size(), kChunk), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) piece.remove_prefix(static_cast<std::size_t>(sent));
    if (sent < 0 && errno != EINTR && errno != EAGAIN) pieces_.clear();  // it does not want more; it may still answer
    return sent > 0;
  }
  void on_output(std::string_view bytes) const {
    if (request_->on_output) request_->on_output(bytes);
  }
  void on_errors(std::string_view bytes) const {
    end_->errors += bytes;
    if (end_->errors.size() > kKeptErrors) end_->errors.erase(0, end_->errors.size() - kKeptErrors);
  }

  const ProcessRequest* request_;
  Child* child_;
  ProcessEnd* end_;
  std::vector<std::string_view> pieces_;
  std::string buffer_;
};

/// Collects the child's end; one that closed its outputs and lingers is killed after the limit.
void wait_for(pid_t pid, Clock::time_point deadline, ProcessEnd& end) {
  using namespace std::chrono_literals;
  int status = 0;
  auto pause = 100us;
  for (;;) {
    const pid_t ended = ::waitpid(pid, &status, WNOHANG);
    if (ended == pid) break;
    if (ended < 0 && errno != EINTR) return;  // somebody else collected it
    if (ended == 0 && Clock::now() >= deadline) {
      end.timed_out = true;
      ::kill(pid, SIGKILL);
      while (::waitpid(pid, &status, 0) < 0 && errno == EINTR) {
      }
      break;
    }
    std::this_thread::sleep_for(pause);
    pause = std::min<decltype(pause)>(2 * pause, 20'000us);
  }
  if (WIFEXITED(status)) end.exit_status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
}

}  // namespace

std::string ProcessEnd::description() const {
  std::string text = fmt::format("ended with status {}", exit_status);
  if (signal != 0) text = fmt::format("was ended by signal {} ({})", signal, ::strsignal(signal));
  if (timed_out) text = "did not answer in time";
  const std::size_t last = errors.find_last_not_of(" \t\r\n");
  if (last == std::string::npos) return text;
  const std::size_t start = errors.find_last_of('\n', last);
  return text + ": " +
         errors.substr(start == std::string::npos ? 0 : start + 1,
                       last - (start == std::string::npos ? 0 : start + 1) + 1);
}

Result<ProcessEnd> run_process(const ProcessRequest& request) {
  LUM_TRY(Child child, start(request.arguments));
  ProcessEnd end;
  try {
    Exchange(request, child, end).run();
  } catch (...) {  // on_output is the caller's; the child must not outlive it
    ::kill(child.pid, SIGKILL);
    wait_for(child.pid, Clock::now(), end);
    throw;
  }
  child.in.reset();
  wait_for(child.pid, end.timed_out ? Clock::now() : Clock::now() + request.longest_silence, end);
  return end;
}

}  // namespace luminist
