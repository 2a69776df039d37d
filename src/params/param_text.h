#pragma once
// params/param_text.h -- parameters as words: command line, JSON, reference tables.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "params/param_block.h"

namespace luminist {

/// Sets one parameter from "0.3", "0.3,0.3,0.1", "true", a choice's name or "#rrggbb" (sRGB, for a colour).
/// errors kUsage with the wanted form; where the name is unknown, the nearest one. A direction is normalized.
Result<void> set_from_text(ParamBlock& block, std::string_view name, std::string_view text);

/// A number, a boolean, a choice's name or an array of numbers.
nlohmann::json param_to_json(const ParamBlock& block, int param);
/// errors kBadContent naming the field.
Result<void> param_from_json(ParamBlock& block, int param, const nlohmann::json& value);
/// Every parameter as {name: value}.
nlohmann::json block_to_json(const ParamBlock& block);

/// The schema as a Markdown table: name, type, default, range, unit, free, doc.
std::string doc_table(const ParamSchema& schema);

}  // namespace luminist
