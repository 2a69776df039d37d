#pragma once
// project/project.h -- a shot on disk: NAME.lum/{log.jsonl, tiles/, lock, checkpoint.json}.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "project/command_log.h"
#include "project/commands.h"
#include "project/document.h"
#include "project/project_lock.h"
#include "project/tile_store.h"

namespace luminist {

/// A document, how it came about, and the place where both are kept.
///
/// Every change is a line of the log before it is in the document, so saving is flushing, autosave costs nothing, a
/// crash loses at most the line that was being written, and undo goes back to the first command of the first day.
/// Commands stay on disk; memory holds the document and one number a command. checkpoint.json only makes opening
/// quick: it may be deleted, and one that does not fit the log is ignored.
class Project {
 public:
  enum class Access { kRead, kWrite };

  /// A project in memory that starts as `document`; action is the JSON object that asked for it.
  static Project start(Document document, const std::string& action);
  /// errors kMissing; kBadContent for a damaged log; kProject if another process writes it, or if it was written by
  /// a newer version (both only with kWrite: reading is always possible); kUnwritable.
  static Result<Project> open(const std::filesystem::path& folder, Access access);

  [[nodiscard]] const Document& document() const { return document_; }
  [[nodiscard]] TileStore& tiles() { return tiles_; }
  [[nodiscard]] const TileStore& tiles() const { return tiles_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }  ///< empty: in memory
  [[nodiscard]] bool writable() const { return writable_; }
  /// Lines of the log that this version does not know; they are kept.
  [[nodiscard]] std::size_t unknown_records() const { return unknown_records_; }

  /// Records a command and applies it; what was undone can no longer be redone. After an error nothing has changed.
  /// errors kBadContent for edits that do not fit the document; kUnwritable; kProject if opened for reading.
  Result<void> execute(const Command& command);
  /// Takes back the last command in force, or puts the last undone one in force again. returns the edits that were
  /// applied. errors kNothingToDo; as execute().
  Result<std::vector<Edit>> undo();
  Result<std::vector<Edit>> redo();
  [[nodiscard]] std::size_t undo_steps() const { return in_force_; }
  [[nodiscard]] std::size_t redo_steps() const { return history_.size() - in_force_; }
  /// Another number after every command that is recorded; the same after undo and redo.
  [[nodiscard]] std::size_t newest() const { return history_.empty() ? 0 : history_.back() + 1; }
  /// A command, oldest first, in [0, undo_steps() + redo_steps()).
  [[nodiscard]] Result<Command> command(std::size_t index) const;

  /// Everything recorded so far is on the disk when this returns. errors kUnwritable; kProject if the log was changed
  /// by others; kUsage in memory.
  Result<void> save();
  /// Saves to NAME.lum and goes on there; another project of that name is replaced.
  /// errors kUsage for another extension; kUnwritable, also for a folder that is no project; kProject if it is open.
  Result<void> save_as(const std::filesystem::path& folder);
  /// Syncs what is older than two seconds; for a loop that idles. errors kUnwritable.
  Result<void> sync_if_due();

 private:
  Project() = default;
  Result<void> replay();
  Result<void> replay_record(std::size_t index);
  [[nodiscard]] std::size_t restore_checkpoint();
  Result<void> write_checkpoint();
  [[nodiscard]] std::string place(std::size_t record) const;
  Result<void> record_edits(const std::vector<Edit>& edits, const std::string& text);

  std::filesystem::path folder_;
  bool writable_ = true;
  std::optional<ProjectLock> lock_;
  CommandLog log_;
  TileStore tiles_;
  Document document_;
  std::vector<std::size_t> history_;  ///< log record of each command that is in force or can be redone
  std::size_t in_force_ = 0;
  std::size_t unknown_records_ = 0;
  std::size_t checkpointed_ = 0;  ///< records that the checkpoint covers
};

}  // namespace luminist
