#pragma once
// studio/action.h -- one line of an action script: {"do": "paint", "strokes": "1_key.json"}.
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

/// A verb and its fields, with errors at the script's line. Getters return nothing for a field that is not there, and
/// kBadContent, naming the field, for one of another kind.
class Action {
 public:
  /// errors kBadContent at `where` for what is not a JSON object with a "do".
  static Result<Action> parse(std::string_view text, const std::string& where);
  Action(Action&&) noexcept;
  Action& operator=(Action&&) noexcept;
  ~Action();

  [[nodiscard]] const std::string& verb() const { return verb_; }
  [[nodiscard]] const std::string& where() const { return where_; }
  /// errors kBadContent for a field that is not among the known ones, with the nearest.
  [[nodiscard]] Result<void> check_fields(std::span<const std::string> known) const;

  [[nodiscard]] bool has(const char* field) const;
  [[nodiscard]] Result<std::optional<std::string>> text(const char* field) const;
  [[nodiscard]] Result<std::optional<double>> number(const char* field) const;
  [[nodiscard]] Result<std::optional<bool>> flag(const char* field) const;
  /// A string, or an array of strings.
  [[nodiscard]] Result<std::vector<std::string>> texts(const char* field) const;
  [[nodiscard]] Result<std::vector<double>> numbers(const char* field) const;  ///< an array of numbers
  /// An array of so many numbers.
  [[nodiscard]] Result<std::vector<double>> numbers(const char* field, std::size_t count) const;
  /// [width, height].
  [[nodiscard]] Result<std::optional<std::pair<int, int>>> size(const char* field) const;
  /// The same, and kBadContent if it is missing.
  [[nodiscard]] Result<std::string> needed_text(const char* field) const;
  /// JSON text of an object, or nothing if the field is of another kind.
  [[nodiscard]] std::optional<std::string> object(const char* field) const;
  /// JSON text of an object of all fields but these, and "do".
  [[nodiscard]] std::string rest(std::span<const char* const> but) const;
  /// A whole number from least on, or nothing. errors kBadContent for another.
  [[nodiscard]] Result<std::optional<std::uint32_t>> whole(const char* field, std::uint32_t least) const;
  /// A number, array, string or boolean as it is written on a command line: "0.3,0.3,0.1".
  [[nodiscard]] Result<std::string> value_text(const char* field) const;

  [[nodiscard]] Error wrong(const std::string& what, const char* field) const;

 private:
  Action(std::unique_ptr<nlohmann::json> json, std::string verb, std::string where);
  std::unique_ptr<nlohmann::json> json_;
  std::string verb_;
  std::string where_;
};

}  // namespace luminist
