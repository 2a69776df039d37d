#include "solve/light_variants.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "solve/aim_map.h"

namespace luminist {
namespace {

bool is_free(const ParamBlock& params, std::optional<int> param) {
  if (!param) return false;
  const ParamSpec& spec = params.schema()[*param];
  for (int k = 0; k < spec.dofs(); ++k) {
    if (params.locked(spec.first_dof + k)) return false;
  }
  return spec.dofs() > 0;
}

std::size_t draw_place(const LightPlaces& places, Random& random) {
  double sum = 0.0;
  for (const double say : places.say) sum += say;
  double at = random.uniform() * sum;
  for (std::size_t i = 0; i < places.say.size(); ++i) {
    at -= places.say[i];
    if (at < 0.0) return i;
  }
  return places.say.size() - 1;
}

/// Copies of a state with only one block unlocked, so that a map lists only that block.
ParamState only_block_free(const ParamState& state, int block) {
  ParamState result = state;
  const std::vector<ParamBlock*> blocks = result.blocks();
  for (int i = 0; i < static_cast<int>(blocks.size()); ++i) {
    if (i != block) blocks[static_cast<std::size_t>(i)]->set_param_locked(-1, true);
  }
  return result;
}

void copy_values(const ParamState& from, int block, ParamState& to) {
  const ParamBlock& source = *from.blocks()[static_cast<std::size_t>(block)];
  ParamBlock& sink = *to.blocks()[static_cast<std::size_t>(block)];
  for (int param = 0; param < source.schema().size(); ++param) {
    for (int c = 0; c < source.schema()[param].components(); ++c) sink.set(param, c, source.get(param, c));
  }
}

/// Puts a light at a random place from which it looks at `aim` and covers there what it covers now.
void place_anew(ParamBlock& params, int position, int direction, const Vec3& aim, const Vec3& normal, float distance,
                const SceneFrame& frame, Random& random) {
  const Vec3 back = -glm::normalize(params.vec3(direction));
  Vec3 to_light = random.uniform() < 0.7 ? back + static_cast<float>(random.uniform(0.0, 0.8)) * random.direction()
                                         : normal + random.direction();  // cosine-weighted above the surface
  if (!(glm::length(to_light) > 1e-3F)) to_light = normal;
  const auto longer = static_cast<float>(std::exp(random.uniform(std::log(0.4), std::log(2.5))));
  const float wanted = std::clamp(longer * distance, 0.2F * frame.radius, 6.0F * frame.radius);
  params.set_vec3(position, aim + wanted * glm::normalize(to_light));
  // Back into the range of positions, then look at the place from there.
  ParamBlock alone = params;
  alone.set_param_locked(-1, true);
  alone.set_param_locked(position, false);
  const std::array<const ParamBlock*, 1> readable{&alone};
  const std::array<ParamBlock*, 1> writable{&alone};
  const UnitMap map = UnitMap::create(readable, frame);
  std::vector<double> x = map.to_unit(readable);
  for (double& value : x) value = std::clamp(value, 0.0, 1.0);
  map.from_unit(x, writable);
  params.set_vec3(position, alone.vec3(position));
  const Vec3 way = aim - params.vec3(position);
  const float now = glm::length(way);
  if (!(now > 1e-4F * frame.radius)) return;
  params.set_vec3(direction, way / now);
  keep_footprint(params, frame, distance, now);
}

/// The parameters of one manifest group as they are in `source`, and nothing else of the block free.
/// Groups with a position or a direction, or of a single parameter, stay: there is nothing to undo in them.
ParamState group_reset(const ParamState& alone, const ParamState& source, int block, const std::string& group) {
  ParamState result = alone;
  ParamBlock& params = *result.blocks()[static_cast<std::size_t>(block)];
  const ParamBlock& before = *source.blocks()[static_cast<std::size_t>(block)];
  int members = 0;
  bool place = false;
  for (const ParamSpec& spec : params.schema().specs()) {
    members += spec.group == group ? 1 : 0;
    place = place || (spec.group == group && (spec.role == "position" || spec.role == "direction"));
  }
  for (int param = 0; param < params.schema().size(); ++param) {
    const ParamSpec& spec = params.schema()[param];
    if (spec.group != group) {
      params.set_param_locked(param, true);
    } else if (members > 1 && !place) {
      for (int k = 0; k < spec.dofs(); ++k) {
        if (!params.locked(spec.first_dof + k)) params.set(param, k, before.get(param, k));
      }
    }
  }
  return result;
}

/// The unlocked parameters of a block as a new light has them.
ParamState with_defaults(const ParamState& state, int block, const SceneFrame& frame) {
  ParamState result = state;
  ParamBlock& params = *result.blocks()[static_cast<std::size_t>(block)];
  for (int param = 0; param < params.schema().size(); ++param) {
    const ParamSpec& spec = params.schema()[param];
    if (!is_free(params, param)) continue;
    for (int c = 0; c < spec.components(); ++c) {
      params.set(param, c, spec.stored(c, spec.default_value[static_cast<std::size_t>(c)], frame));
    }
  }
  return result;
}

void scan_values(const ParamState& state, const ParamState& around, int block, const SceneFrame& frame,
                 std::vector<std::vector<ParamState>>& scans) {
  constexpr std::array<double, 9> kValues{0.02, 0.06, 0.1, 0.16, 0.24, 0.35, 0.5, 0.7, 0.9};
  const ParamBlock& params = *around.blocks()[static_cast<std::size_t>(block)];
  const AimMap map(around, frame, frame.center);
  for (std::size_t k = 0; k < map.origin().size(); ++k) {
    if (params.schema()[map.units().list()[k].param].role == "color") continue;
    scans.emplace_back();
    for (const double value : kValues) {
      std::vector<double> x = map.origin();
      x[k] = value;
      ParamState variant = state;
      copy_values(map.at(x), block, variant);
      scans.back().push_back(std::move(variant));
    }
  }
}

/// Half width and height of a shape, exchanged. returns false if there are no two free ones.
bool swap_sides(ParamBlock& params) {
  const std::optional<int> shape = params.schema().by_role("shape");
  if (!shape || params.schema()[*shape].components() < 2) return false;
  const int first = params.schema()[*shape].first_dof;
  if (params.locked(first) || params.locked(first + 1)) return false;
  const double width = params.get(*shape, 0);
  params.set(*shape, 0, params.get(*shape, 1));
  params.set(*shape, 1, width);
  return true;
}

void scan_edges(const ParamState& state, const ParamState& alone, int block, const SceneFrame& frame,
                std::vector<std::vector<ParamState>>& scans) {
  constexpr int kWays = 8;  // the roll of a light is its own affair: all ways round are tried
  constexpr std::array<double, 8> kShares{-0.5, -0.25, 0.15, 0.3,
                                          0.45, 0.6,   0.75, 0.87};  // of the half size that is cut off
  const ParamBlock& params = *alone.blocks()[static_cast<std::size_t>(block)];
  const std::optional<int> direction = params.schema().by_role("direction");
  const std::optional<int> shape = params.schema().by_role("shape");
  if (!is_free(params, direction) || !shape || params.schema()[*shape].components() < 2) return;
  const Vec3 axis = glm::normalize(params.vec3(*direction));
  Vec3 right;
  Vec3 up;
  tangent_frame(axis, right, up);
  for (int way = 0; way < kWays; ++way) {
    // A light that turns past straight down may roll by a quarter: then width and height have changed places.
    const double angle = 2.0 * kPi * way / kWays;
    const Vec3 across = static_cast<float>(std::cos(angle)) * right + static_cast<float>(std::sin(angle)) * up;
    for (const bool swapped : {false, true}) {
      scans.emplace_back();
      for (const float shift : {0.1F, 0.3F}) {
        ParamState variant = state;
        ParamBlock& changed = *variant.blocks()[static_cast<std::size_t>(block)];
        if (swapped && !swap_sides(changed)) continue;
        changed.set_vec3(*direction, glm::normalize(axis + shift * across));
        scans.back().push_back(std::move(variant));
      }
      if (scans.back().empty()) scans.pop_back();
    }
  }
  for (int side = 0; side < 2; ++side) {
    if (params.locked(params.schema()[*shape].first_dof + side)) continue;
    const double half = params.get(*shape, side);
    const double most = params.range(*shape, side, frame).high;
    for (int way = 0; way < kWays; ++way) {
      const double angle = 2.0 * kPi * way / kWays;
      const Vec3 across = static_cast<float>(std::cos(angle)) * right + static_cast<float>(std::sin(angle)) * up;
      scans.emplace_back();
      for (const double share : kShares) {
        ParamState variant = state;
        ParamBlock& changed = *variant.blocks()[static_cast<std::size_t>(block)];
        // The other edge stays: half sizes are tangents, so angles add up and tangents do not.
        const double left = std::min(half * (1.0 - share), most);
        const double turn = std::tan(std::atan(half) - std::atan(left));
        changed.set(*shape, side, left);
        changed.set_vec3(*direction, glm::normalize(axis + static_cast<float>(turn) * across));
        scans.back().push_back(std::move(variant));
      }
    }
  }
}

}  // namespace

std::vector<ParamState> light_variants(const ParamState& state, int block, const LightPlaces& places,
                                       const SceneFrame& frame, int count, Random& random) {
  const ParamState alone = only_block_free(state, block);
  const ParamBlock& params = *alone.blocks()[static_cast<std::size_t>(block)];
  const std::optional<int> position = params.schema().by_role("position");
  const std::optional<int> direction = params.schema().by_role("direction");
  const bool can_be_placed = is_free(params, position) && is_free(params, direction) && !places.position.empty();
  // A lamp of a size that is not aimed does about the same when it is large as when it is small and a little elsewhere:
  // each of its parameters is varied as far as it likes, and its place not far beyond what it shines on.
  const bool lamp = is_free(params, position) && !can_be_placed && is_free(params, params.schema().by_role("extent"));
  std::vector<ParamState> variants;
  for (int i = 0; i < count; ++i) {
    ParamState centre = alone;
    ParamBlock& moved = *centre.blocks()[static_cast<std::size_t>(block)];
    const bool placed = can_be_placed && i % 3 != 2;
    if (placed) {
      const Vec3 at = moved.vec3(*position);
      const Vec3 way = glm::normalize(moved.vec3(*direction));
      const float distance = std::max(glm::dot(places.focus - at, way), 0.25F * frame.radius);
      const std::size_t place = draw_place(places, random);
      const Vec3 aim = i % 3 == 0 ? at + distance * way : places.position[place];
      place_anew(moved, *position, *direction, aim, places.normal[place], distance, frame, random);
      if (random.uniform() < 0.3) swap_sides(moved);
    }
    const AimMap map(centre, frame, places.focus);
    std::vector<double> x = map.origin();
    constexpr std::array<double, 3> kSpread{0.03, 0.1, 0.3};
    constexpr double kLampReach = 0.2;
    const double spread = kSpread[static_cast<std::size_t>(random.index(3))];
    const double share = placed ? random.uniform() * random.uniform() : random.uniform(0.1, 1.0);  // of what changes
    for (std::size_t k = 0; k < x.size(); ++k) {
      const std::string& role = params.schema()[map.units().list()[k].param].role;
      const bool place = role == "position" || role == "direction";
      if (role == "color" || (placed && place) || random.uniform() >= share) continue;
      if (lamp) {
        const double own = kSpread[static_cast<std::size_t>(random.index(3))];
        x[k] = std::clamp(x[k] + (place ? kLampReach * own : own) * random.normal(), 0.0, 1.0);
        continue;
      }
      x[k] = random.uniform() < 0.2 ? random.uniform() : x[k] + spread * random.normal();
      x[k] = std::clamp(x[k], 0.0, 1.0);
    }
    ParamState variant = state;
    copy_values(map.at(x), block, variant);
    variants.push_back(std::move(variant));
  }
  return variants;
}

std::vector<std::vector<ParamState>> light_scans(const ParamState& state, const ParamState& start, int block,
                                                 const SceneFrame& frame) {
  std::vector<std::vector<ParamState>> scans;
  const ParamState alone = only_block_free(state, block);
  scan_values(state, alone, block, frame, scans);
  const ParamBlock& params = *alone.blocks()[static_cast<std::size_t>(block)];
  std::vector<std::string> groups;
  for (const ParamSpec& spec : params.schema().specs()) {
    if (std::find(groups.begin(), groups.end(), spec.group) == groups.end()) groups.push_back(spec.group);
  }
  const ParamState fresh = with_defaults(alone, block, frame);
  for (const std::string& group : groups) {
    for (const ParamState* before : {&start, &fresh}) {
      const ParamState reset = group_reset(alone, *before, block, group);
      const ParamBlock& changed = *reset.blocks()[static_cast<std::size_t>(block)];
      if (params.same_values(changed)) continue;
      if (before == &start) scan_values(state, reset, block, frame, scans);
      ParamState variant = state;
      copy_values(reset, block, variant);
      scan_edges(variant, only_block_free(variant, block), block, frame, scans);
      scans.push_back({std::move(variant)});
    }
  }
  scan_edges(state, alone, block, frame, scans);
  return scans;
}

ParamState with_block_of(const ParamState& state, const ParamState& from, int block) {
  ParamState result = state;
  copy_values(from, block, result);
  return result;
}

std::vector<ParamState> light_exchange(const ParamState& state, int block, int other) {
  ParamState result = state;
  const std::vector<const ParamBlock*> before = state.blocks();
  const std::vector<ParamBlock*> after = result.blocks();
  const ParamBlock& a = *before[static_cast<std::size_t>(block)];
  const ParamBlock& b = *before[static_cast<std::size_t>(other)];
  if (a.schema().names() != b.schema().names()) return {};  // the same type, perhaps read twice
  bool exchanged = false;
  for (int param = 0; param < a.schema().size(); ++param) {
    if (!is_free(a, param) || !is_free(b, param)) continue;
    for (int c = 0; c < a.schema()[param].components(); ++c) {
      after[static_cast<std::size_t>(block)]->set(param, c, b.get(param, c));
      after[static_cast<std::size_t>(other)]->set(param, c, a.get(param, c));
    }
    exchanged = true;
  }
  if (!exchanged) return {};
  return {std::move(result)};
}

}  // namespace luminist
