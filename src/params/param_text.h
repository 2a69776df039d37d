#pragma once
// params/param_text.h -- parameters as words: command line, JSON, reference tables. No locale is ever asked.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "params/param_block.h"

namespace luminist {

/// Sets one parameter from "0.3", "0.3,0.3,0.1", "true", a choice's name or "#rrggbb" (sRGB, for a colour).
/// errors kUsage with the wanted form; where the name is unknown, the nearest one. A direction is normalized.
Result<void> set_from_text(ParamBlock& block, std::string_view name, std::string_view text);

/// A number, a boolean, a choice's name or an array of numbers. Floats have the fewest digits that read back to the
/// same bits (0.3, not 0.30000001192092896).
nlohmann::json param_to_json(const ParamBlock& block, int param);
/// errors kBadContent naming the field. A direction is normalized.
Result<void> param_from_json(ParamBlock& block, int param, const nlohmann::json& value);
/// Every parameter as {name: value}.
nlohmann::json block_to_json(const ParamBlock& block);

/// The double with the fewest digits that becomes this float when it is rounded; the float itself if not finite.
double shortest_double(float value);
/// A number as text that std::from_chars and TOML read back to the same double: "0.3", "1e-20", "5".
std::string number_text(double value);
/// The whole text as a finite number, without a locale; surrounding blanks are allowed.
std::optional<double> parse_number(std::string_view text);

/// Name of one degree of freedom: "barn.x", "color.r", "direction.u" (an axis of its chart), "shadow_density".
std::string dof_name(const ParamSpec& spec, int component);

/// The schema as a Markdown table: name, type, default, range, unit, free, doc.
std::string doc_table(const ParamSchema& schema);

}  // namespace luminist
