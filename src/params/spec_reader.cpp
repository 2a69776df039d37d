// ParamSchema::parse(): from [[param]] tables to specs.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"
#include "params/param_schema.h"
#include "params/spec_rules.h"
#include "params/toml_reader.h"

namespace luminist {
namespace {

using Kind = TomlValue::Kind;

/// The value whose word stands at a key; the reader fails with the words there are.
template <class Value, std::size_t n>
Value word(TomlReader& read, std::string_view key, const std::string& text,
           const std::array<std::pair<std::string_view, Value>, n>& words) {
  std::vector<std::string> names;
  for (const auto& [name, value] : words) {
    if (name == text) return value;
    names.emplace_back(name);
  }
  const std::string nearest = nearest_name(text, names);
  read.fail(key, fmt::format("unknown {} \"{}\"", key, text),
            nearest.empty() ? fmt::format("one of {}", fmt::join(names, ", "))
                            : fmt::format("did you mean \"{}\"?", nearest));
  return words[0].second;
}

ParamType read_type(TomlReader& read) {
  std::array<std::pair<std::string_view, ParamType>, 8> words;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto type = static_cast<ParamType>(i);
    words[i] = {type_name(type), type};
  }
  return word(read, "type", read.string("type"), words);
}

ParamScale read_scale(TomlReader& read) {
  static constexpr std::array<std::pair<std::string_view, ParamScale>, 3> kWords = {
      {{"linear", ParamScale::kLinear}, {"log", ParamScale::kLog}, {"scene", ParamScale::kScene}}};
  return word(read, "scale", read.string("scale", "linear"), kWords);
}

/// The numbers of an array; fails at the first item that is none.
std::vector<double> numbers(TomlReader& read, std::string_view key, const TomlValue& array) {
  std::vector<double> list;
  for (const TomlValue& item : array.items) {
    if (!item.is_number()) {
      read.fail_at(item, key, fmt::format("a number is wanted here, not {}", toml_kind_name(item.kind)));
    }
    list.push_back(item.number);
  }
  return list;
}

std::vector<double> read_default(TomlReader& read, const ParamSpec& spec) {
  const TomlValue& value = read.required_value("default");
  const auto wants = [&](std::string_view form) {
    read.fail("default", fmt::format("{} is wanted here, not {}", form, toml_kind_name(value.kind)));
    return std::vector<double>{0.0};
  };
  if (spec.type == ParamType::kBool)
    return value.kind == Kind::kBool ? std::vector{value.number} : wants("true or false");
  if (spec.type == ParamType::kChoice) {
    if (value.kind != Kind::kString) return wants("the name of a choice");
    if (spec.choices.empty()) return {0.0};  // the rules ask for choices
    const auto hit = std::find(spec.choices.begin(), spec.choices.end(), value.text);
    if (hit != spec.choices.end()) return {static_cast<double>(hit - spec.choices.begin())};
    const std::string nearest = nearest_name(value.text, spec.choices);
    read.fail("default", fmt::format("\"{}\" is none of the choices", value.text),
              nearest.empty() ? fmt::format("one of {}", fmt::join(spec.choices, ", "))
                              : fmt::format("did you mean \"{}\"?", nearest));
    return {0.0};
  }
  if (spec.components() == 1) return value.is_number() ? std::vector{value.number} : wants("a number");
  if (value.kind != Kind::kArray) return wants(fmt::format("an array of {} numbers", spec.components()));
  std::vector<double> list = numbers(read, "default", value);
  if (spec.type == ParamType::kDirection && list.size() == 3) {
    const double length = std::hypot(list[0], list[1], list[2]);
    if (length > 0.0 && std::isfinite(length)) {
      for (double& component : list) component /= length;
    }
  }
  return list;
}

void read_range(TomlReader& read, ParamSpec& spec) {
  const auto count = static_cast<std::size_t>(spec.components());
  if (spec.type == ParamType::kBool || spec.type == ParamType::kChoice) {
    if (read.value("range") != nullptr) read.fail("range", fmt::format("a {} has no range", type_name(spec.type)));
    spec.range_min = {0.0};
    spec.range_max = {spec.type == ParamType::kBool ? 1.0 : static_cast<double>(spec.choices.size()) - 1.0};
    return;
  }
  const TomlValue& value = read.required_value("range");
  const bool pair = value.kind == Kind::kArray && value.items.size() == 2;
  if (pair && value.items[0].is_number() && value.items[1].is_number()) {
    spec.range_min.assign(count, value.items[0].number);
    spec.range_max.assign(count, value.items[1].number);
  } else if (pair && value.items[0].kind == Kind::kArray && value.items[1].kind == Kind::kArray &&
             spec.type != ParamType::kDirection) {
    spec.range_min = numbers(read, "range", value.items[0]);
    spec.range_max = numbers(read, "range", value.items[1]);
  } else {
    read.fail("range", "a range is [min, max], or [[min...], [max...]] with one number for each component");
  }
}

Result<ParamSpec> read_spec(const TomlValue& table, const std::string& path) {
  TomlReader read(table, path, ErrorKind::kStyle);
  ParamSpec spec;
  spec.name = read.string("name");
  spec.type = read_type(read);
  spec.choices = read.strings("choices");
  spec.default_value = read_default(read, spec);
  read_range(read, spec);
  spec.scale = read_scale(read);
  spec.unit = read.string("unit", "");
  spec.group = read.string("group", "");
  spec.role = read.string("role", "");
  spec.solve = read.boolean("solve", false);
  spec.quality = read.boolean("quality", false);
  spec.doc = read.string("doc");
  if (const auto broken = find_fault(spec)) read.fail(broken->key, broken->what, broken->hint);
  LUM_TRY_VOID(read.finish());
  return spec;
}

}  // namespace

Result<std::shared_ptr<const ParamSchema>> ParamSchema::parse(std::string_view manifest, const std::string& path) {
  LUM_TRY(const TomlValue document, parse_toml(manifest, path, ErrorKind::kStyle));
  TomlReader root(document, path, ErrorKind::kStyle);
  const std::span<const TomlValue> tables = root.tables("param");
  LUM_TRY_VOID(root.status());
  std::vector<ParamSpec> specs;
  for (const TomlValue& table : tables) {
    LUM_TRY(ParamSpec spec, read_spec(table, path));
    specs.push_back(std::move(spec));
  }
  if (const auto broken = find_list_fault(specs)) {
    TomlReader place(tables[broken->index], path, ErrorKind::kStyle);
    place.fail(broken->key, broken->what, broken->hint);
    LUM_TRY_VOID(place.status());
  }
  return create(std::move(specs), path);
}

}  // namespace luminist
