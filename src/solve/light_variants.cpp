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

/// Puts a light at a random place that looks at a place of the picture.
void place_anew(ParamBlock& params, int position, int direction, const LightPlaces& places, const SceneFrame& frame,
                Random& random) {
  const std::size_t place = draw_place(places, random);
  const Vec3 aim = places.position[place];
  Vec3 to_light = -params.vec3(direction);
  if (random.uniform() < 0.5) {
    to_light = glm::normalize(to_light) + 0.6F * random.direction();
  } else {
    to_light = random.direction() + places.normal[place];  // cosine-weighted above the surface
  }
  if (!(glm::length(to_light) > 1e-3F)) to_light = places.normal[place];
  const auto distance = static_cast<float>(frame.radius * std::exp(random.uniform(std::log(0.5), std::log(4.0))));
  params.set_vec3(position, aim + distance * glm::normalize(to_light));
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
  if (glm::length(way) > 1e-4F * frame.radius) params.set_vec3(direction, glm::normalize(way));
}

}  // namespace

std::vector<ParamState> light_variants(const ParamState& state, int block, const LightPlaces& places,
                                       const SceneFrame& frame, int count, Random& random) {
  const ParamState alone = only_block_free(state, block);
  const ParamBlock& params = *alone.blocks()[static_cast<std::size_t>(block)];
  const std::optional<int> position = params.schema().by_role("position");
  const std::optional<int> direction = params.schema().by_role("direction");
  const bool can_be_placed = is_free(params, position) && is_free(params, direction) && !places.position.empty();
  std::vector<ParamState> variants;
  for (int i = 0; i < count; ++i) {
    ParamState centre = alone;
    const bool placed = can_be_placed && i % 2 == 0;
    if (placed) {
      place_anew(*centre.blocks()[static_cast<std::size_t>(block)], *position, *direction, places, frame, random);
    }
    const AimMap map(centre, frame, frame.center);
    std::vector<double> x = map.origin();
    constexpr std::array<double, 3> kSpread{0.03, 0.1, 0.3};
    const double spread = kSpread[static_cast<std::size_t>(random.index(3))];
    for (std::size_t k = 0; k < x.size(); ++k) {
      const std::string& role = params.schema()[map.units().list()[k].param].role;
      const bool place = role == "position" || role == "direction";
      if (role == "color" || (placed && place) || random.uniform() < 0.3) continue;
      x[k] = placed && random.uniform() < 0.4 ? random.uniform() : x[k] + spread * random.normal();
      x[k] = std::clamp(x[k], 0.0, 1.0);
    }
    ParamState variant = state;
    copy_values(map.at(x), block, variant);
    variants.push_back(std::move(variant));
  }
  return variants;
}

}  // namespace luminist
