#include "raster/candidate_table.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace luminist {

CandidateTable::CandidateTable(const RelightLayout& layout, const LightTypes& types,
                               std::vector<std::string> object_names)
    : types_(&types), links_(std::move(object_names)) {
  ambient_.array = layout.ambient;
  style_.array = layout.style;
  for (const BlockArray& array : layout.light_types) light_types_.push_back({array, {}, {}});
}

void CandidateTable::clear() {
  candidates_.clear();
  lights_.clear();
  materials_.clear();
  material_bytes_.clear();
  material_row_ = {};
  links_.clear();
  const auto empty = [](Blocks& blocks) { blocks.bytes.clear(), blocks.last.clear(); };
  empty(ambient_);
  empty(style_);
  for (Blocks& blocks : light_types_) empty(blocks);
}

std::uint32_t CandidateTable::Blocks::add(std::size_t user, std::span<const std::byte> block) {
  LUM_CHECK(block.size() == array.stride, "a block is of the schema that the program was made for");
  if (last.size() <= user) last.resize(user + 1, kNone);
  if (last[user] != kNone) {
    const auto known = std::span(bytes).subspan(last[user] * array.stride, array.stride);
    if (std::equal(block.begin(), block.end(), known.begin())) return last[user];
  }
  last[user] = static_cast<std::uint32_t>(bytes.size() / array.stride);
  bytes.insert(bytes.end(), block.begin(), block.end());
  return last[user];
}

std::vector<int> lit_lights(const Candidate& candidate) {
  const std::vector<Light>& lights = candidate.state->rig.lights;
  std::vector<int> lit;
  for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
    const bool wanted = candidate.light == Candidate::kAllLights || candidate.light == i;
    if (wanted && !lights[static_cast<std::size_t>(i)].muted) lit.push_back(i);
  }
  return lit;
}

bool CandidateTable::fits(const LightRig& rig, std::span<const int> lights) const {
  if (ambient_.free() == 0 || style_.free() == 0) return false;
  std::vector<std::size_t> wanted(light_types_.size(), 0);
  for (const int i : lights) {
    const int type = types_->index(rig.lights[static_cast<std::size_t>(i)].type);
    LUM_CHECK(type >= 0, "a rig holds lights of types that exist");
    if (++wanted[static_cast<std::size_t>(type)] > light_types_[static_cast<std::size_t>(type)].free()) return false;
  }
  return true;
}

CandidateTable::Row CandidateTable::add_materials(const ParamState& state) {
  std::string bytes = material_bytes(state);
  if (bytes == material_bytes_) return material_row_;
  const auto first = static_cast<std::uint32_t>(materials_.size());
  for (const MaterialParams& material : state.materials) materials_.push_back(turn_of(material.params));
  while (materials_.size() > first && materials_.back().nothing()) materials_.pop_back();
  material_bytes_ = std::move(bytes);
  material_row_ = {first, static_cast<std::uint32_t>(materials_.size()) - first, 0, 0};
  return material_row_;
}

bool CandidateTable::add(const Candidate& candidate, const ColumnOf& column_of) {
  LUM_CHECK(candidate.state != nullptr, "a candidate has a state");
  return add(*candidate.state, lit_lights(candidate), candidate.light < 0, column_of);
}

bool CandidateTable::add(const ParamState& state, std::span<const int> lights, bool whole, const ColumnOf& column_of) {
  const LightRig& rig = state.rig;
  if (!fits(rig, lights)) return false;
  candidates_.push_back({static_cast<std::uint32_t>(lights_.size()), static_cast<std::uint32_t>(lights.size()),
                         whole ? ambient_.add(0, rig.ambient.bytes()) : kNone, style_.add(0, state.style.bytes())});
  candidates_.push_back(add_materials(state));
  const std::span<const std::uint32_t> links = links_.entries(rig);
  for (const int i : lights) {
    const Light& light = rig.lights[static_cast<std::size_t>(i)];
    const auto type = static_cast<std::uint32_t>(types_->index(light.type));
    const std::uint32_t block = light_types_[type].add(static_cast<std::size_t>(i), light.params.bytes());
    lights_.push_back({type, block, column_of(rig, i), links[static_cast<std::size_t>(i)]});
  }
  return true;
}

}  // namespace luminist
