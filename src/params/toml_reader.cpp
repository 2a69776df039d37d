#include "params/toml_reader.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {
namespace {

using Kind = TomlValue::Kind;

template <class Place>
void set_place(Place& place, const toml::source_region& source) {
  place.line = std::max(1, static_cast<int>(source.begin.line));
  place.column = std::max(1, static_cast<int>(source.begin.column));
}

// The library limits the nesting of values, so the recursion is bounded.
TomlValue converted(const toml::node& node) {
  TomlValue value;
  set_place(value, node.source());
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, child] : *table) {
      TomlEntry entry{std::string(key.str()), 1, 1, converted(child)};
      set_place(entry, key.source());
      value.entries.push_back(std::move(entry));
    }
    // The library sorts by key; messages and readers go through a file from top to bottom.
    std::stable_sort(value.entries.begin(), value.entries.end(), [](const TomlEntry& a, const TomlEntry& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
  } else if (const toml::array* array = node.as_array()) {
    value.kind = Kind::kArray;
    for (const toml::node& child : *array) value.items.push_back(converted(child));
  } else if (const auto* string = node.as_string()) {
    value.kind = Kind::kString, value.text = string->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = Kind::kInteger, value.number = static_cast<double>(integer->get());
  } else if (const auto* floating = node.as_floating_point()) {
    value.kind = Kind::kFloat, value.number = floating->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = Kind::kBool, value.number = boolean->get() ? 1.0 : 0.0;
  } else {
    value.kind = Kind::kDate;
  }
  return value;
}

std::string place_name(const std::string& path, int line, int column) {
  return fmt::format("{}:{}:{}", path, line, column);
}

}  // namespace

const TomlValue* TomlValue::find(std::string_view key) const {
  for (const TomlEntry& entry : entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

Result<TomlValue> parse_toml(std::string_view text, const std::string& path, ErrorKind kind) {
  try {
    return converted(toml::parse(text, path));
  } catch (const toml::parse_error& error) {
    const toml::source_position place = error.source().begin;
    return Error{kind, std::string(error.description()),
                 place_name(path, static_cast<int>(place.line), static_cast<int>(place.column)), "",
                 "write it as TOML 1.0"};
  } catch (const std::bad_alloc&) {
    throw;  // not the file's fault: the command line reports it as its own kind
  } catch (const std::exception& error) {
    return Error{kind, error.what(), path, "", ""};
  }
}

std::string_view toml_kind_name(Kind kind) {
  switch (kind) {
    case Kind::kTable:
      return "a table";
    case Kind::kArray:
      return "an array";
    case Kind::kString:
      return "a string";
    case Kind::kInteger:
      return "an integer";
    case Kind::kFloat:
      return "a number";
    case Kind::kBool:
      return "true or false";
    case Kind::kDate:
      return "a date";
  }
  return "";
}

const TomlValue* TomlReader::value(std::string_view key) {
  asked_.emplace_back(key);
  return table_->find(key);
}

const TomlValue& TomlReader::required_value(std::string_view key) {
  static const TomlValue none;
  const TomlValue* found = value(key);
  if (found == nullptr) {
    fail(key, fmt::format("the key \"{}\" is missing", key));
    return none;
  }
  return *found;
}

const TomlValue* TomlReader::expect(std::string_view key, Kind kind, bool required) {
  const TomlValue* found = value(key);
  if (found == nullptr) {
    if (required) {
      fail(key, fmt::format("the key \"{}\" is missing", key), fmt::format("give {}", toml_kind_name(kind)));
    }
    return nullptr;
  }
  if (found->kind == kind || (kind == Kind::kFloat && found->kind == Kind::kInteger)) return found;
  fail(key, fmt::format("{} is wanted here, not {}", toml_kind_name(kind), toml_kind_name(found->kind)));
  return nullptr;
}

std::string TomlReader::string(std::string_view key) {
  const TomlValue* found = expect(key, Kind::kString, true);
  return found != nullptr ? found->text : "";
}

std::string TomlReader::string(std::string_view key, std::string_view fallback) {
  const TomlValue* found = expect(key, Kind::kString, false);
  return std::string(found != nullptr ? found->text : fallback);
}

double TomlReader::number(std::string_view key) {
  const TomlValue* found = expect(key, Kind::kFloat, true);
  if (found == nullptr) return 0.0;
  if (!std::isfinite(found->number)) fail(key, "a finite number is wanted here");
  return found->number;
}

double TomlReader::number(std::string_view key, double fallback) {
  if (table_->find(key) != nullptr) return number(key);
  asked_.emplace_back(key);
  return fallback;
}

int TomlReader::integer(std::string_view key, int fallback) {
  const TomlValue* found = expect(key, Kind::kInteger, false);
  if (found == nullptr) return fallback;
  if (std::abs(found->number) > std::numeric_limits<int>::max()) {
    fail(key, "the integer is too large");
    return fallback;
  }
  return static_cast<int>(found->number);
}

bool TomlReader::boolean(std::string_view key, bool fallback) {
  const TomlValue* found = expect(key, Kind::kBool, false);
  return found != nullptr ? found->number != 0.0 : fallback;
}

std::vector<std::string> TomlReader::strings(std::string_view key) {
  std::vector<std::string> list;
  const TomlValue* found = expect(key, Kind::kArray, false);
  if (found == nullptr) return list;
  for (const TomlValue& item : found->items) {
    if (item.kind != Kind::kString) {
      fail_at(item, key, fmt::format("a string is wanted here, not {}", toml_kind_name(item.kind)));
    }
    list.push_back(item.text);
  }
  return list;
}

std::span<const TomlValue> TomlReader::tables(std::string_view key) {
  const TomlValue* found = expect(key, Kind::kArray, false);
  if (found == nullptr) return {};
  for (const TomlValue& item : found->items) {
    if (item.kind == Kind::kTable) continue;
    fail_at(item, key, fmt::format("a table is wanted here, not {}", toml_kind_name(item.kind)),
            fmt::format("write [[{}]]", key));
    return {};
  }
  return found->items;
}

const TomlValue* TomlReader::table(std::string_view key) {
  return expect(key, Kind::kTable, false);
}

void TomlReader::fail(std::string_view key, std::string what, std::string hint) {
  const TomlValue* found = table_->find(key);
  fail_at(found != nullptr ? *found : *table_, key, std::move(what), std::move(hint));
}

void TomlReader::fail_at(const TomlValue& place, std::string_view key, std::string what, std::string hint) {
  if (error_) return;
  error_ =
      Error{kind_, std::move(what), place_name(path_, place.line, place.column), std::string(key), std::move(hint)};
}

Result<void> TomlReader::status() const {
  if (error_) return *error_;
  return {};
}

Result<void> TomlReader::finish() const {
  for (const TomlEntry& entry : table_->entries) {
    if (std::find(asked_.begin(), asked_.end(), entry.key) != asked_.end()) continue;
    const std::string nearest = nearest_name(entry.key, asked_);
    const std::string hint = nearest.empty() ? fmt::format("valid keys are {}", fmt::join(asked_, ", "))
                                             : fmt::format("did you mean \"{}\"?", nearest);
    return Error{kind_, fmt::format("unknown key \"{}\"", entry.key), place_name(path_, entry.line, entry.column),
                 entry.key, hint};
  }
  return status();
}

}  // namespace luminist
