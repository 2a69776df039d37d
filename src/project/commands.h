#pragma once
// project/commands.h -- what is recorded: commands, their undoing and redoing, as JSON text.
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "project/document.h"

namespace luminist {

/// One gesture of the lighter: what it is called, what was asked for, and what it changed. Replaying applies the
/// edits; the action is there to be read and to be run again on another scene.
struct Command {
  std::string label;   ///< "Paint 3 strokes"
  std::string action;  ///< one JSON object, as in an action script
  std::vector<Edit> edits;
};

/// The version of the record format that this program writes, and the newest that it may write to.
inline constexpr int kProjectFormat = 1;

/// One line of a log.
struct Record {
  enum class Kind { kStart, kCommand, kUndo, kRedo, kUnknown };
  Kind kind = Kind::kUnknown;
  int format = 0;         ///< of a start
  Document document;      ///< of a start
  Command command;        ///< action of a start too
  std::size_t count = 0;  ///< of undo and redo: how many commands are in force afterwards
};

std::string start_record(const Document& document, const std::string& action);
std::string command_record(const Command& command);
std::string undo_record(std::size_t count);
std::string redo_record(std::size_t count);

/// A record of a kind that this version does not know is kUnknown, not an error.
/// errors kBadContent at `where`, naming the field.
Result<Record> parse_record(std::string_view text, const std::string& where);

}  // namespace luminist
