#include "studio/action.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "params/param_text.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

/// The word of a command line for one JSON value, or nothing.
std::optional<std::string> word(const Json& value) {
  if (value.is_number()) return number_text(value.get<double>());
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_string()) return value.get<std::string>();
  return std::nullopt;
}

}  // namespace

Action::Action(std::unique_ptr<Json> json, std::string verb, std::string where)
    : json_(std::move(json)), verb_(std::move(verb)), where_(std::move(where)) {}
Action::Action(Action&&) noexcept = default;
Action& Action::operator=(Action&&) noexcept = default;
Action::~Action() = default;

Result<Action> Action::parse(std::string_view text, const std::string& where) {
  std::string why;
  auto json = std::make_unique<Json>();
  try {
    *json = Json::parse(text);
  } catch (const Json::parse_error& error) {
    return Error{ErrorKind::kBadContent, "not a JSON object", fmt::format("{}:{}", where, error.byte), "",
                 R"(a line looks like {"do": "undo"})"};
  }
  const bool object = json->is_object();
  if (!object || !json->contains("do") || !(*json)["do"].is_string()) {
    return Error{ErrorKind::kBadContent, "a line says what to do", where, "do", R"(write {"do": "undo"})"};
  }
  std::string verb = (*json)["do"].get<std::string>();
  return Action(std::move(json), std::move(verb), where);
}

Error Action::wrong(const std::string& what, const char* field) const {
  return {ErrorKind::kBadContent, what, where_, field, ""};
}

Result<void> Action::check_fields(std::span<const std::string> known) const {
  for (const auto& [key, value] : json_->items()) {
    if (key == "do" || std::find(known.begin(), known.end(), key) != known.end()) continue;
    Error error = wrong(fmt::format("\"{}\" has no such field", verb_), key.c_str());
    const std::string near = nearest_name(key, known);
    error.hint = !near.empty()   ? fmt::format("did you mean \"{}\"?", near)
                 : known.empty() ? "it has none"
                                 : fmt::format("it has: {}", fmt::join(known, ", "));
    return error;
  }
  return {};
}

bool Action::has(const char* field) const {
  return json_->contains(field);
}

Result<std::optional<std::string>> Action::text(const char* field) const {
  if (!has(field)) return std::optional<std::string>{};
  const Json& value = (*json_)[field];
  if (!value.is_string()) return wrong("a string is wanted", field);
  return std::optional(value.get<std::string>());
}

Result<std::string> Action::needed_text(const char* field) const {
  LUM_TRY(std::optional<std::string> value, text(field));
  if (!value) return wrong(fmt::format("\"{}\" needs this field", verb_), field);
  return *std::move(value);
}

Result<std::optional<double>> Action::number(const char* field) const {
  if (!has(field)) return std::optional<double>{};
  const Json& value = (*json_)[field];
  if (!value.is_number()) return wrong("a number is wanted", field);
  return std::optional(value.get<double>());
}

Result<std::vector<double>> Action::numbers(const char* field) const {
  std::vector<double> numbers;
  if (!has(field)) return numbers;
  const Json& list = (*json_)[field];
  for (const Json& value : list.is_array() ? list : Json::array({nullptr})) {
    if (!value.is_number()) return wrong("an array of numbers is wanted", field);
    numbers.push_back(value.get<double>());
  }
  return numbers;
}

Result<std::optional<bool>> Action::flag(const char* field) const {
  if (!has(field)) return std::optional<bool>{};
  const Json& value = (*json_)[field];
  if (!value.is_boolean()) return wrong("true or false is wanted", field);
  return std::optional(value.get<bool>());
}

Result<std::vector<std::string>> Action::texts(const char* field) const {
  std::vector<std::string> list;
  if (!has(field)) return list;
  const Json& value = (*json_)[field];
  for (const Json& each : value.is_array() ? value : Json::array({value})) {
    if (!each.is_string()) return wrong("a string or an array of strings is wanted", field);
    list.push_back(each.get<std::string>());
  }
  return list;
}

Result<std::optional<std::pair<int, int>>> Action::size(const char* field) const {
  if (!has(field)) return std::optional<std::pair<int, int>>{};
  const Json& value = (*json_)[field];
  if (!value.is_array() || value.size() != 2 || !value[0].is_number_integer() || !value[1].is_number_integer()) {
    return wrong("[width, height] is wanted", field);
  }
  return std::optional(std::pair(value[0].get<int>(), value[1].get<int>()));
}

Result<std::vector<double>> Action::numbers(const char* field, std::size_t count) const {
  const std::string wanted = fmt::format("{} numbers are wanted", count);
  if (!has(field) || !(*json_)[field].is_array() || (*json_)[field].size() != count) return wrong(wanted, field);
  std::vector<double> values;
  for (const Json& value : (*json_)[field]) {
    if (!value.is_number()) return wrong(wanted, field);
    values.push_back(value.get<double>());
  }
  return values;
}

std::optional<std::string> Action::object(const char* field) const {
  if (!has(field) || !(*json_)[field].is_object()) return std::nullopt;
  return (*json_)[field].dump();
}

std::string Action::rest(std::span<const char* const> but) const {
  Json rest = *json_;
  rest.erase("do");
  for (const char* field : but) rest.erase(field);
  return rest.dump();
}

Result<std::optional<std::uint32_t>> Action::whole(const char* field, std::uint32_t least) const {
  if (!has(field)) return std::optional<std::uint32_t>{};
  const Json& value = (*json_)[field];
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > 0xFFFFFFFFU || value.get<std::uint32_t>() < least) {
    return wrong(fmt::format("a whole number from {} is wanted", least), field);
  }
  return std::optional(value.get<std::uint32_t>());
}

Result<std::string> Action::value_text(const char* field) const {
  if (!has(field)) return wrong(fmt::format("\"{}\" needs this field", verb_), field);
  const Json& value = (*json_)[field];
  std::vector<std::string> words;
  for (const Json& each : value.is_array() ? value : Json::array({value})) {
    const auto one = word(each);
    if (!one) return wrong("a number, a string, true, false or an array of numbers is wanted", field);
    words.push_back(*one);
  }
  return fmt::format("{}", fmt::join(words, ","));
}

}  // namespace luminist
