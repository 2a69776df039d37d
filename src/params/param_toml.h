#pragma once
// params/param_toml.h -- a block as keys of a TOML table, as rig files have it.
#include <string>
#include <string_view>

#include "params/param_block.h"
#include "params/toml_reader.h"

namespace luminist {

/// Sets every parameter whose name is a key of the table, and the locks where there is a key `unlocked`: an array of
/// parameters and degrees of freedom ("color", "position.y"); all others are then locked. Mistakes are the reader's.
void read_params(TomlReader& read, ParamBlock& block);

/// Lines "name = value" that read_params() turns into the same bits, and `unlocked` where the locks are not those that
/// the schema starts with.
std::string params_to_toml(const ParamBlock& block);

/// The value of one parameter as it stands there behind its name.
std::string param_to_toml(const ParamBlock& block, int param);

/// A quoted TOML string.
std::string toml_string(std::string_view text);

}  // namespace luminist
