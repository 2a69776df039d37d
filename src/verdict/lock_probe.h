#pragma once
// verdict/lock_probe.h -- which lock keeps a wish from being met.
#include <string>
#include <string_view>
#include <vector>

#include "verdict/quick_search.h"

namespace luminist {

/// Whether the solver may turn anything of a block, or of its first parameter with a role.
bool any_free(const ParamBlock& block);
bool role_free(const ParamBlock& block, std::string_view role);

/// Some locked parameters of one block that are unlocked together.
struct LockedGroup {
  int block = 0;
  std::vector<int> params;
  std::vector<std::string> patterns;  ///< "lights/key/color"
  int dofs = 0;                       ///< that unlocking frees
};

/// What is unlocked: of the light (ambient, lights, style), or of what it falls on.
enum class LockedKind { kLight, kMaterial };

/// Each parameter of that kind that has a locked degree of freedom, but not qualities; besides, a light's position and
/// direction together where both are locked. Muted lights have no part in the picture and are left out.
std::vector<LockedGroup> locked_groups(const ParamState& state, LockedKind kind = LockedKind::kLight);

ParamState unlocked(const ParamState& state, const LockedGroup& group);

struct Unlocking {
  LockedGroup group;
  Reached reached;  ///< with the group unlocked, for the wish
};

/// The `keep` groups whose unlocking brings a state nearest to a wish, nearest first; of materials only those that the
/// wish's samples see. errors the renderer's.
/// cost a batch of variants of every group and short descents from the best dozen of them.
Result<std::vector<Unlocking>> best_unlockings(Renderer& renderer, const ParamState& state, const SampledWish& wish,
                                               std::size_t keep, LockedKind kind = LockedKind::kLight);

}  // namespace luminist
