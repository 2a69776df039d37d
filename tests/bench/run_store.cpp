#include "bench/run_store.h"

#include <fstream>
#include <sstream>

#include "base/files.h"

namespace luminist {

Result<RunStore> RunStore::open(const std::filesystem::path& file, bool fresh) {
  RunStore store;
  store.file_ = file;
  if (file.has_parent_path()) LUM_TRY_VOID(make_folder(file.parent_path()));
  if (fresh) LUM_TRY_VOID(write_file_atomic(file, ""));
  if (!std::filesystem::exists(file)) return store;
  LUM_TRY(const std::string text, read_file(file));
  store.torn_ = !text.empty() && text.back() != '\n';
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (auto run = parse_run(line)) store.runs_[run->key.text()] = *run;
  }
  return store;
}

Result<BenchRun> RunStore::find_or_make(const BenchKey& key, const std::function<Result<BenchRun>()>& make) {
  if (const auto known = runs_.find(key.text()); known != runs_.end()) return known->second;
  LUM_TRY(BenchRun run, make());
  run.key = key;
  LUM_TRY_VOID(append(run));
  return runs_[key.text()] = std::move(run);
}

Result<void> RunStore::append(const BenchRun& run) {
  std::ofstream out(file_, std::ios::app | std::ios::binary);
  if (torn_) out << '\n';
  torn_ = false;
  out << to_json_line(run) << '\n' << std::flush;
  if (!out) return Error{ErrorKind::kUnwritable, "a result could not be written", file_.string(), "", ""};
  return {};
}

}  // namespace luminist
