#include "studio/light_list.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "rig/light_links.h"
#include "rig/light_list.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

}  // namespace

LightList Session::light_list() {
  return LightList(*this);
}

Result<void> LightList::rename(const std::string& light, const std::string& name) {
  ParamState next = session_->state_;
  LUM_TRY_VOID(rename_light(next.rig, light, name));
  return session_->commit_state(fmt::format("Rename {} to {}", light, name),
                                Json{{"do", "rename_light"}, {"light", light}, {"name", name}}.dump(), std::move(next));
}

Result<std::string> LightList::duplicate(const std::string& light, const std::string& name) {
  ParamState next = session_->state_;
  LUM_TRY(const std::string copy, duplicate_light(next.rig, light, name));
  LUM_TRY_VOID(session_->commit_state(fmt::format("Duplicate {} as {}", light, copy),
                                      Json{{"do", "duplicate_light"}, {"light", light}, {"name", copy}}.dump(),
                                      std::move(next)));
  return copy;
}

Result<void> LightList::group(const std::vector<std::string>& lights, const std::string& group) {
  ParamState next = session_->state_;
  LUM_TRY_VOID(group_lights(next.rig, lights, group));
  const std::string who = fmt::format("{}", fmt::join(lights, ", "));
  return session_->commit_state(group.empty() ? "Ungroup " + who : fmt::format("Group {} as {}", who, group),
                                Json{{"do", "group_lights"}, {"lights", lights}, {"group", group}}.dump(),
                                std::move(next));
}

Result<void> LightList::mute(const std::vector<std::string>& lights, bool muted) {
  ParamState next = session_->state_;
  for (const std::string& name : lights) {
    LUM_TRY(const std::vector<Light*> named, lights_named(next.rig, name));
    for (Light* light : named) light->muted = muted;
  }
  return session_->commit_state(fmt::format("{} {}", muted ? "Mute" : "Unmute", fmt::join(lights, ", ")),
                                Json{{"do", "mute"}, {"light", lights}, {"muted", muted}}.dump(), std::move(next));
}

}  // namespace luminist
