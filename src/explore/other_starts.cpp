#include "explore/other_starts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "explore/light_place.h"

namespace luminist {
namespace {

constexpr int kSides = 24;            // drawn for each that is taken
constexpr float kLeastCosine = 0.1F;  // of the way to a light with the surface's normal
constexpr double kJitter = 0.3;

bool all_free(const ParamBlock& params, int param) {
  const ParamSpec& spec = params.schema()[param];
  for (int k = 0; k < spec.dofs(); ++k) {
    if (params.locked(spec.first_dof + k)) return false;
  }
  return spec.dofs() > 0;
}

/// The mean normal of what lies around a place.
Vec3 normal_around(const Vec3& place, const SampleCells& cells, const SceneFrame& frame) {
  Vec3 sum(0.0F);
  for (std::size_t c = 0; c < cells.position.size(); ++c) {
    const float apart = glm::distance(cells.position[c], place) / (0.3F * frame.radius);
    sum += static_cast<float>(cells.weight[c]) * std::exp(-apart * apart) * cells.normal[c];
  }
  const float length = glm::length(sum);
  return length > 1e-12F ? sum / length : Vec3(0.0F, 1.0F, 0.0F);
}

Vec3 within_range(const Vec3& wanted, const ParamBlock& params, int param, const SceneFrame& frame) {
  Vec3 position = wanted;
  for (int c = 0; c < 3; ++c) {
    const auto [low, high] = params.range(param, c, frame);
    position[c] = std::clamp(wanted[c], static_cast<float>(low), static_cast<float>(high));
  }
  return position;
}

}  // namespace

OtherStarts::OtherStarts(const ParamState& home, const SampleCells& cells, const SceneFrame& frame, const Vec3& focus,
                         std::uint64_t seed)
    : home_(home), cells_(&cells), frame_(frame), random_(seed) {
  const std::vector<const ParamBlock*> blocks = std::as_const(home_).blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    bool any = false;
    for (int dof = 0; dof < blocks[b]->schema().dofs(); ++dof) any = any || !blocks[b]->locked(dof);
    if (!any || material_of_block(home_, static_cast<int>(b)) >= 0) continue;  // other lights are looked for
    const bool is_light = b >= 1 && b <= home_.rig.lights.size();
    const std::optional<int> position = blocks[b]->schema().by_role("position");
    if (!is_light || !position || !all_free(*blocks[b], *position)) {
      jittered_.push_back(b);
      continue;
    }
    if (home_.rig.lights[b - 1].muted) continue;
    const std::optional<int> direction = blocks[b]->schema().by_role("direction");
    Mover mover;
    mover.light = b - 1;
    mover.aim = aim_point(home_.rig.lights[b - 1], frame_, focus);
    mover.normal = normal_around(mover.aim, cells, frame_);
    mover.turns = !direction || all_free(*blocks[b], *direction);
    const Vec3 way = blocks[b]->vec3(*position) - mover.aim;
    mover.distance = std::max(glm::length(way), 0.25F * frame_.radius);
    mover.sides.push_back(glm::length(way) > 0.0F ? glm::normalize(way) : mover.normal);
    movers_.push_back(std::move(mover));
  }
}

/// Of some random sides the one that is farthest from those that were tried (Mitchell's best candidate, 1991).
Vec3 OtherStarts::other_side(const Mover& mover) {
  if (!mover.turns) return mover.sides.front();
  Vec3 best = mover.normal;
  float best_apart = -1.0F;
  for (int k = 0; k < kSides; ++k) {
    const Vec3 side = random_.direction();
    if (glm::dot(side, mover.normal) < kLeastCosine) continue;
    float apart = 2.0F;
    for (const Vec3& tried : mover.sides) apart = std::min(apart, glm::distance(side, tried));
    if (apart > best_apart) {
      best_apart = apart;
      best = side;
    }
  }
  return best;
}

void OtherStarts::move(Mover& mover, OtherStart& start) {
  Light& light = start.state.rig.lights[mover.light];
  const int position = *light.params.schema().by_role("position");
  const Vec3 side = other_side(mover);
  const auto longer = static_cast<float>(std::exp2(random_.uniform(-1.0, 1.0)));
  mover.sides.push_back(side);
  move_light(light, within_range(mover.aim + longer * mover.distance * side, light.params, position, frame_), mover.aim,
             frame_);
}

void OtherStarts::jitter(std::size_t block, ParamState& state) {
  ParamState alone = state;
  const std::vector<ParamBlock*> blocks = alone.blocks();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (b != block) blocks[b]->set_param_locked(-1, true);
  }
  const UnitMap map = UnitMap::create(std::as_const(alone).blocks(), frame_);
  std::vector<double> x = map.to_unit(std::as_const(alone).blocks());
  for (double& value : x) value = std::clamp(value + kJitter * random_.normal(), 0.0, 1.0);
  map.from_unit(x, state.blocks());
}

OtherStart OtherStarts::next() {
  OtherStart start{home_, home_};
  std::vector<bool> drawn(movers_.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) drawn[i] = random_.uniform() < 0.5;
  if (!drawn.empty() && std::none_of(drawn.begin(), drawn.end(), [](bool moves) { return moves; })) {
    drawn[static_cast<std::size_t>(random_.index(static_cast<int>(drawn.size())))] = true;
  }
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    if (drawn[i]) move(movers_[i], start);
  }
  for (const std::size_t block : jittered_) jitter(block, start.state);
  start.held = start.state;
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    ParamBlock& params = start.held.rig.lights[movers_[i].light].params;
    if (drawn[i]) params.set_param_locked(*params.schema().by_role("position"), true);
  }
  return start;
}

}  // namespace luminist
