#pragma once
// base/pattern.h -- names that are meant together.
#include <string_view>

namespace luminist {

/// Whether the whole text matches a pattern in which '*' stands for any run of characters.
bool matches(std::string_view pattern, std::string_view text);

}  // namespace luminist
