#include "project/project.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/files.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kRecordsPerCheckpoint = 256;

fs::path log_file(const fs::path& folder) {
  return folder / "log.jsonl";
}
fs::path lock_file(const fs::path& folder) {
  return folder / "lock";
}
fs::path checkpoint_file(const fs::path& folder) {
  return folder / "checkpoint.json";
}

/// Whether a folder may become a project: it is one, or it holds nothing but what a project holds.
Result<void> check_place(const fs::path& folder) {
  if (folder.extension() != ".lum") {
    return Error{ErrorKind::kUsage, "a project is a folder whose name ends in .lum", folder.string(), "project",
                 fmt::format("write {}.lum", folder.string())};
  }
  std::error_code error;
  if (fs::exists(log_file(folder), error) || !fs::exists(folder, error)) return {};
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name == "lock" || name == "tiles" || name.starts_with(".lum-")) continue;
    return Error{ErrorKind::kUnwritable, "the folder is there and is not a project", folder.string(), "project",
                 "choose another name"};
  }
  if (!error) return {};
  return Error{ErrorKind::kUnwritable, "not a folder: " + error.message(), folder.string(), "project",
               "choose another name"};
}

/// Temporary files of a writer that died. Whoever calls this holds the lock, so nobody else is writing.
void remove_leftovers(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> leftovers;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().filename().string().starts_with(".lum-")) leftovers.push_back(entry->path());
  }
  for (const fs::path& path : leftovers) fs::remove(path, error);
}

}  // namespace

Project Project::start(Document document, const std::string& action) {
  Project project;
  const auto appended = project.log_.append(start_record(document, action));
  LUM_CHECK(appended, "a log in memory accepts everything");
  project.document_ = std::move(document);
  return project;
}

Result<Project> Project::open(const fs::path& folder, Access access) {
  Project project;
  project.folder_ = folder;
  project.writable_ = access == Access::kWrite;
  project.tiles_ = TileStore(folder / "tiles");
  LUM_TRY(project.log_, CommandLog::open(log_file(folder), CommandLog::Access::kRead));
  LUM_TRY_VOID(project.replay());
  if (access == Access::kRead) return project;
  const std::string seal = project.log_.seal(project.log_.size());
  LUM_TRY(project.lock_, ProjectLock::take(lock_file(folder)));
  remove_leftovers(folder);
  LUM_TRY(project.log_, CommandLog::open(log_file(folder), CommandLog::Access::kWrite));
  if (project.log_.seal(project.log_.size()) == seal) return project;
  return Error{ErrorKind::kProject, "the project was changed while it was being opened", folder.string(), "",
               "open it again"};
}

std::string Project::place(std::size_t record) const {
  return fmt::format("{}:{}", folder_.empty() ? "log" : log_file(folder_).string(), record + 1);
}

Result<void> Project::replay() {
  if (log_.size() == 0) {
    return Error{ErrorKind::kBadContent, "the log is empty", log_file(folder_).string(), "", "restore it from a copy"};
  }
  LUM_TRY(const std::string text, log_.read(0));
  LUM_TRY(Record start, parse_record(text, place(0)));
  if (start.kind != Record::Kind::kStart) {
    return Error{ErrorKind::kBadContent, "a log begins with a start", place(0), "start", "restore it from a copy"};
  }
  if (start.format > kProjectFormat && writable_) {
    return Error{ErrorKind::kProject,
                 fmt::format("the project has format {}, this version writes {}", start.format, kProjectFormat),
                 place(0), "start.format", "open it for reading, or with a newer version"};
  }
  document_ = std::move(start.document);
  for (std::size_t record = restore_checkpoint(); record < log_.size(); ++record) {
    LUM_TRY_VOID(replay_record(record));
  }
  return {};
}

Result<void> Project::replay_record(std::size_t index) {
  LUM_TRY(const std::string text, log_.read(index));
  LUM_TRY(Record record, parse_record(text, place(index)));
  std::vector<Edit> edits;
  if (record.kind == Record::Kind::kCommand) {
    history_.resize(in_force_++);
    history_.push_back(index);
    edits = std::move(record.command.edits);
  } else if (record.kind == Record::Kind::kUndo || record.kind == Record::Kind::kRedo) {
    const bool undo = record.kind == Record::Kind::kUndo;
    const bool possible = undo ? in_force_ > 0 && record.count + 1 == in_force_
                               : in_force_ < history_.size() && record.count == in_force_ + 1;
    if (!possible) {
      return Error{ErrorKind::kBadContent, "there is no command to undo or redo at this line", place(index),
                   undo ? "undo" : "redo", "restore the log from a copy"};
    }
    LUM_TRY(Command changed, command(undo ? in_force_ - 1 : in_force_));
    edits = undo ? reversed(changed.edits) : std::move(changed.edits);
    in_force_ = record.count;
  } else {
    ++unknown_records_;
    return {};
  }
  if (auto applied = document_.apply(edits); !applied) {
    Error error = std::move(applied).error();
    error.where = place(index);
    return error;
  }
  return {};
}

Result<Command> Project::command(std::size_t index) const {
  LUM_CHECK(index < history_.size(), "the caller counts the steps");
  LUM_TRY(const std::string text, log_.read(history_[index]));
  LUM_TRY(Record record, parse_record(text, place(history_[index])));
  return std::move(record.command);
}

