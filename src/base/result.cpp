#include "base/result.h"

#include <fmt/format.h>

namespace luminist {

std::string Error::message() const {
  std::string text = fmt::format("error[E{:d}]", static_cast<int>(kind) * 100);
  if (!where.empty()) text += " " + where;
  text += ": " + what;
  if (!field.empty()) text += " (" + field + ")";
  if (!hint.empty()) text += "; " + hint;
  return text;
}

}  // namespace luminist
