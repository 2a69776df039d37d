#include "render/param_state.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.h"
#include "base/files.h"
#include "base/pattern.h"
#include "params/param_text.h"

namespace luminist {
namespace {

constexpr std::string_view kGroupPrefix = "group:";
constexpr std::string_view kMaterialPrefix = "materials/";

/// The names that a block's parameters may have before their '/': its path, and its group for a light.
std::vector<std::string> block_prefixes(const ParamState& state, std::size_t block) {
  std::vector<std::string> prefixes = {state.block_paths()[block]};
  if (block > 0 && block <= state.rig.lights.size()) {
    const std::string& group = state.rig.lights[block - 1].group;
    if (!group.empty()) prefixes.push_back(std::string(kGroupPrefix) + group);
  }
  return prefixes;
}

bool any_matches(std::string_view pattern, const std::vector<std::string>& prefixes, const std::string& name) {
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](const std::string& prefix) { return matches(pattern, prefix + '/' + name); });
}

std::string nearest_hint(std::string_view word, const std::vector<std::string>& names, std::string_view otherwise) {
  const std::string nearest = nearest_name(word, names);
  return nearest.empty() ? std::string(otherwise) : fmt::format("did you mean \"{}\"?", nearest);
}

/// Paths of all parameters. with_dofs: those that can be locked, with the single degrees of freedom.
std::vector<std::string> param_paths(const ParamState& state, bool with_dofs) {
  const std::vector<std::string> paths = state.block_paths();
  const std::vector<const ParamBlock*> blocks = state.blocks();
  std::vector<std::string> names;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (const ParamSpec& spec : blocks[b]->schema().specs()) {
      if (with_dofs && spec.dofs() == 0) continue;
      names.push_back(paths[b] + '/' + spec.name);
      for (int c = 0; with_dofs && spec.dofs() > 1 && c < spec.dofs(); ++c) {
        names.push_back(paths[b] + '/' + dof_name(spec, c));
      }
    }
  }
  return names;
}

/// Whether a parameter is another light's business: the whole of it follows.
bool follows(const ParamBlock& params, const ParamSpec& spec) {
  return spec.dofs() > 0 && params.following(spec.first_dof);
}

/// Of a path that is of a material which the state does not have; else nothing.
std::optional<Error> missing_material(const ParamState& state, std::string_view path) {
  if (!path.starts_with(kMaterialPrefix)) return std::nullopt;
  const std::string_view rest = path.substr(kMaterialPrefix.size());
  std::vector<std::string> names;
  bool known = false;
  for (const MaterialParams& material : state.materials) {
    names.push_back(material.name);
    const std::string_view after = rest.starts_with(material.name) ? rest.substr(material.name.size()) : "?";
    known = known || after.empty() || after.front() == '/' || matches(rest.substr(0, rest.rfind('/')), material.name);
  }
  if (known) return std::nullopt;
  const std::string name(rest.substr(0, rest.rfind('/')));
  return Error{ErrorKind::kUsage, fmt::format("the scene has no material \"{}\"", name), "", std::string(path),
               nearest_hint(name, names, fmt::format("there are: {}", fmt::join(names, ", ")))};
}

Error unmatched(const ParamState& state, std::string_view pattern) {
  if (auto missing = missing_material(state, pattern)) return *std::move(missing);
  const std::vector<std::string> all = param_paths(state, false);
  const bool known =
      std::any_of(all.begin(), all.end(), [&](const std::string& path) { return matches(pattern, path); });
  return {
      ErrorKind::kUsage,
      known ? fmt::format("\"{}\" has no degree of freedom", pattern) : fmt::format("\"{}\" matches nothing", pattern),
      "", std::string(pattern),
      nearest_hint(pattern, param_paths(state, true),
                   "write a path as lights/NAME, lights/NAME/color, group:NAME/color, style/* or materials/NAME")};
}

}  // namespace

std::vector<ParamBlock*> ParamState::blocks() {
  std::vector<ParamBlock*> list = {&rig.ambient};
  for (Light& light : rig.lights) list.push_back(&light.params);
  list.push_back(&style);
  for (MaterialParams& material : materials) list.push_back(&material.params);
  return list;
}

std::vector<const ParamBlock*> ParamState::blocks() const {
  std::vector<const ParamBlock*> list = {&rig.ambient};
  for (const Light& light : rig.lights) list.push_back(&light.params);
  list.push_back(&style);
  for (const MaterialParams& material : materials) list.push_back(&material.params);
  return list;
}

std::vector<std::string> ParamState::block_paths() const {
  std::vector<std::string> list = {"ambient"};
  for (const Light& light : rig.lights) list.push_back(light_path(light.name));
  list.emplace_back("style");
  for (const MaterialParams& material : materials) list.push_back(std::string(kMaterialPrefix) + material.name);
  return list;
}

int material_of_block(const ParamState& state, int block) {
  const int first = light_block(static_cast<int>(state.rig.lights.size())) + 1;
  return block >= first && block < first + static_cast<int>(state.materials.size()) ? block - first : -1;
}

