#include "bench/hidden_light.h"

#include <algorithm>

namespace luminist {
namespace {

Vec3 visible_place(const SurfaceBuffer& surface, Random& random) {
  while (true) {
    const auto pixel = static_cast<std::size_t>(random.uniform() * static_cast<double>(surface.pixels()));
    if (surface.object[pixel] != 0) return surface.position[pixel];
  }
}

/// A number of a parameter, written in the manifest's units.
void write(Light& light, const SceneFrame& frame, const char* name, int component, double value) {
  const ParamSchema& schema = light.params.schema();
  const int param = schema.find(name).value();
  light.params.set(param, component, schema[param].stored(component, value, frame));
}

void draw(Light& light, const SurfaceBuffer& surface, const SceneFrame& frame, Random& random) {
  const Vec3 aim = visible_place(surface, random);
  const Vec3 to_eye = glm::normalize(surface.eye - aim);
  Vec3 from = random.direction();
  while (glm::dot(from, to_eye) < 0.0F || from.y < 0.05F) from = random.direction();
  const double distance = random.uniform(1.0, 3.0);  // scene radii, as all lengths below
  const Vec3 place = aim + static_cast<float>(distance * frame.radius) * from;
  const ParamSchema& schema = light.params.schema();
  light.params.set_vec3(schema.find("position").value(), place);
  light.params.set_vec3(schema.find("direction").value(), -from);
  for (int c = 0; c < 3; ++c) write(light, frame, "color", c, random.uniform(0.2, 2.0));
  write(light, frame, "near_cutoff", 0, random.uniform(0.0, 0.5) * distance);
  write(light, frame, "near_cutoff", 1, random.uniform(0.05, 0.5) * distance);
  write(light, frame, "far_cutoff", 0, random.uniform(1.0, 3.0) * distance);
  write(light, frame, "far_cutoff", 1, random.uniform(0.2, 2.0) * distance);
  write(light, frame, "falloff_exponent", 0, random.uniform(0.0, 2.5));
  write(light, frame, "falloff_distance", 0, distance);
  for (int c = 0; c < 2; ++c) write(light, frame, "barn", c, random.uniform(0.1, 0.8));
  write(light, frame, "barn", 2, random.uniform(0.02, 0.4));
  write(light, frame, "shadow_density", 0, random.uniform(0.3, 1.0));
}

/// The share of the picture that is painted; writes importance and strokes.
double paint(Target& target, float nu) {
  std::vector<float> added(target.color.pixels());
  float peak = 0.0F;
  for (std::size_t i = 0; i < added.size(); ++i) {
    const Vec3 change = target.color.rgb(i) - target.before.rgb(i);
    added[i] = change.x + change.y + change.z;
    peak = std::max(peak, added[i]);
  }
  std::size_t painted = 0;
  target.importance = Image(target.color.width, target.color.height, 1, nu);
  target.stroke.assign(added.size(), 0);
  for (std::size_t i = 0; i < added.size(); ++i) {
    if (!(peak > 0.0F) || added[i] <= 0.05F * peak) continue;
    target.importance.data[i] = 1.0F;
    target.stroke[i] = 1;
    ++painted;
  }
  return static_cast<double>(painted) / static_cast<double>(added.size());
}

}  // namespace

Result<Light> free_cinematic(const LightTypes& types, const std::string& name, const SceneFrame& frame) {
  LUM_TRY(Light light, make_light(types, "cinematic", name, frame));
  const ParamSchema& schema = light.params.schema();
  for (int param = 0; param < schema.size(); ++param) {
    light.params.set_param_locked(param, schema[param].name == "shadow_softness");
  }
  return light;
}

Result<HiddenTask> hidden_task(Renderer& renderer, const LightTypes& types, const ParamState& before, float nu,
                               std::uint64_t seed) {
  constexpr int kDraws = 1000;
  constexpr double kLeastLit = 0.1;
  Random random(seed);
  LUM_TRY(const Light fresh, free_cinematic(types, "hidden", renderer.frame()));
  HiddenTask task{fresh, {}, 0.0};
  LUM_TRY(task.target.before, renderer.render(before));
  for (int i = 0; i < kDraws; ++i) {
    task.hidden = fresh;
    draw(task.hidden, renderer.surface(), renderer.frame(), random);
    ParamState lit = before;
    lit.rig.lights.push_back(task.hidden);
    LUM_TRY(task.target.color, renderer.render(lit));
    task.lit = paint(task.target, nu);
    if (task.lit >= kLeastLit) return task;
  }
  return Error{ErrorKind::kLimit, "no random light lit a tenth of the picture", "", "scene", ""};
}

}  // namespace luminist
