// The actions of a script on the lights of the rig.
#include <cmath>

#include "studio/light_kinds.h"
#include "studio/light_list.h"
#include "studio/script_runner.h"

namespace luminist {

Result<void> ScriptRunner::add_light(const Action& action) {
  NewLight light;
  LUM_TRY(const auto type, action.text("type"));
  LUM_TRY(const auto name, action.text("name"));
  LUM_TRY(const auto group, action.text("group"));
  LUM_TRY(const auto from_paint, action.flag("from_paint"));
  LUM_TRY(const auto lock_others, action.flag("lock_others"));
  LUM_TRY(const auto dark, action.flag("dark"));
  light.type = type.value_or(light.type);
  light.name = name.value_or(light.name);
  light.group = group.value_or("");
  light.from_paint = from_paint.value_or(true);
  light.lock_others = lock_others.value_or(true);
  light.dark = dark.value_or(false);
  LUM_TRY(const auto count, action.number("count"));
  if (is_any_kind(light.type)) {
    if (count) return action.wrong("one light at a time is added of any kind", "count");
    LUM_TRY_VOID(add_light_of_any_kind(*session_, light, {}, events_.watch));
    return {};
  }
  if (count) {
    if (!(*count >= 1.0 && *count <= 64.0 && *count == std::floor(*count))) {
      return action.wrong("a whole number from 1 to 64 is wanted", "count");
    }
    LUM_TRY_VOID(session_->add_lights(static_cast<int>(*count), light));
    return {};
  }
  LUM_TRY_VOID(session_->add_light(light));
  return {};
}

Result<void> ScriptRunner::remove_light(const Action& action) {
  LUM_TRY(const std::string light, action.needed_text("light"));
  return session_->remove_light(light);
}

Result<void> ScriptRunner::mute(const Action& action) {
  LUM_TRY(const std::vector<std::string> lights, action.texts("light"));
  if (lights.empty()) return action.wrong("\"mute\" needs this field", "light");
  LUM_TRY(const auto muted, action.flag("muted"));
  return session_->light_list().mute(lights, muted.value_or(true));
}

Result<void> ScriptRunner::rename_light(const Action& action) {
  LUM_TRY(const std::string light, action.needed_text("light"));
  LUM_TRY(const std::string name, action.needed_text("name"));
  return session_->light_list().rename(light, name);
}

Result<void> ScriptRunner::duplicate_light(const Action& action) {
  LUM_TRY(const std::string light, action.needed_text("light"));
  LUM_TRY(const auto name, action.text("name"));
  LUM_TRY_VOID(session_->light_list().duplicate(light, name.value_or("")));
  return {};
}

Result<void> ScriptRunner::group_lights(const Action& action) {
  LUM_TRY(const std::vector<std::string> lights, action.texts("lights"));
  if (lights.empty()) return action.wrong("\"group_lights\" needs this field", "lights");
  LUM_TRY(const auto group, action.text("group"));
  return session_->light_list().group(lights, group.value_or(""));
}

Result<void> ScriptRunner::link_light(const Action& action) {
  LUM_TRY(const std::string light, action.needed_text("light"));
  LUM_TRY(const std::vector<std::string> objects, action.texts("objects"));
  return session_->link_light(light, objects);
}

Result<void> ScriptRunner::share_shadows(const Action& action) {
  LUM_TRY(const std::string light, action.needed_text("light"));
  return session_->share_shadows(light);
}

Result<void> ScriptRunner::load_rig(const Action& action) {
  LUM_TRY(const std::string rig, action.needed_text("rig"));
  return session_->load_rig(rig, folder_);
}

}  // namespace luminist
