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

Error cannot_start(const std::string& path, int error_number) {
  return {ErrorKind::kChild, fmt::format("cannot start: {}", std::strerror(error_number)), path, "", ""};
}

/// The streams are our ends of the child's.
Result<pid_t> spawn(const std::vector<std::string>& arguments, std::array<Descriptor*, 3> streams) {
  std::array<int, 2> in{-1, -1}, out{-1, -1}, err{-1, -1};
  // A socket, not a pipe: writing to a child that is gone can then fail without raising SIGPIPE.
  const bool made = ::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, in.data()) == 0 &&
                    ::pipe2(out.data(), O_CLOEXEC) == 0 && ::pipe2(err.data(), O_CLOEXEC) == 0;
  const int pipe_error = errno;
  *streams[0] = Descriptor(in[0]), *streams[1] = Descriptor(out[0]), *streams[2] = Descriptor(err[0]);
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
  // SIGCHLD among them: a child that ignores it cannot see how its own children end.
  for (const int s : {SIGPIPE, SIGALRM, SIGTERM, SIGXFSZ, SIGCHLD}) ::sigaddset(&defaults, s);
  ::posix_spawnattr_setsigdefault(&attributes, &defaults);
  ::posix_spawnattr_setsigmask(&attributes, &unblocked);
  // A group of its own: Ctrl-C on the terminal is for us, who may still want the child to write what was found.
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);

  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));  // exec's type
  argv.push_back(nullptr);
  pid_t pid = -1;
  const int failed = ::posix_spawn(&pid, argv[0], &actions, &attributes, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (failed != 0) return cannot_start(arguments[0], failed);
  return pid;
}

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

/// Moves bytes between us and the child.
struct ChildProcess::Child {
  pid_t pid = -1;
  Descriptor in, out, err;  ///< our ends of its streams
  ProcessEnd end;
  bool interrupted = false;  ///< by an exception of whoever takes its output
  std::string buffer = std::string(kChunk, '\0');

  using Enough = std::function<bool(std::string_view)>;

  /// Until it is enough, both outputs are at their end, or the child has been silent for too long.
  bool exchange(std::vector<std::string_view> pieces, bool last, const Enough& enough,
                std::chrono::milliseconds longest_silence) {
    interrupted = true;
    bool done = false;
    Clock::time_point deadline = Clock::now() + longest_silence;
    while (out.open() || err.open()) {
      while (!pieces.empty() && pieces.front().empty()) pieces.erase(pieces.begin());
      if (pieces.empty() && done) break;  // not before: what is left would be the next one's input
      if (pieces.empty() && last) in.reset();
      std::array<pollfd, 3> fds{pollfd{out.get(), POLLIN, 0}, pollfd{err.get(), POLLIN, 0},
                                pollfd{pieces.empty() ? -1 : in.get(), POLLOUT, 0}};  // poll skips a -1
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
      const int ready = left <= 0 ? 0 : ::poll(fds.data(), fds.size(), static_cast<int>(std::min<long>(left, 1 << 30)));
      if (ready < 0 && errno == EINTR) continue;
      if (ready <= 0) {
        end.timed_out = true;
        done = false;
        break;
      }
      const std::string_view said = fds[0].revents != 0 ? take(out) : std::string_view();
      done = (!said.empty() && enough(said)) || done;
      bool progress = !said.empty();
      if (fds[1].revents != 0) keep_errors(take(err));
      if (fds[2].revents != 0) progress |= give(pieces);
      if (progress) deadline = Clock::now() + longest_silence;
    }
    interrupted = false;
    return done && pieces.empty();
  }

  /// What it said about what it was asked before is not about what it is asked now.
  void forget_errors() {
    pollfd waiting{err.get(), POLLIN, 0};
    while (err.open() && ::poll(&waiting, 1, 0) > 0) take(err);
    end.errors.clear();
  }

  std::string_view take(Descriptor& from) {
    const ssize_t got = ::read(from.get(), buffer.data(), buffer.size());
    if (got == 0 || (got < 0 && errno != EINTR && errno != EAGAIN)) from.reset();
    return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0))};
  }
  bool give(std::vector<std::string_view>& pieces) const {
    std::string_view& piece = pieces.front();
    const ssize_t sent = ::send(in.get(), piece.data(), std::min(piece.size(), kChunk), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) piece.remove_prefix(static_cast<std::size_t>(sent));
    if (sent < 0 && errno != EINTR && errno != EAGAIN) pieces.clear();  // it does not want more; it may still answer
    return sent > 0;
  }
  void keep_errors(std::string_view bytes) {
    end.errors += bytes;
    if (end.errors.size() > kKeptErrors) end.errors.erase(0, end.errors.size() - kKeptErrors);
  }
};

ChildProcess::ChildProcess(std::unique_ptr<Child> child) : child_(std::move(child)) {}
ChildProcess::ChildProcess(ChildProcess&& other) noexcept = default;

ChildProcess& ChildProcess::operator=(ChildProcess&& other) noexcept {
  std::swap(child_, other.child_);
  return *this;
}

ChildProcess::~ChildProcess() {
  constexpr std::chrono::seconds kToLeave{1};
  if (!child_) return;
  if (child_->interrupted) ::kill(child_->pid, SIGKILL);
  end(kToLeave);
}

Result<ChildProcess> ChildProcess::start(const std::vector<std::string>& arguments) {
  auto child = std::make_unique<Child>();
  LUM_TRY(child->pid, spawn(arguments, {&child->in, &child->out, &child->err}));
  return ChildProcess(std::move(child));
}

bool ChildProcess::waits() const {
  pollfd output{child_->out.get(), POLLIN, 0};
  return child_->in.open() && child_->out.open() && ::poll(&output, 1, 0) == 0;
}

bool ChildProcess::ask(std::vector<std::string_view> input, const std::function<bool(std::string_view)>& enough,
                       std::chrono::milliseconds longest_silence) {
  child_->forget_errors();
  return child_->exchange(std::move(input), false, enough, longest_silence);
}

ProcessEnd ChildProcess::end(std::chrono::milliseconds patience) {
  const std::unique_ptr<Child> child = std::exchange(child_, nullptr);
  for (Descriptor* stream : {&child->in, &child->out, &child->err}) stream->reset();
  wait_for(child->pid, child->end.timed_out ? Clock::now() : Clock::now() + patience, child->end);
  return std::move(child->end);
}

Result<ProcessEnd> run_process(const ProcessRequest& request) {
  LUM_TRY(ChildProcess process, ChildProcess::start(request.arguments));
  const auto take = [&](std::string_view bytes) {
    if (request.on_output) request.on_output(bytes);
    return false;
  };
  process.child_->exchange(request.input, true, take, request.longest_silence);
  return process.end(request.longest_silence);
}

}  // namespace luminist
