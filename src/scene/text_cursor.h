#pragma once
// scene/text_cursor.h -- words and numbers of a text file, with the line they stand on.
#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace luminist {

/// Walks over white space (and, where asked, # comments) and never beyond the end.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text, bool with_comments) : text_(text), with_comments_(with_comments) {}

  /// The next word, or "" at the end of the text.
  std::string_view word() {
    skip(true);
    return cut_word();
  }
  /// The next word of this line, or "" at its end.
  std::string_view word_in_line() {
    skip(false);
    return cut_word();
  }
  void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }
  [[nodiscard]] std::size_t line() const { return line_; }  ///< of the last word, from 1
  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] std::size_t remaining() const { return text_.size() - at_; }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f'; }
  void skip(bool over_lines) {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (with_comments_ && c == '#') {
        skip_line();
        if (at_ == text_.size()) return;
      } else if (!is_space(c)) {
        return;
      }
      if (text_[at_] != '\n') continue;
      if (!over_lines) return;
      ++line_;
    }
  }
  std::string_view cut_word() {
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_]) && !(with_comments_ && text_[at_] == '#')) ++at_;
    return text_.substr(start, at_ - start);
  }

  std::string_view text_;
  bool with_comments_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// The whole word as a number, independent of the locale. "nan" and "inf" are numbers; what is too large for a double
/// is infinite, what is too small is zero; an integer must fit.
template <class Number>
std::optional<Number> to_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    if constexpr (std::is_integral_v<Number>) return std::nullopt;
    const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
    return tiny ? Number{} : std::numeric_limits<Number>::infinity();
  }
  return value;
}

}  // namespace luminist
