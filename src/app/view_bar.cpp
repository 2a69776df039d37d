#include <array>

#include "app/icons.h"
#include "app/panels.h"
#include "app/value_slider.h"

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

constexpr std::array<std::pair<Channel, Deed>, 4> kUsual = {{{Channel::kLight, Deed::kViewLight},
                                                             {Channel::kPaint, Deed::kViewPaint},
                                                             {Channel::kResidual, Deed::kViewResidual},
                                                             {Channel::kImportance, Deed::kViewImportance}}};

/// Channels from `first` on, as a list; the present one is its title if it is among them.
void channel_list(Desk& desk, int first, const char* title, float width) {
  const bool other = !desk.wipe && !desk.orbit && static_cast<int>(desk.channel) >= first;
  ImGui::SetNextItemWidth(width);
  if (ImGui::BeginCombo("##channel", other ? facts_of(desk.channel).name : title, ImGuiComboFlags_HeightLarge)) {
    for (int i = first; i < kChannels; ++i) {
      const auto channel = static_cast<Channel>(i);
      if (ImGui::Selectable(facts_of(channel).name, other && desk.channel == channel)) {
        desk.channel = channel;
        desk.wipe = desk.orbit = false;
      }
      tip(desk.theme, facts_of(channel).doc);
    }
    ImGui::EndCombo();
  }
  tip(desk.theme, "What is shown of the shot.");
}

/// Pixels that the words of channels() take.
float words_width(const Desk& desk) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const auto of = [&](const char* text) { return ImGui::CalcTextSize(text).x + 2.0F * style.FramePadding.x; };
  float width = of("Wipe") + of("Orbit") + desk.theme.px(84.0F + 14.0F);
  for (const auto& [channel, deed] : kUsual) width += of(facts_of(channel).name);
  return width;
}

/// compact: all channels in one list, where there is no room for words.
void channels(Desk& desk, bool compact) {
  const float gap = desk.theme.px(2.0F);
  if (compact) {
    channel_list(desk, 0, "View", desk.theme.px(96.0F));
    ImGui::SameLine(0.0F, gap);
  }
  for (const auto& [channel, deed] : kUsual) {
    if (compact) break;
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
  if (compact) return;
  ImGui::SameLine(0.0F, gap);
  channel_list(desk, static_cast<int>(Channel::kAlbedo), "More", desk.theme.px(84.0F));
}

void exposure(Desk& desk, bool with_transform) {
  const Theme& theme = desk.theme;
  ImGui::SetNextItemWidth(theme.px(84.0F));
  value_slider("##exposure", &desk.display.exposure, -6.0F, 6.0F, "%+.1f stops");
  tip(theme, "Exposure of the view; the lights stay as they are. Double click: 0.");
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) desk.display.exposure = 0.0F;
  if (!with_transform) return;
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
  const float room = ImGui::GetContentRegionAvail().x;
  const float exposure_width = desk.theme.px(188.0F);
  const float gap = desk.theme.px(12.0F);
  const bool compact = words_width(desk) + gap + exposure_width > room;
  channels(desk, compact);
  // What remains decides how much of the display's settings there is.
  ImGui::SameLine();
  const float left = ImGui::GetContentRegionAvail().x;
  const bool both = left >= exposure_width;
  const float width = both ? exposure_width : desk.theme.px(84.0F);
  if (left < width) return ImGui::NewLine();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - width);
  exposure(desk, both);
}

}  // namespace luminist
