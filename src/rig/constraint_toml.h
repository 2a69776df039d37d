#pragma once
// rig/constraint_toml.h -- constraints as [[constraint]] tables of a rig file.
#include <span>
#include <string>

#include "params/toml_reader.h"
#include "rig/light_rig.h"

namespace luminist {

/// Reads the tables into the rig, whose lights are already there, and keeps them.
/// errors kBadContent at path:line:col: an unknown key, a value of another form, and what find_fault() finds.
Result<void> read_constraints(std::span<const TomlValue> tables, const std::string& path, LightRig& rig);

/// The tables that read back to the same bits; "" without constraints.
std::string constraints_to_toml(const LightRig& rig);

}  // namespace luminist
