#include "verdict/known_case.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

constexpr std::size_t kLeastPixels = 40;
constexpr double kLeastWish = 0.06;
constexpr float kUnpainted = 0.1F;

Vec3 front(Random& random) {
  Vec3 way = random.direction();
  way.y = std::abs(way.y) + 0.4F;
  way.z = std::abs(way.z) + 0.6F;
  return glm::normalize(way);
}

Vec3 warm(Random& random, double strength) {
  return static_cast<float>(strength) * Vec3(1.0F, random.uniform(0.6, 1.0), random.uniform(0.4, 1.0));
}

/// A light from somewhere in front on the objects, everything locked.
Light locked_light(const CaseScene& scene, const std::string& name, double strength, Random& random) {
  Light light = scene.prototype;
  light.name = name;
  const Vec3 aim = scene.middle + 0.15F * scene.reach * random.direction();
  const Vec3 position = scene.middle + scene.reach * static_cast<float>(random.uniform(0.8, 1.3)) * front(random);
  light.params.set_vec3(param(light, "position"), position);
  light.params.set_vec3(param(light, "direction"), glm::normalize(aim - position));
  light.params.set_vec3(param(light, "color"), warm(random, strength));
  light.params.set_vec3(param(light, "barn"), Vec3(random.uniform(0.5, 0.9), random.uniform(0.5, 0.9), 0.1));
  light.params.set_param_locked(-1, true);
  return light;
}

void unlock(ParamState& state, std::size_t light, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    state.rig.lights[light].params.set_param_locked(param(state.rig.lights[light], name), false);
  }
}

/// What a case is made from: the lights, their picture, an unpainted target.
struct Draft {
  const CaseScene& scene;
  KnownCase made;

  Draft(const CaseScene& in, Cause cause, Random& random) : scene(in), made{"", in.empty, {}, cause} {
    ParamBlock& ambient = made.start.rig.ambient;
    ambient.set_vec3(*ambient.schema().by_role("color"), Vec3(static_cast<float>(random.uniform(0.02, 0.06))));
    made.start.rig.lights = {locked_light(in, "key", random.uniform(0.6, 1.1), random),
                             locked_light(in, "fill", random.uniform(0.15, 0.3), random)};
  }
  Light& key() { return made.start.rig.lights[0]; }
  Light& fill() { return made.start.rig.lights[1]; }
  [[nodiscard]] Image picture(const ParamState& state) const { return scene.renderer->render(state).value(); }

  void begin(float unpainted = kUnpainted) {
    const SurfaceBuffer& surface = scene.renderer->surface();
    made.target.before = picture(made.start);
    made.target.color = made.target.before;
    made.target.importance = Image(surface.width, surface.height, 1, unpainted);
    made.target.stroke.assign(surface.pixels(), 0);
  }

  /// A round stroke on one object where `wanted` holds; `color` says what is painted. False if that is next to nothing.
  template <class Wanted, class Color>
  bool paint(std::uint32_t stroke, Random& random, const Wanted& wanted, const Color& color) {
    const SurfaceBuffer& surface = scene.renderer->surface();
    std::vector<std::uint32_t> candidates;
    for (std::uint32_t i = 0; i < surface.pixels(); ++i) {
      const bool object =
          std::find(scene.objects.begin(), scene.objects.end(), surface.object[i]) != scene.objects.end();
      if (object && made.target.stroke[i] == 0 && wanted(i)) candidates.push_back(i);
    }
    if (candidates.size() < kLeastPixels) return false;
    const std::uint32_t centre =
        candidates[static_cast<std::size_t>(random.index(static_cast<int>(candidates.size())))];
    const auto x = static_cast<int>(centre) % surface.width;
    const auto y = static_cast<int>(centre) / surface.width;
    const double radius = surface.height * random.uniform(0.1, 0.16);
    std::size_t pixels = 0;
    double wish = 0.0;
    for (const std::uint32_t i : candidates) {
      const double across = static_cast<int>(i) % surface.width - x;
      const double down = static_cast<int>(i) / surface.width - y;
      if (across * across + down * down > radius * radius || surface.object[i] != surface.object[centre]) continue;
      const Vec3 before = made.target.before.rgb(i);
      const Vec3 now = color(i, before);
      made.target.color.set_rgb(i, now);
      made.target.importance.data[i] = 1.0F;
      made.target.stroke[i] = stroke;
      wish += glm::distance(now, before);
      ++pixels;
    }
    return pixels >= kLeastPixels && wish / static_cast<double>(pixels) >= kLeastWish;
  }