Result<void> Project::record_edits(const std::vector<Edit>& edits, const std::string& text) {
  if (!writable_) {
    return Error{ErrorKind::kProject, "the project is open for reading only", folder_.string(), "",
                 "save it under another name"};
  }
  // What a line on the disk refers to is on the disk before it.
  if (log_.sync_due()) LUM_TRY_VOID(tiles_.sync());
  LUM_TRY_VOID(document_.apply(edits));
  auto appended = log_.append(text);
  if (appended) return {};
  const auto restored = document_.apply(reversed(edits));
  LUM_CHECK(restored, "what was just applied can be taken back");
  return appended;
}

Result<void> Project::execute(const Command& command) {
  const std::size_t record = log_.size();
  LUM_TRY_VOID(record_edits(command.edits, command_record(command)));
  history_.resize(in_force_++);
  history_.push_back(record);
  return {};
}

Result<std::vector<Edit>> Project::undo() {
  if (in_force_ == 0) return Error{ErrorKind::kNothingToDo, "there is nothing to undo", "", "", ""};
  LUM_TRY(const Command last, command(in_force_ - 1));
  std::vector<Edit> edits = reversed(last.edits);
  LUM_TRY_VOID(record_edits(edits, undo_record(in_force_ - 1)));
  --in_force_;
  return edits;
}

Result<std::vector<Edit>> Project::redo() {
  if (redo_steps() == 0) return Error{ErrorKind::kNothingToDo, "there is nothing to redo", "", "", ""};
  LUM_TRY(Command next, command(in_force_));
  LUM_TRY_VOID(record_edits(next.edits, redo_record(in_force_ + 1)));
  ++in_force_;
  return std::move(next.edits);
}

Result<void> Project::save() {
  if (folder_.empty()) {
    return Error{ErrorKind::kUsage, "the project has no name yet", "", "project", "save it as NAME.lum"};
  }
  if (!writable_) {
    return Error{ErrorKind::kProject, "the project is open for reading only", folder_.string(), "",
                 "save it under another name"};
  }
  LUM_TRY_VOID(tiles_.sync());  // first what is referred to, then what refers
  LUM_TRY_VOID(log_.sync());
  if (log_.size() >= checkpointed_ + kRecordsPerCheckpoint) LUM_TRY_VOID(write_checkpoint());
  return {};
}

Result<void> Project::sync_if_due() {
  if (!log_.unsynced() || !log_.sync_due()) return {};
  LUM_TRY_VOID(tiles_.sync());
  return log_.sync();
}

Result<void> Project::save_as(const fs::path& folder) {
  std::error_code error;
  if (writable_ && !folder_.empty() && fs::equivalent(folder, folder_, error)) return save();
  LUM_TRY_VOID(check_place(folder));
  LUM_TRY_VOID(make_folder(folder));
  LUM_TRY(ProjectLock lock, ProjectLock::take(lock_file(folder)));
  LUM_TRY_VOID(tiles_.copy_to(folder / "tiles"));
  fs::remove(checkpoint_file(folder), error);
  LUM_TRY_VOID(log_.write_to(log_file(folder)));
  LUM_TRY(CommandLog log, CommandLog::open(log_file(folder), CommandLog::Access::kWrite));
  log_ = std::move(log);
  lock_ = std::move(lock);
  tiles_ = TileStore(folder / "tiles");
  folder_ = folder;
  writable_ = true;
  checkpointed_ = 0;
  return {};
}

Result<void> Project::write_checkpoint() {
  Json document = Json::object();
  for (const auto& [path, value] : document_.entries()) document[path] = value;
  const Json checkpoint = {{"records", log_.size()}, {"seal", log_.seal(log_.size())}, {"in_force", in_force_},
                           {"history", history_},    {"unknown", unknown_records_},    {"document", document}};
  LUM_TRY_VOID(write_file_atomic(checkpoint_file(folder_), checkpoint.dump()));
  checkpointed_ = log_.size();
  return {};
}

/// returns the first record that is still to be replayed.
std::size_t Project::restore_checkpoint() {
  const auto bytes = read_file(checkpoint_file(folder_));
  if (!bytes) return 1;
  try {
    const Json checkpoint = Json::parse(*bytes);
    const auto records = checkpoint.at("records").get<std::size_t>();
    const auto history = checkpoint.at("history").get<std::vector<std::size_t>>();
    const auto in_force = checkpoint.at("in_force").get<std::size_t>();
    if (records == 0 || records > log_.size() || checkpoint.at("seal") != log_.seal(records)) return 1;
    for (const std::size_t record : history) {
      if (record >= records) return 1;
    }
    if (in_force > history.size()) return 1;
    Document document;
    for (const auto& [path, value] : checkpoint.at("document").items()) document.set(path, value.get<std::string>());
    unknown_records_ = checkpoint.at("unknown").get<std::size_t>();
    document_ = std::move(document);
    history_ = history;
    in_force_ = in_force;
    checkpointed_ = records;
    return records;
  } catch (const Json::exception&) {
    return 1;  // a cache that cannot be read is no cache
  }
}

}  // namespace luminist
