#pragma once
// tests/bench/run_store.h -- the finished runs of a benchmark in a file, so that a stopped benchmark goes on.
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "bench/bench_run.h"

namespace luminist {

/// One run a line. A line that cannot be read, as the torn last one of a benchmark that was killed, is ignored.
class RunStore {
 public:
  /// Reads what is there; `fresh` forgets it. Makes the folder. errors kUnwritable.
  static Result<RunStore> open(const std::filesystem::path& file, bool fresh);

  /// The run of that key: the stored one, or else what make() gives, appended and on disk before it is handed back.
  /// errors make()'s; kUnwritable.
  Result<BenchRun> find_or_make(const BenchKey& key, const std::function<Result<BenchRun>()>& make);

  [[nodiscard]] std::size_t size() const { return runs_.size(); }

 private:
  Result<void> append(const BenchRun& run);

  std::filesystem::path file_;
  std::map<std::string, BenchRun> runs_;
  bool torn_ = false;  ///< the file does not end with a line break
};

}  // namespace luminist
