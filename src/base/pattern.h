#pragma once
// base/pattern.h -- names by pattern.
#include <string_view>

namespace luminist {

/// Whether the whole text matches a pattern in which '*' stands for any run of characters. cost O(pattern * text) at
/// worst.
bool matches(std::string_view pattern, std::string_view text);

}  // namespace luminist
