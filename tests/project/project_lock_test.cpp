#include "project/project_lock.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "support/fixtures.h"

namespace luminist {
namespace {

/// A child that holds a lock until it is told to end, and is a zombie from then on until it is waited for.
class LockHolder {
 public:
  explicit LockHolder(const std::string& file) {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    pid_ = ::fork();
    if (pid_ == 0) {
      auto lock = ProjectLock::take(file);
      const char told = lock ? 'y' : 'n';
      if (::write(ready[1], &told, 1) != 1) ::_exit(1);
      ::pause();
    }
    char told = 0;
    EXPECT_EQ(::read(ready[0], &told, 1), 1);
    EXPECT_EQ(told, 'y');
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~LockHolder() { ::waitpid(pid_, nullptr, 0); }
  [[nodiscard]] pid_t pid() const { return pid_; }
  /// It ends, but nobody has heard of it yet.
  void die() const {
    ::kill(pid_, SIGKILL);
    siginfo_t info;
    EXPECT_EQ(::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT), 0);
  }

 private:
  pid_t pid_ = 0;
};

TEST(ProjectLock, AProcessAtWorkKeepsOthersOut) {
  TemporaryFolder folder;
  const LockHolder holder(folder.file("lock"));
  EXPECT_TRUE(process_runs(holder.pid()));
  const auto second = ProjectLock::take(folder.file("lock"));
  EXPECT_EQ(error_of(second).kind, ErrorKind::kProject);
  holder.die();
}

TEST(ProjectLock, AZombieHoldsNothing) {
  TemporaryFolder folder;
  const LockHolder holder(folder.file("lock"));
  holder.die();
  EXPECT_EQ(::kill(holder.pid(), 0), 0) << "the system still knows it";
  EXPECT_FALSE(process_runs(holder.pid()));
  LUM_ASSERT_OK(const ProjectLock lock, ProjectLock::take(folder.file("lock")));
}

TEST(ProjectLock, AProcessThatNeverWasDoesNotRun) {
  EXPECT_FALSE(process_runs(0));
  EXPECT_TRUE(process_runs(::getpid()));
}

}  // namespace
}  // namespace luminist
