#include "params/param_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/files.h"
#include "base/image.h"
#include "params/param_values.h"

namespace luminist {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// "#rrggbb" as linear numbers.
std::optional<std::vector<double>> hex_color(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::vector<double> rgb;
  for (std::size_t c = 0; c < 3; ++c) {
    int byte = 0;
    const char* first = text.data() + 1 + 2 * c;
    const auto [end, error] = std::from_chars(first, first + 2, byte, 16);
    if (error != std::errc() || end != first + 2 || byte < 0) return std::nullopt;
    rgb.push_back(static_cast<double>(linear_from_srgb(static_cast<float>(byte) / 255.0F)));
  }
  return rgb;
}

std::optional<std::vector<double>> number_list(std::string_view text) {
  std::vector<double> list;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::optional<double> number = parse_number(text.substr(0, comma));
    if (!number) return std::nullopt;
    list.push_back(*number);
    if (comma == std::string_view::npos) return list;
    text.remove_prefix(comma + 1);
  }
}

std::optional<std::vector<double>> values_from_text(const ParamSpec& spec, std::string_view text) {
  if (spec.type == ParamType::kChoice) return choice_index(spec, text);
  if (spec.type == ParamType::kBool) {
    if (text == "true" || text == "1") return std::vector{1.0};
    if (text == "false" || text == "0") return std::vector{0.0};
    return std::nullopt;
  }
  if (spec.type == ParamType::kColor && !text.empty() && text[0] == '#') return hex_color(text);
  return number_list(text);
}

std::optional<std::vector<double>> values_from_json(const ParamSpec& spec, const nlohmann::json& value) {
  if (spec.type == ParamType::kChoice) {
    return value.is_string() ? choice_index(spec, value.get_ref<const std::string&>()) : std::nullopt;
  }
  if (spec.type == ParamType::kBool) {
    return value.is_boolean() ? std::optional(std::vector{value.get<bool>() ? 1.0 : 0.0}) : std::nullopt;
  }
  if (spec.components() == 1) return value.is_number() ? std::optional(std::vector{value.get<double>()}) : std::nullopt;
  if (!value.is_array()) return std::nullopt;
  std::vector<double> list;
  for (const nlohmann::json& item : value) {
    if (!item.is_number()) return std::nullopt;
    list.push_back(item.get<double>());
  }
  return list;
}

/// Numbers of a schema for a reader: "0.6, 0.6, 0.1", or one number where all are the same.
std::string numbers_text(const std::vector<double>& values) {
  const bool same = std::all_of(values.begin(), values.end(), [&](double v) { return v == values[0]; });
  if (same) return fmt::format("{:.6g}", values[0]);
  std::string text;
  for (const double value : values) text += fmt::format("{}{:.6g}", text.empty() ? "" : ", ", value);
  return text;
}

std::string default_text(const ParamSpec& spec) {
  if (spec.type == ParamType::kBool) return spec.default_value[0] != 0.0 ? "true" : "false";
  if (spec.type == ParamType::kChoice) return spec.choices[static_cast<std::size_t>(spec.default_value[0])];
  return numbers_text(spec.default_value);
}

std::string range_text(const ParamSpec& spec) {
  if (spec.type == ParamType::kBool) return "";
  if (spec.type == ParamType::kChoice) return fmt::format("{}", fmt::join(spec.choices, ", "));
  const std::string scale = spec.scale == ParamScale::kLog ? " (log)" : "";
  return numbers_text(spec.range_min) + " to " + numbers_text(spec.range_max) + scale;
}

/// A text inside a Markdown table's cell.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c == '\n' ? ' ' : c;
  }
  return escaped;
}

}  // namespace

Result<void> set_from_text(ParamBlock& block, std::string_view name, std::string_view text) {
  const std::optional<int> param = block.schema().find(name);
  if (!param) {
    const std::vector<std::string> names = block.schema().names();
    const std::string nearest = nearest_name(name, names);
    return Error{ErrorKind::kUsage, fmt::format("there is no parameter \"{}\"", name), "", std::string(name),
                 nearest.empty() ? fmt::format("one of {}", fmt::join(names, ", "))
                                 : fmt::format("did you mean \"{}\"?", nearest)};
  }
  const ParamSpec& spec = block.schema()[*param];
  if (!store_values(block, *param, values_from_text(spec, trimmed(text)))) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no value for a {}", text, type_name(spec.type)), "",
                 std::string(name), wanted_form(spec)};
  }
  return {};
}

nlohmann::json param_to_json(const ParamBlock& block, int param) {
  const ParamSpec& spec = block.schema()[param];
  if (spec.type == ParamType::kBool) return block.get(param) != 0.0;
  if (spec.type == ParamType::kInt) return static_cast<int>(block.get(param));
  if (spec.type == ParamType::kChoice) return spec.choices[static_cast<std::size_t>(block.get(param))];
  if (spec.components() == 1) return shortest_double(block.scalar(param));
  nlohmann::json list = nlohmann::json::array();
  for (int c = 0; c < spec.components(); ++c) list.push_back(shortest_double(static_cast<float>(block.get(param, c))));
  return list;
}

Result<void> param_from_json(ParamBlock& block, int param, const nlohmann::json& value) {
  const ParamSpec& spec = block.schema()[param];
  if (!store_values(block, param, values_from_json(spec, value))) {
    return Error{ErrorKind::kBadContent, fmt::format("{} is no value for a {}", value.dump(), type_name(spec.type)), "",
                 spec.name, wanted_form(spec)};
  }
  return {};
}

nlohmann::json block_to_json(const ParamBlock& block) {
  nlohmann::json object = nlohmann::json::object();
  for (int param = 0; param < block.schema().size(); ++param) {
    object[block.schema()[param].name] = param_to_json(block, param);
  }
  return object;
}

double shortest_double(float value) {
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  double shortest = 0.0;
  const auto read = std::from_chars(digits.data(), written.ptr, shortest);
  // Rounding twice, to double and then to float, might miss: then the float's own digits are right.
  const bool same = read.ec == std::errc() && static_cast<float>(shortest) == value;
  return same && std::isfinite(value) ? shortest : static_cast<double>(value);
}

std::string number_text(double value) {
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  std::string text(digits.data(), written.ptr);
  // A long row of digits would be read as an integer, which overflows, and an integer has no negative zero.
  const bool whole = text.find_first_not_of("-0123456789") == std::string::npos;
  if (whole && (std::abs(value) >= 1e15 || (value == 0.0 && std::signbit(value)))) text += ".0";
  return text;
}

std::optional<double> parse_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string dof_name(const ParamSpec& spec, int component) {
  LUM_CHECK(component >= 0 && component < 3, "a parameter has at most three numbers");
  const auto c = static_cast<std::size_t>(component);
  if (spec.type == ParamType::kDirection) return spec.name + (component == 0 ? ".u" : ".v");
  if (spec.components() == 1) return spec.name;
  return spec.name + '.' + (spec.type == ParamType::kColor ? "rgb"[c] : "xyz"[c]);
}

std::string doc_table(const ParamSchema& schema) {
  std::string text = "| name | type | default | range | unit | free | doc |\n|-|-|-|-|-|-|-|\n";
  for (const ParamSpec& spec : schema.specs()) {
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", spec.name, type_name(spec.type), cell(default_text(spec)),
                    cell(range_text(spec)), cell(spec.unit), spec.solve ? "yes" : "no", cell(spec.doc));
  }
  return text;
}

}  // namespace luminist
