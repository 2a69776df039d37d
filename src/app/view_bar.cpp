#include <fmt/format.h>

#include "app/icons.h"
#include "app/panels.h"

namespace luminist {
namespace {

/// Words that are buttons; the chosen one in the accent.
bool word(const Desk& desk, const char* text, bool chosen, const char* words) {
  ImGui::PushStyleColor(ImGuiCol_Text, chosen ? paint_colors::kAccent : paint_colors::kText);
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(chosen ? ImGuiCol_Button : ImGuiCol_WindowBg));
  const bool clicked = ImGui::Button(text);
  ImGui::PopStyleColor(2);
  tip(desk.theme, words);
  return clicked;
}

void channels(Desk& desk) {
  const float gap = desk.theme.px(2.0F);
  static constexpr std::array<std::pair<Channel, Deed>, 4> usual = {{{Channel::kLight, Deed::kViewLight},
                                                                     {Channel::kPaint, Deed::kViewPaint},
                                                                     {Channel::kResidual, Deed::kViewResidual},
                                                                     {Channel::kImportance, Deed::kViewImportance}}};
  for (const auto& [channel, deed] : usual) {
    const ChannelFacts& facts = facts_of(channel);
    if (word(desk, facts.name, !desk.wipe && !desk.orbit && desk.channel == channel,
             desk.with_key(facts.doc, deed).c_str())) {
      perform(desk, deed);
    }
    ImGui::SameLine(0.0F, gap);
  }
  if (word(desk, "Wipe", desk.wipe, desk.with_key("Paint left of a line, light right of it", Deed::kWipe).c_str())) {
    perform(desk, Deed::kWipe);
  }
  ImGui::SameLine(0.0F, gap);
  if (word(desk, "Orbit", desk.orbit, desk.with_key("The shot from anywhere, with its lights", Deed::kOrbit).c_str())) {
    perform(desk, Deed::kOrbit);
  }
  ImGui::SameLine(0.0F, gap);
  const bool other = !desk.wipe && static_cast<int>(desk.channel) >= static_cast<int>(Channel::kAlbedo);
  ImGui::SetNextItemWidth(desk.theme.px(84.0F));
  if (ImGui::BeginCombo("##channel", other ? facts_of(desk.channel).name : "More")) {
    for (int i = static_cast<int>(Channel::kAlbedo); i < kChannels; ++i) {
      const auto channel = static_cast<Channel>(i);
      if (ImGui::Selectable(facts_of(channel).name, other && desk.channel == channel)) {
        desk.channel = channel;
        desk.wipe = desk.orbit = false;
      }
      tip(desk.theme, facts_of(channel).doc);
    }
    ImGui::EndCombo();
  }
}

void exposure(Desk& desk) {
  const Theme& theme = desk.theme;
  ImGui::SetNextItemWidth(theme.px(84.0F));
  ImGui::SliderFloat("##exposure", &desk.display.exposure, -6.0F, 6.0F, "%+.1f stops");
  tip(theme, "Exposure of the view; the lights stay as they are. Double click: 0.");
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) desk.display.exposure = 0.0F;
  ImGui::SameLine(0.0F, theme.px(4.0F));
  ImGui::SetNextItemWidth(theme.px(100.0F));
  int transform = static_cast<int>(desk.display.transform);
  const auto names = view_transform_names();
  if (ImGui::BeginCombo("##transform", names[static_cast<std::size_t>(transform)].c_str())) {
    for (int i = 0; i < static_cast<int>(names.size()); ++i) {
      if (ImGui::Selectable(names[static_cast<std::size_t>(i)].c_str(), i == transform)) transform = i;
    }
    ImGui::EndCombo();
  }
  tip(theme,
      "How light becomes screen colours. Standard clips at 1; soft highlights keep their form; raw is for data.");
  desk.display.transform = static_cast<ViewTransform>(transform);
}

}  // namespace

void view_bar(Desk& desk) {
  channels(desk);
  const float width = desk.theme.px(190.0F);
  ImGui::SameLine(std::max(ImGui::GetContentRegionMax().x - width, desk.theme.px(60.0F)));
  exposure(desk);
}

}  // namespace luminist
