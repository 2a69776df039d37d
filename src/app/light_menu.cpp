// What can be chosen for a light: its objects, its group, its end.
#include "app/icons.h"
#include "app/light_rows.h"
#include "app/lights_panel.h"
#include "rig/light_links.h"
#include "studio/exploration.h"
#include "studio/light_list.h"

namespace luminist {
namespace {

void link(Desk& desk, const std::string& light, std::vector<std::string> objects) {
  desk.studio->change(
      "link a light", [light, objects](Session& session) { return session.link_light(light, objects); },
      Workbench::After::kFollow);
}

void group(Desk& desk, const std::string& light, const std::string& wanted) {
  desk.studio->change("group lights",
                      [light, wanted](Session& session) { return session.light_list().group({light}, wanted); });
}

}  // namespace

void link_choices(Desk& desk, const Light& light) {
  const auto objects = std::span(desk.now->facts->surface.object_names).subspan(1);
  if (ImGui::Selectable("everything", light.objects.empty())) link(desk, light.name, {});
  tip(desk.theme, "The light lights all objects. Shadows are never linked: what stands in its way still does.");
  ImGui::Separator();
  int number = 0;
  for (const std::string& object : objects) {
    ImGui::PushID(number++);
    bool lit = lights_object(light, object);
    if (ImGui::Checkbox(object.c_str(), &lit)) link(desk, light.name, toggled_link(light, objects, object));
    tip(desk.theme, "Whether this light lights this object. The last one stays: mute the light instead.");
    ImGui::PopID();
  }
}

void group_choices(Desk& desk, const Light& light) {
  const LightRig& rig = desk.now->shown->rig;
  if (ImGui::Selectable("none", light.group.empty()) && !light.group.empty()) group(desk, light.name, "");
  tip(desk.theme, "Takes the light out of its group.");
  for (const std::string& name : group_names(rig)) {
    ImGui::PushID(name.c_str());
    if (ImGui::Selectable(name.c_str(), light.group == name)) group(desk, light.name, name);
    tip(desk.theme, "Puts the light into this group.");
    ImGui::PopID();
  }
  ImGui::Separator();
  if (ImGui::Selectable("a new group")) group(desk, light.name, unused_group(rig));
  tip(desk.theme, "The menu of its heading names it. Lights of a group named \"key\" are their objects' keys.");
}

void removal_choices(Desk& desk, const Light& light) {
  const std::string name = light.name;
  if (ImGui::MenuItem("Remove it")) {
    desk.studio->change(
        "remove a light", [name](Session& session) { return session.remove_light(name); }, Workbench::After::kFollow);
  }
  if (ImGui::MenuItem("Remove it; the others make up for it", nullptr, false, desk.now->shown->rig.lights.size() > 1)) {
    desk.studio->change("remove a light", [name](Session& session) -> Result<void> {
      LUM_TRY_VOID(start_removal(session, name, SolveOptions{}));
      return {};
    });
  }
}

void begin_linking(Desk& desk, const Light& light) {
  desk.linking = light.name;
  desk.orbit = false;
}

}  // namespace luminist