std::string material_bytes(const ParamState& state) {
  std::string all;
  for (const MaterialParams& material : state.materials) {
    const std::span<const std::byte> bytes = material.params.bytes();
    all.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  return all;
}

ParamState initial_state(const LightTypes& types, const Style& style, const SceneFrame& frame) {
  return {empty_rig(types, frame), ParamBlock(style.schema, frame)};
}

Result<void> set_path(ParamState& state, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" sets nothing", assignment), "", std::string(assignment),
                 "write PATH=VALUE, as lights/key/color=1,0.8,0.6"};
  }
  const std::string_view path = assignment.substr(0, equals);
  const std::size_t slash = path.rfind('/');
  const std::vector<std::string> prefixes = state.block_paths();
  const auto block = slash == std::string_view::npos
                         ? prefixes.end()
                         : std::find(prefixes.begin(), prefixes.end(), path.substr(0, slash));
  if (block != prefixes.end()) {
    ParamBlock& params = *state.blocks()[static_cast<std::size_t>(block - prefixes.begin())];
    const std::string_view name = path.substr(slash + 1);
    if (const std::optional<int> param = params.schema().find(name)) {
      if (follows(params, params.schema()[*param])) {
        return Error{ErrorKind::kUsage, "it follows another light", "", std::string(path),
                     "set that light's, or drop the constraint"};
      }
      auto done = set_from_text(params, name, assignment.substr(equals + 1));
      if (done) return {};
      Error error = std::move(done).error();
      error.field = path;
      return error;
    }
  }
  if (auto missing = missing_material(state, path)) return *std::move(missing);
  return Error{ErrorKind::kUsage, fmt::format("there is no parameter \"{}\"", path), "", std::string(path),
               nearest_hint(path, param_paths(state, false), "write a path as lights/NAME/color or style/NAME")};
}

std::string range_note(const ParamState& state, std::string_view path, const SceneFrame& frame) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string_view::npos) return "";
  const std::vector<std::string> prefixes = state.block_paths();
  const auto block = std::find(prefixes.begin(), prefixes.end(), path.substr(0, slash));
  if (block == prefixes.end()) return "";
  const ParamBlock& params = *state.blocks()[static_cast<std::size_t>(block - prefixes.begin())];
  const std::optional<int> param = params.schema().find(path.substr(slash + 1));
  if (!param) return "";
  const ParamSpec& spec = params.schema()[*param];
  if (spec.type == ParamType::kDirection || spec.range_min.empty()) return "";
  for (int c = 0; c < spec.components(); ++c) {
    const auto [low, high] = params.range(*param, c, frame);
    const double value = params.get(*param, c);
    const double slack = 1e-6 * (std::abs(low) + std::abs(high));  // stored as floats
    if (value >= low - slack && value <= high + slack) continue;
    return fmt::format("{:.6g} is outside the range {:.6g} to {:.6g}; a solve brings it back if it is unlocked", value,
                       low, high);
  }
  return "";
}

Result<int> set_locked(ParamState& state, std::string_view pattern, bool locked) {
  int count = 0;
  const std::vector<ParamBlock*> blocks = state.blocks();
  const bool of_materials = locked || pattern.starts_with(kMaterialPrefix);
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (!of_materials && material_of_block(state, static_cast<int>(b)) >= 0) continue;
    const std::vector<std::string> prefixes = block_prefixes(state, b);
    const bool block = std::find(prefixes.begin(), prefixes.end(), pattern) != prefixes.end();
    for (const ParamSpec& spec : blocks[b]->schema().specs()) {
      const bool whole = block || any_matches(pattern, prefixes, spec.name);
      for (int c = 0; c < spec.dofs(); ++c) {
        if (!whole && !any_matches(pattern, prefixes, dof_name(spec, c))) continue;
        blocks[b]->set_locked(spec.first_dof + c, locked);
        ++count;
      }
    }
  }
  if (count == 0) return unmatched(state, pattern);
  return count;
}

Result<std::vector<ParamPlace>> params_matching(const ParamState& state, std::string_view pattern) {
  std::vector<ParamPlace> places;
  const std::vector<const ParamBlock*> blocks = state.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::vector<std::string> prefixes = block_prefixes(state, b);
    const bool block = std::find(prefixes.begin(), prefixes.end(), pattern) != prefixes.end();
    for (int param = 0; param < blocks[b]->schema().size(); ++param) {
      const ParamSpec& spec = blocks[b]->schema()[param];
      const bool whole = block || any_matches(pattern, prefixes, spec.name);
      if (whole) places.push_back({b, param});
      for (int c = 0; !whole && keys_by_component(spec) && c < spec.components(); ++c) {
        if (any_matches(pattern, prefixes, dof_name(spec, c))) places.push_back({b, param, c});
      }
    }
  }
  if (!places.empty()) return places;
  if (auto missing = missing_material(state, pattern)) return *std::move(missing);
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" matches no parameter", pattern), "", std::string(pattern),
               nearest_hint(pattern, param_paths(state, false),
                            "write a path as lights/NAME, lights/NAME/color, group:NAME/color or style/*")};
}

std::vector<std::string> dof_names(const ParamState& state, const UnitMap& map) {
  const std::vector<std::string> paths = state.block_paths();
  const std::vector<const ParamBlock*> blocks = state.blocks();
  std::vector<std::string> names;
  for (const Dof& dof : map.list()) {
    LUM_CHECK(dof.block >= 0 && static_cast<std::size_t>(dof.block) < blocks.size(), "the map is one of this state");
    const auto block = static_cast<std::size_t>(dof.block);
    names.push_back(paths[block] + '/' + dof_name(blocks[block]->schema()[dof.param], dof.component));
  }
  return names;
}

}  // namespace luminist
