#include "explore/light_removal.h"

#include <utility>

#include <fmt/format.h>

#include "base/files.h"
#include "explore/locks.h"
#include "render/metric.h"
#include "solve/solve_session.h"

namespace luminist {
namespace {

Result<std::size_t> find_light(const LightRig& rig, const std::string& name) {
  std::vector<std::string> names;
  for (const Light& light : rig.lights) {
    if (light.name == name) return names.size();
    names.push_back(light.name);
  }
  const std::string near = nearest_name(name, names);
  std::string hint =
      names.empty() ? "there are no lights; give --rig" : fmt::format("there are: {}", fmt::join(names, ", "));
  if (!near.empty()) hint = fmt::format("did you mean \"{}\"?", near);
  return Error{ErrorKind::kUsage, fmt::format("there is no light \"{}\"", name), "", "light", hint};
}

/// What one light adds to a picture.
Image light_part(const Image& with, const Image& without) {
  Image part = with;
  for (std::size_t i = 0; i < part.data.size(); ++i) part.data[i] -= without.data[i];
  return part;
}

}  // namespace

ParamState without_light(const ParamState& state, std::size_t light) {
  ParamState result = state;
  remove_light(result.rig, state.rig.lights[light].name);
  return result;
}

Target kept_picture(const Image& picture) {
  Target target;
  target.color = picture;
  target.before = picture;
  target.importance = Image(picture.width, picture.height, 1, 1.0F);
  target.stroke.assign(picture.pixels(), 0);
  return target;
}

double black_error(const Target& target) {
  return picture_error(Image(target.color.width, target.color.height, 3, 0.0F), target, StyleMetric{});
}

Result<RemovalTask> removal_task(Renderer& renderer, const ParamState& state, const std::string& light, MakeUp who) {
  LUM_TRY(const std::size_t index, find_light(state.rig, light));
  if (state.rig.lights.size() == 1) {
    return Error{ErrorKind::kNothingToDo,
                 fmt::format("\"{}\" is the only light, so no other can make up for it", light), "", "light",
                 "add a light first, or mute this one"};
  }
  RemovalTask task{with_free_lights(without_light(state, index), who), {}, {}};
  if (auto free = check_free(task.start, renderer.frame()); !free) {
    Error error = std::move(free).error();
    error.hint = "unlock what may make up for the light";
    return error;
  }
  task.facts.light = light;
  LUM_TRY(const Image with, renderer.render(state));
  LUM_TRY(const Image without, renderer.render(task.start));
  task.target = kept_picture(with);
  task.facts.black = black_error(task.target);
  task.facts.epsilon = picture_error(without, task.target, renderer.style().metric);
  const RenderOptions unshadowed{.shadows = false};
  LUM_TRY(const Image lit_with, renderer.render(state, unshadowed));
  LUM_TRY(const Image lit_without, renderer.render(task.start, unshadowed));
  const Target part = kept_picture(light_part(with, without));
  const double all = black_error(part);
  if (all > 0.0) task.facts.shadow_share = picture_error(light_part(lit_with, lit_without), part, StyleMetric{}) / all;
  return task;
}

}  // namespace luminist
