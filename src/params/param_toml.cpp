#include "params/param_toml.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/files.h"
#include "params/param_text.h"
#include "params/param_values.h"

namespace luminist {
namespace {

using Kind = TomlValue::Kind;

std::optional<std::vector<double>> values_of(const ParamSpec& spec, const TomlValue& value) {
  if (spec.type == ParamType::kChoice)
    return value.kind == Kind::kString ? choice_index(spec, value.text) : std::nullopt;
  if (spec.components() == 1) {
    const bool good = spec.type == ParamType::kBool ? value.kind == Kind::kBool : value.is_number();
    return good ? std::optional(std::vector{value.number}) : std::nullopt;
  }
  std::vector<double> list;
  for (const TomlValue& item : value.items) {
    if (!item.is_number()) return std::nullopt;
    list.push_back(item.number);
  }
  return list;
}

void unlock(TomlReader& read, const TomlValue& item, ParamBlock& block) {
  std::vector<std::string> names;
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    if (spec.dofs() == 0) continue;
    if (item.text == spec.name) return block.set_param_locked(param, false);
    names.push_back(spec.name);
    for (int c = 0; c < spec.dofs(); ++c) {
      if (item.text == dof_name(spec, c)) return block.set_locked(spec.first_dof + c, false);
      names.push_back(dof_name(spec, c));
    }
  }
  const std::string nearest = nearest_name(item.text, names);
  read.fail_at(item, "unlocked", fmt::format("\"{}\" has no degree of freedom to unlock", item.text),
               nearest.empty() ? "" : fmt::format("did you mean \"{}\"?", nearest));
}

/// The unlocked degrees of freedom of a block, whole parameters by their name.
std::vector<std::string> unlocked_names(const ParamBlock& block) {
  std::vector<std::string> names;
  for (const ParamSpec& spec : block.schema().specs()) {
    std::vector<std::string> parts;
    for (int c = 0; c < spec.dofs(); ++c) {
      if (!block.locked_by_hand(spec.first_dof + c)) parts.push_back(toml_string(dof_name(spec, c)));
    }
    if (!parts.empty() && static_cast<int>(parts.size()) == spec.dofs()) parts = {toml_string(spec.name)};
    names.insert(names.end(), parts.begin(), parts.end());
  }
  return names;
}

}  // namespace

void read_params(TomlReader& read, ParamBlock& block) {
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    const TomlValue* value = read.value(spec.name);
    if (value == nullptr || store_values(block, param, values_of(spec, *value))) continue;
    read.fail(spec.name, fmt::format("this is no value for a {}", type_name(spec.type)), wanted_form(spec));
  }
  const TomlValue* unlocked = read.value("unlocked");
  if (unlocked == nullptr) return;
  if (unlocked->kind != Kind::kArray) read.fail("unlocked", "an array of names is wanted here");
  block.set_param_locked(-1, true);
  for (const TomlValue& item : unlocked->items) unlock(read, item, block);
}

std::string param_to_toml(const ParamBlock& block, int param) {
  const ParamSpec& spec = block.schema()[param];
  if (spec.type == ParamType::kBool) return block.get(param) != 0.0 ? "true" : "false";
  if (spec.type == ParamType::kInt) return fmt::format("{}", static_cast<int>(block.get(param)));
  if (spec.type == ParamType::kChoice) return toml_string(spec.choices[static_cast<std::size_t>(block.get(param))]);
  std::vector<std::string> numbers;
  numbers.reserve(static_cast<std::size_t>(spec.components()));
  for (int c = 0; c < spec.components(); ++c) {
    numbers.push_back(number_text(shortest_double(static_cast<float>(block.get(param, c)))));
  }
  return spec.components() == 1 ? numbers[0] : fmt::format("[{}]", fmt::join(numbers, ", "));
}

std::string params_to_toml(const ParamBlock& block) {
  std::string text;
  for (int param = 0; param < block.schema().size(); ++param) {
    text += fmt::format("{} = {}\n", block.schema()[param].name, param_to_toml(block, param));
  }
  const std::vector<std::string> unlocked = unlocked_names(block);
  if (unlocked != unlocked_names(ParamBlock(block.schema_pointer(), SceneFrame{}))) {
    text += fmt::format("unlocked = [{}]\n", fmt::join(unlocked, ", "));
  }
  return text;
}

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      quoted += fmt::format("\\u{:04X}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace luminist
