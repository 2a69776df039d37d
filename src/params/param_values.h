#pragma once
// params/param_values.h -- numbers from outside (a command line, JSON, TOML) on their way into a block.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "params/param_block.h"

namespace luminist {

/// What a user may write for a parameter, as a hint: "give 2 numbers, as 0.3,0.1".
std::string wanted_form(const ParamSpec& spec);

/// The index of a choice's name as the one number that is stored.
std::optional<std::vector<double>> choice_index(const ParamSpec& spec, std::string_view name);

/// Stores values that have the parameter's count, are finite as floats and whole for an int; a direction is normalized.
/// returns false, and the block is as it was, where they do not fit or there are none.
bool store_values(ParamBlock& block, int param, const std::optional<std::vector<double>>& values);

}  // namespace luminist
