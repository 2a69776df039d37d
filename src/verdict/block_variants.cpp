#include <algorithm>
#include <cmath>

#include "verdict/lock_probe.h"
#include "verdict/quick_search.h"

namespace luminist {
namespace {

bool param_free(const ParamBlock& block, int param) {
  const ParamSpec& spec = block.schema()[param];
  for (int c = 0; c < spec.dofs(); ++c) {
    if (block.locked(spec.first_dof + c)) return false;
  }
  return spec.dofs() > 0;
}

ParamState only_block(const ParamState& state, int block) {
  ParamState alone = state;
  const std::vector<ParamBlock*> blocks = alone.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (static_cast<int>(b) != block) blocks[b]->set_param_locked(-1, true);
  }
  return alone;
}

/// A free place of a light moves in front of the point that it shall shine on; a free direction turns there.
void aim(ParamBlock& block, const Vec3& point, const Vec3& normal, const SceneFrame& frame, Random& random) {
  const ParamSchema& schema = block.schema();
  const auto position = schema.by_role("position");
  const auto direction = schema.by_role("direction");
  const bool turns = direction && param_free(block, *direction);
  if (position && param_free(block, *position) && (turns || !direction)) {
    Vec3 way = random.direction();
    if (glm::dot(way, normal) < 0.0F) way = -way;
    const float distance = frame.radius * static_cast<float>(random.uniform(1.2, 3.0));
    block.set_vec3(*position, point + distance * glm::normalize(way + 0.5F * normal));
  }
  if (turns && position) {
    const Vec3 way = point - block.vec3(*position);
    if (glm::length(way) > 1e-4F * frame.radius) block.set_vec3(*direction, glm::normalize(way));
  } else if (turns) {
    Vec3 way = random.direction();
    if (glm::dot(way, normal) > 0.0F) way = -way;
    block.set_vec3(*direction, way);
  }
}

}  // namespace

WishPlaces wish_places(const SampledWish& wish, const SurfaceBuffer& surface) {
  WishPlaces places;
  for (const std::uint32_t pixel : wish.samples.pixels) {
    places.position.push_back(surface.position[pixel]);
    places.normal.push_back(surface.normal[pixel]);
  }
  return places;
}

std::vector<ParamState> block_variants(const ParamState& state, int block, const WishPlaces& places,
                                       const SceneFrame& frame, int count, Random& random) {
  std::vector<ParamState> variants;
  const ParamBlock& now = *state.blocks()[static_cast<std::size_t>(block)];
  if (!any_free(now)) return variants;  // said first: a scene has hundreds of materials that nobody turns
  const ParamState alone = only_block(state, block);
  const UnitMap map = UnitMap::create(alone.blocks(), frame);
  if (map.dofs() == 0) return variants;
  const std::vector<double> x = map.to_unit(alone.blocks());
  for (int v = 0; v < count; ++v) {
    std::vector<double> moved = x;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      const ParamSpec& spec = now.schema()[map.list()[k].param];
      const bool near = v % 3 == 0;
      moved[k] = near ? std::clamp(x[k] + 0.15 * random.normal(), 0.0, 1.0) : random.uniform();
      if (spec.role == "color") moved[k] = random.uniform(0.15, 0.5);
    }
    ParamState variant = state;
    map.from_unit(moved, variant.blocks());
    if (v % 3 != 0 && !places.position.empty()) {
      const auto i = static_cast<std::size_t>(random.index(static_cast<int>(places.position.size())));
      aim(*variant.blocks()[static_cast<std::size_t>(block)], places.position[i], places.normal[i], frame, random);
    }
    keep_constraints(variant.rig);
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace luminist
