#include "project/project_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luminist {
namespace {

struct Holder {
  std::string host;
  long pid = 0;
  long long start = 0;  ///< clock ticks after boot: the same number may be another process, the same pair is not
};

std::string host_name() {
  std::array<char, HOST_NAME_MAX + 1> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// What /proc/PID/stat says of a process.
struct ProcessFacts {
  char state = 0;        ///< field 3; 0: there is no such process
  long long start = -1;  ///< field 22
  [[nodiscard]] bool runs() const { return state != 0 && state != 'Z' && state != 'X'; }
};

/// Field 2 is in parentheses and may hold anything.
ProcessFacts facts_of(long pid) {
  std::ifstream file(fmt::format("/proc/{}/stat", pid));
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  ProcessFacts facts;
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return facts;
  std::istringstream fields(text.substr(name_end + 1));
  fields >> facts.state;
  std::string skipped;
  for (int field = 4; field < 22; ++field) fields >> skipped;
  fields >> facts.start;
  return facts;
}

Holder read_holder(int fd) {
  std::array<char, 1024> text{};
  const ssize_t size = ::pread(fd, text.data(), text.size(), 0);
  const auto json = nlohmann::json::parse(text.data(), text.data() + std::max<ssize_t>(size, 0), nullptr, false);
  Holder holder;
  if (!json.is_object()) return holder;
  const auto number = [&](const char* key) {
    return json.contains(key) && json[key].is_number_integer() ? json[key].get<long long>() : 0LL;
  };
  if (json.contains("host") && json["host"].is_string()) holder.host = json["host"].get<std::string>();
  holder.pid = static_cast<long>(number("pid"));
  holder.start = number("start");
  return holder;
}

Error held(const std::filesystem::path& file, const Holder& holder, const std::string& hint) {
  return {ErrorKind::kProject, fmt::format("the project is open in process {} on {}", holder.pid, holder.host),
          file.parent_path().string(), "", hint};
}

Result<void> write_holder(int fd, const std::filesystem::path& file) {
  const nlohmann::json json = {{"host", host_name()}, {"pid", ::getpid()}, {"start", facts_of(::getpid()).start}};
  const std::string text = json.dump() + "\n";
  if (::ftruncate(fd, 0) == 0 && ::pwrite(fd, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size())) {
    return {};
  }
  return Error{ErrorKind::kUnwritable, fmt::format("cannot write the lock: {}", std::strerror(errno)), file.string(),
               "", "free some space or save to another place"};
}

}  // namespace

bool process_runs(long pid) {
  return facts_of(pid).runs();
}

Result<ProjectLock> ProjectLock::take(const std::filesystem::path& file) {
  ProjectLock lock(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644));
  if (lock.fd_ < 0) {
    return Error{ErrorKind::kUnwritable, fmt::format("cannot create the lock: {}", std::strerror(errno)), file.string(),
                 "", "open it for reading, or copy the project"};
  }
  if (::flock(lock.fd_, LOCK_EX | LOCK_NB) != 0) {
    const Holder holder = read_holder(lock.fd_);
    ::close(std::exchange(lock.fd_, -1));
    return held(file, holder, "close it there, or open it for reading");
  }
  const Holder holder = read_holder(lock.fd_);
  const bool elsewhere = !holder.host.empty() && holder.host != host_name();
  // The advisory lock was free, so a holder on this machine is dead, unless the file system ignores such locks.
  const ProcessFacts facts = facts_of(holder.pid);
  const bool alive =
      !elsewhere && holder.pid > 0 && holder.pid != ::getpid() && facts.runs() && facts.start == holder.start;
  if (elsewhere || alive) {
    ::close(std::exchange(lock.fd_, -1));
    return held(file, holder, "if that process has ended, delete the file \"lock\" in the project");
  }
  LUM_TRY_VOID(write_holder(lock.fd_, file));
  return lock;
}

ProjectLock::ProjectLock(ProjectLock&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}

ProjectLock& ProjectLock::operator=(ProjectLock&& other) noexcept {
  std::swap(fd_, other.fd_);
  return *this;
}

ProjectLock::~ProjectLock() {
  if (fd_ < 0) return;
  // Emptied, not deleted: who opened the old file meanwhile must not lock a name that is gone.
  if (::ftruncate(fd_, 0) != 0) errno = 0;  // the next taker finds a dead process
  ::close(fd_);
}

}  // namespace luminist
