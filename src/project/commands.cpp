#include "project/commands.h"

#include <nlohmann/json.hpp>

namespace luminist {
namespace {

using Json = nlohmann::json;

Error wrong(const std::string& where, const char* field, const char* what) {
  return {ErrorKind::kBadContent, what, where, field, "the log was not written by this program"};
}

Json to_json(const Edit& edit) {
  Json json = {{"path", edit.path}};
  if (!edit.before.empty()) json["before"] = Json::parse(edit.before);
  if (!edit.after.empty()) json["after"] = Json::parse(edit.after);
  return json;
}

std::string text_of(const Json& object, const char* key) {
  const auto value = object.find(key);
  return value == object.end() ? "" : value->dump();
}

Result<void> read_edits(const Json& json, const std::string& where, Command& command) {
  const auto edits = json.find("edits");
  if (edits == json.end() || !edits->is_array()) return wrong(where, "edits", "an array is wanted");
  for (const Json& edit : *edits) {
    if (!edit.is_object() || !edit.contains("path") || !edit["path"].is_string()) {
      return wrong(where, "edits", "every edit has a path");
    }
    command.edits.push_back({edit["path"].get<std::string>(), text_of(edit, "before"), text_of(edit, "after")});
  }
  return {};
}

Result<void> read_start(const Json& json, const std::string& where, Record& record) {
  const Json& start = json["start"];
  if (!start.is_object() || !start.contains("format") || !start["format"].is_number_integer()) {
    return wrong(where, "start.format", "a whole number is wanted");
  }
  record.kind = Record::Kind::kStart;
  record.format = start["format"].get<int>();
  const auto document = json.find("document");
  if (document == json.end() || !document->is_object()) return wrong(where, "document", "an object is wanted");
  for (const auto& [path, value] : document->items()) record.document.set(path, value.dump());
  return {};
}

}  // namespace

std::string start_record(const Document& document, const std::string& action) {
  Json values = Json::object();
  for (const auto& [path, value] : document.entries()) values[path] = Json::parse(value);
  return Json{{"start", {{"format", kProjectFormat}}}, {"action", Json::parse(action)}, {"document", std::move(values)}}
      .dump();
}

std::string command_record(const Command& command) {
  Json edits = Json::array();
  for (const Edit& edit : command.edits) edits.push_back(to_json(edit));
  return Json{{"command", command.label}, {"action", Json::parse(command.action)}, {"edits", std::move(edits)}}.dump();
}

std::string undo_record(std::size_t count) {
  return Json{{"undo", count}}.dump();
}
std::string redo_record(std::size_t count) {
  return Json{{"redo", count}}.dump();
}

Result<Record> parse_record(std::string_view text, const std::string& where) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return wrong(where, "record", "a JSON object is wanted");
  Record record;
  record.command.action = text_of(json, "action");
  if (json.contains("start")) {
    LUM_TRY_VOID(read_start(json, where, record));
  } else if (json.contains("command")) {
    if (!json["command"].is_string()) return wrong(where, "command", "a label is wanted");
    record.kind = Record::Kind::kCommand;
    record.command.label = json["command"].get<std::string>();
    LUM_TRY_VOID(read_edits(json, where, record.command));
  } else if (json.contains("undo") || json.contains("redo")) {
    const bool undo = json.contains("undo");
    const Json& count = json[undo ? "undo" : "redo"];
    if (!count.is_number_unsigned()) return wrong(where, undo ? "undo" : "redo", "a number of commands is wanted");
    record.kind = undo ? Record::Kind::kUndo : Record::Kind::kRedo;
    record.count = count.get<std::size_t>();
  }
  return record;
}

}  // namespace luminist