  [[nodiscard]] float facing(const Light& light, std::uint32_t i) const {
    const SurfaceBuffer& surface = scene.renderer->surface();
    const Vec3 way = light.params.vec3(param(light, "position")) - surface.position[i];
    return glm::dot(surface.normal[i], glm::normalize(way));
  }
  /// How much of the picture is one light's.
  [[nodiscard]] Image part(std::size_t light) const {
    ParamState without = made.start;
    without.rig.lights[light].muted = true;
    Image part = picture(made.start);
    const Image rest = picture(without);
    for (std::size_t k = 0; k < part.data.size(); ++k) part.data[k] -= rest.data[k];
    return part;
  }
};

float most(const Vec3& v) {
  return std::max({v.x, v.y, v.z});
}

/// The picture of other settings of what is free: painted wherever it differs.
bool reachable(Draft& draft, Random& random, bool far) {
  unlock(draft.made.start, 0, {"color", "direction", "barn"});
  if (far) unlock(draft.made.start, 0, {"position"});
  ParamState wanted = draft.made.start;
  ParamBlock& key = wanted.rig.lights[0].params;
  const float size = far ? 2.0F : 1.0F;
  const Vec3 factor(random.uniform(0.5, 1.8), random.uniform(0.5, 1.8), random.uniform(0.5, 1.8));
  key.set_vec3(param(wanted.rig.lights[0], "color"), factor * key.vec3(param(wanted.rig.lights[0], "color")));
  const int direction = param(wanted.rig.lights[0], "direction");
  key.set_vec3(direction, glm::normalize(key.vec3(direction) + 0.05F * size * random.direction()));
  draft.begin();
  const Image picture = draft.picture(wanted);
  double wish = 0.0;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < picture.pixels(); ++i) {
    const double change = glm::distance(picture.rgb(i), draft.made.target.before.rgb(i));
    draft.made.target.color.set_rgb(i, picture.rgb(i));
    if (change < 0.01) continue;
    draft.made.target.stroke[i] = 1;
    draft.made.target.importance.data[i] = 1.0F;
    wish += change;
    ++pixels;
  }
  draft.made.reachable = true;
  return pixels >= kLeastPixels && wish / static_cast<double>(pixels) >= kLeastWish;
}

bool faces_away(Draft& draft, Random& random) {
  Vec3 behind = front(random);
  behind = Vec3(behind.x, 0.3F * behind.y, -behind.z);
  const Vec3 position = draft.scene.middle + draft.scene.reach * glm::normalize(behind);
  draft.key().params.set_vec3(param(draft.key(), "position"), position);
  draft.key().params.set_vec3(param(draft.key(), "direction"), glm::normalize(draft.scene.middle - position));
  unlock(draft.made.start, 0, {"color", "direction", "barn"});
  draft.begin();
  const Vec3 tint = warm(random, random.uniform(0.4, 0.8));
  const SurfaceBuffer& surface = draft.scene.renderer->surface();
  return draft.paint(
      1, random, [&](std::uint32_t i) { return draft.facing(draft.key(), i) < -0.05F; },
      [&](std::uint32_t i, const Vec3& before) { return before + tint * surface.albedo[i]; });
}

bool too_dark(Draft& draft, Random& random) {
  const bool by_ambient = random.uniform() < 0.5;
  ParamBlock& ambient = draft.made.start.rig.ambient;
  if (by_ambient) {
    ambient.set_vec3(*ambient.schema().by_role("color"), Vec3(static_cast<float>(random.uniform(0.3, 0.5))));
  } else {
    draft.fill().params.set_vec3(param(draft.fill(), "color"), warm(random, random.uniform(0.7, 1.0)));
  }
  unlock(draft.made.start, 0, {"color", "direction", "barn", "position"});
  draft.begin();
  const Image key = draft.part(0);
  const auto locked = static_cast<float>(random.uniform(0.0, 0.35));
  return draft.paint(
      1, random,
      [&](std::uint32_t i) {
        const Vec3 before = draft.made.target.before.rgb(i);
        return most(before - key.rgb(i)) > 0.15F && most(key.rgb(i)) < 0.2F * most(before);
      },
      [&](std::uint32_t i, const Vec3& before) { return locked * (before - key.rgb(i)); });
}

