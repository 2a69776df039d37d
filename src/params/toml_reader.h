#pragma once
// params/toml_reader.h -- TOML as plain values with their places, and a reader that names the user's mistakes.
// The TOML library is seen by toml_reader.cpp alone.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

struct TomlEntry;

/// One value of a document, with its place in the file (both from 1).
struct TomlValue {
  enum class Kind { kTable, kArray, kString, kInteger, kFloat, kBool, kDate };
  Kind kind = Kind::kTable;
  int line = 1;
  int column = 1;
  double number = 0.0;             ///< of an integer (exact up to 2^53), a float or a bool (0 or 1)
  std::string text;                ///< of a string
  std::vector<TomlValue> items;    ///< of an array
  std::vector<TomlEntry> entries;  ///< of a table, in file order

  [[nodiscard]] bool is_number() const { return kind == Kind::kInteger || kind == Kind::kFloat; }
  [[nodiscard]] const TomlValue* find(std::string_view key) const;  ///< null if the table has no such key
};

struct TomlEntry {
  std::string key;
  int line = 1;
  int column = 1;
  TomlValue value;
};

/// The root table of a document. errors `kind` at path:line:col.
Result<TomlValue> parse_toml(std::string_view text, const std::string& path, ErrorKind kind);

/// "a string", "an array"... for messages.
std::string_view toml_kind_name(TomlValue::Kind kind);

/// Reads one table key by key. A getter with a fallback takes an absent key; one without demands it. The first mistake
/// is kept and returned by finish(), so that a caller reads everything first and asks once; what a getter returns after
/// a mistake is an empty value. A key that no getter asked for is a mistake too.
class TomlReader {
 public:
  /// The table must outlive the reader. Errors have this kind.
  TomlReader(const TomlValue& table, std::string path, ErrorKind kind)
      : table_(&table), path_(std::move(path)), kind_(kind) {}

  std::string string(std::string_view key);
  std::string string(std::string_view key, std::string_view fallback);
  double number(std::string_view key);  ///< finite
  double number(std::string_view key, double fallback);
  int integer(std::string_view key, int fallback);
  bool boolean(std::string_view key, bool fallback);
  std::vector<std::string> strings(std::string_view key);   ///< absent: none
  std::span<const TomlValue> tables(std::string_view key);  ///< [[key]], absent: none
  const TomlValue* table(std::string_view key);             ///< [key], null if absent
  const TomlValue* value(std::string_view key);             ///< anything, null if absent
  const TomlValue& required_value(std::string_view key);    ///< anything

  /// Records a mistake in the value of a key, or in the table if it has no such key.
  void fail(std::string_view key, std::string what, std::string hint = "");
  /// The same at a value that the caller found inside the key's.
  void fail_at(const TomlValue& place, std::string_view key, std::string what, std::string hint = "");

  /// The first mistake of the getters; keys that nobody asked for are ignored.
  [[nodiscard]] Result<void> status() const;
  /// A key that no getter asked for (with the nearest valid one), otherwise the first mistake of the getters.
  [[nodiscard]] Result<void> finish() const;

 private:
  const TomlValue* expect(std::string_view key, TomlValue::Kind kind, bool required);

  const TomlValue* table_;
  std::string path_;
  ErrorKind kind_;
  std::vector<std::string> asked_;
  std::optional<Error> error_;
};

}  // namespace luminist
