#pragma once
// app/style_parts.h -- the parts of a stack of styles, by its name.
#include <string>

namespace luminist {

/// "toon" and "outline" of "toon+outline".
struct StyleParts {
  std::string base;
  std::string lines;  ///< "": none

  [[nodiscard]] std::string name() const { return lines.empty() ? base : base + "+" + lines; }
};

inline StyleParts parts_of(const std::string& style) {
  const std::size_t plus = style.find('+');
  return {style.substr(0, plus), plus == std::string::npos ? "" : style.substr(plus + 1)};
}

}  // namespace luminist