bool locked_parameter(Draft& draft, Random& random) {
  ParamState wanted = draft.made.start;
  const int which = random.index(4);
  const std::size_t light = which == 3 ? 1 : 0;
  if (which == 0) {  // its colour, with only what does not brighten free
    unlock(draft.made.start, 0, {"shadow_density", "barn"});
  } else if (which == 1) {  // its barn, which keeps it from where the paint is
    draft.key().params.set_vec3(param(draft.key(), "barn"), Vec3(0.12F, 0.12F, 0.05F));
    unlock(draft.made.start, 0, {"color", "falloff_exponent"});
  } else if (which == 2) {  // its direction: it looks elsewhere
    const int direction = param(draft.key(), "direction");
    draft.key().params.set_vec3(param(draft.key(), "barn"), Vec3(0.25F, 0.25F, 0.05F));
    wanted = draft.made.start;
    draft.key().params.set_vec3(direction,
                                glm::normalize(draft.key().params.vec3(direction) + 0.9F * random.direction()));
    unlock(draft.made.start, 0, {"color", "falloff_exponent"});
  } else {  // another light's colour; the free light looks elsewhere and may not turn
    draft.key().params.set_vec3(param(draft.key(), "barn"), Vec3(0.06F, 0.06F, 0.02F));
    unlock(draft.made.start, 0, {"color", "falloff_exponent"});
    wanted = draft.made.start;
  }
  if (which == 0 || which == 3) {
    ParamBlock& params = wanted.rig.lights[light].params;
    const int color = param(wanted.rig.lights[light], "color");
    params.set_vec3(color, static_cast<float>(random.uniform(2.2, 3.5)) * params.vec3(color));
  }
  draft.begin(0.02F);
  const Image picture = draft.picture(wanted);
  return draft.paint(
      1, random, [&](std::uint32_t i) { return most(picture.rgb(i) - draft.made.target.before.rgb(i)) > 0.08F; },
      [&](std::uint32_t i, const Vec3&) { return picture.rgb(i); });
}

/// One light's colour, wanted red here and blue there.
bool strokes_disagree(Draft& draft, Random& random) {
  unlock(draft.made.start, 0, {"color"});
  draft.begin(0.01F);
  const Image key = draft.part(0);
  const Vec3 one(random.uniform(1.6, 2.4), random.uniform(0.2, 0.5), random.uniform(0.1, 0.4));
  const Vec3 other(random.uniform(0.1, 0.4), random.uniform(0.5, 1.0), random.uniform(1.6, 2.4));
  const auto lit = [&](std::uint32_t i) { return most(key.rgb(i)) > 0.15F; };
  draft.made.reachable = true;
  for (const std::uint32_t stroke : {1U, 2U}) {
    const Vec3 factor = stroke == 1 ? one : other;
    const bool painted = draft.paint(stroke, random, lit, [&](std::uint32_t i, const Vec3& before) {
      return before + (factor - 1.0F) * key.rgb(i);
    });
    if (!painted) return false;
  }
  return true;
}

/// A pool of another colour where the lights at hand are wanted as they are.
bool needs_light(Draft& draft, Random& random) {
  ParamState wanted = draft.made.start;
  Light third = locked_light(draft.scene, "third", 1.0, random);
  third.params.set_vec3(param(third, "color"), Vec3(0.1F, random.uniform(0.3, 0.8), random.uniform(1.2, 2.0)));
  third.params.set_vec3(param(third, "barn"), Vec3(random.uniform(0.12, 0.25), random.uniform(0.12, 0.25), 0.1));
  wanted.rig.lights.push_back(std::move(third));
  unlock(draft.made.start, 0, {"shadow_density", "falloff_exponent"});
  if (random.uniform() < 0.5) unlock(draft.made.start, 0, {"color"});
  draft.begin(0.4F);
  const Image picture = draft.picture(wanted);
  return draft.paint(
      1, random, [&](std::uint32_t i) { return most(picture.rgb(i) - draft.made.target.before.rgb(i)) > 0.15F; },
      [&](std::uint32_t i, const Vec3&) { return picture.rgb(i); });
}

}  // namespace

std::optional<KnownCase> make_case(const CaseScene& scene, Cause cause, Random& random) {
  Draft draft(scene, cause, random);
  bool made = false;
  switch (cause) {
    case Cause::kNone:
      draft.made.steps = kPatientSteps;
      made = reachable(draft, random, false);
      break;
    case Cause::kSearchEnded:
      draft.made.steps = 1;
      made = reachable(draft, random, random.uniform() < 0.5);
      break;
    case Cause::kFacesAway:
      made = faces_away(draft, random);
      break;
    case Cause::kTooDark:
      made = too_dark(draft, random);
      break;
    case Cause::kLockedParameter:
      made = locked_parameter(draft, random);
      break;
    case Cause::kStrokesDisagree:
      made = strokes_disagree(draft, random);
      break;
    case Cause::kNeedsLight:
      made = needs_light(draft, random);
      break;
    default:
      break;
  }
  if (!made) return std::nullopt;
  return std::move(draft.made);
}

}  // namespace luminist
