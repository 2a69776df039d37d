#include "verdict/lock_probe.h"

#include <algorithm>

namespace luminist {
namespace {

constexpr int kGroupVariants = 9;       // of each group
constexpr std::size_t kFinalists = 12;  // groups that descend

/// Whether unlocking it would free it: what follows another light has no lock of its own to open.
bool opens(const ParamBlock& block, int dof) {
  return block.locked(dof) && !block.following(dof);
}

bool any_locked(const ParamBlock& block, const ParamSpec& spec) {
  for (int c = 0; c < spec.dofs(); ++c) {
    if (opens(block, spec.first_dof + c)) return true;
  }
  return false;
}

void include(LockedGroup& group, const ParamBlock& block, int param, const std::string& path) {
  const ParamSpec& spec = block.schema()[param];
  group.params.push_back(param);
  group.patterns.push_back(path + "/" + spec.name);
  for (int c = 0; c < spec.dofs(); ++c) group.dofs += opens(block, spec.first_dof + c) ? 1 : 0;
}

bool has_part(const ParamState& state, int block) {
  const int light = block - light_block(0);
  const bool of_light = light >= 0 && light < static_cast<int>(state.rig.lights.size());
  return !of_light || !state.rig.lights[static_cast<std::size_t>(light)].muted;
}

/// Whether a material that no sample of a wish sees is all that a group is of.
bool unseen(const ParamState& state, const LockedGroup& group, const SampledWish& wish, const SurfaceBuffer& surface) {
  const int material = material_of_block(state, group.block);
  return material >= 0 && std::ranges::none_of(wish.samples.pixels, [&](std::uint32_t pixel) {
           return surface.material[pixel] == static_cast<std::uint32_t>(material) + 1;
         });
}

}  // namespace

bool any_free(const ParamBlock& block) {
  for (int dof = 0; dof < block.schema().dofs(); ++dof) {
    if (!block.locked(dof)) return true;
  }
  return false;
}

bool role_free(const ParamBlock& block, std::string_view role) {
  const auto param = block.schema().by_role(role);
  if (!param) return false;
  const ParamSpec& spec = block.schema()[*param];
  for (int c = 0; c < spec.dofs(); ++c) {
    if (!block.locked(spec.first_dof + c)) return true;
  }
  return false;
}

std::vector<LockedGroup> locked_groups(const ParamState& state, LockedKind kind) {
  std::vector<LockedGroup> groups;
  const std::vector<const ParamBlock*> blocks = state.blocks();
  const std::vector<std::string> paths = state.block_paths();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const bool of_material = material_of_block(state, static_cast<int>(b)) >= 0;
    if (of_material != (kind == LockedKind::kMaterial) || !has_part(state, static_cast<int>(b))) continue;
    const ParamSchema& schema = blocks[b]->schema();
    LockedGroup place;
    place.block = static_cast<int>(b);
    for (int param = 0; param < schema.size(); ++param) {
      const ParamSpec& spec = schema[param];
      if (spec.quality || !any_locked(*blocks[b], spec)) continue;
      LockedGroup group;
      group.block = static_cast<int>(b);
      include(group, *blocks[b], param, paths[b]);
      groups.push_back(std::move(group));
      if (spec.role == "position" || spec.role == "direction") include(place, *blocks[b], param, paths[b]);
    }
    if (place.params.size() > 1) groups.push_back(std::move(place));
  }
  return groups;
}

ParamState unlocked(const ParamState& state, const LockedGroup& group) {
  ParamState next = state;
  for (const int param : group.params) {
    next.blocks()[static_cast<std::size_t>(group.block)]->set_param_locked(param, false);
  }
  return next;
}

Result<std::vector<Unlocking>> best_unlockings(Renderer& renderer, const ParamState& state, const SampledWish& wish,
                                               std::size_t keep, LockedKind kind) {
  std::vector<LockedGroup> groups = locked_groups(state, kind);
  std::erase_if(groups, [&](const LockedGroup& group) { return unseen(state, group, wish, renderer.surface()); });
  const WishPlaces places = wish_places(wish, renderer.surface());
  Random random(wish.samples.id);
  QuickSearch search(renderer);
  std::vector<ParamState> variants;
  std::vector<int> blocks;
  std::vector<std::size_t> first;  // of each group
  for (const LockedGroup& group : groups) {
    first.push_back(variants.size());
    const ParamState free = unlocked(state, group);
    for (ParamState& v : block_variants(free, group.block, places, renderer.frame(), kGroupVariants, random)) {
      variants.push_back(std::move(v));
      blocks.push_back(group.block);
    }
  }
  first.push_back(variants.size());
  std::vector<Unlocking> found;
  if (variants.empty()) return found;
  LUM_TRY(const std::vector<double> errors, search.settle_colors(variants, blocks, wish));
  std::vector<std::pair<double, std::size_t>> order;  // error of a group's best variant, which one
  std::vector<std::size_t> best(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto begin = errors.begin() + static_cast<std::ptrdiff_t>(first[g]);
    const auto end = errors.begin() + static_cast<std::ptrdiff_t>(first[g + 1]);
    const auto least = std::min_element(begin, end);
    best[g] = static_cast<std::size_t>(least - errors.begin());
    order.emplace_back(*least, g);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  order.resize(std::min(order.size(), kFinalists));
  std::vector<ParamState> starts;
  for (const auto& [error, g] : order) {
    starts.push_back(unlocked(state, groups[g]));
    starts.push_back(variants[best[g]]);
  }
  LUM_TRY(std::vector<Reached> ends, search.descend(std::move(starts), wish, 4, 3));
  for (std::size_t k = 0; k < order.size(); ++k) {
    Reached& end = ends[2 * k].error <= ends[2 * k + 1].error ? ends[2 * k] : ends[2 * k + 1];
    found.push_back({groups[order[k].second], std::move(end)});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Unlocking& a, const Unlocking& b) { return a.reached.error < b.reached.error; });
  if (found.size() > keep) found.erase(found.begin() + static_cast<std::ptrdiff_t>(keep), found.end());
  return found;
}

}  // namespace luminist
