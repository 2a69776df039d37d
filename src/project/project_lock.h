#pragma once
// project/project_lock.h -- one writer at a time.
#include <filesystem>

#include "base/result.h"

namespace luminist {

/// Whether a process of this machine is at work: a zombie, which ended and waits for its parent to hear of it, is not.
bool process_runs(long pid);

/// Holds NAME.lum/lock: the system's advisory lock decides between processes of one machine, the text in the file
/// (host, process, its start time) tells who, and speaks for machines that share the folder without sharing locks.
class ProjectLock {
 public:
  /// Takes the lock; what a dead process left behind is taken over.
  /// errors kProject, naming the holder; kUnwritable.
  static Result<ProjectLock> take(const std::filesystem::path& file);

  ProjectLock(ProjectLock&& other) noexcept;
  ProjectLock& operator=(ProjectLock&& other) noexcept;
  ~ProjectLock();

 private:
  explicit ProjectLock(int fd) : fd_(fd) {}
  int fd_ = -1;
};

}  // namespace luminist
