#include "app/shots_panel.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/icons.h"
#include "params/param_text.h"

namespace luminist {
namespace {

constexpr float kPictureHeight = 54.0F;  // points

bool button(const Desk& desk, const char* label, const char* words, float width = 0.0F) {
  const bool clicked = ImGui::Button(label, {width, 0.0F});
  tip(desk.theme, words);
  return clicked;
}

/// The nearest frame of a list before or after one; nothing if there is none.
std::optional<double> neighbour(const std::vector<double>& frames, double frame, bool after) {
  std::optional<double> found;
  for (const double each : frames) {
    if (after ? each <= frame : each >= frame) continue;
    if (!found || std::abs(each - frame) < std::abs(*found - frame)) found = each;
  }
  return found;
}

bool tab(const char* label, bool chosen) {
  ImGui::PushStyleColor(ImGuiCol_Text, chosen ? paint_colors::kAccent : paint_colors::kText);
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(chosen ? ImGuiCol_Button : ImGuiCol_WindowBg));
  const bool clicked = ImGui::Button(label);
  ImGui::PopStyleColor(2);
  return clicked;
}

}  // namespace

bool shots_shown(const Desk& desk) {
  if (!desk.has_shot() || !desk.now->frames || desk.orbit) return false;
  if (desk.show_shots) return *desk.show_shots;
  const FrameFacts& facts = *desk.now->frames;
  return facts.moving || facts.painted.size() > 1 || !desk.now->shown->rig.keys.empty();
}

void ShotsPanel::want(Desk& desk, int pictures) {
  if (pictures == wanted_pictures_ && every_ == wanted_every_) return;
  wanted_pictures_ = pictures;
  wanted_every_ = every_;
  desk.studio->want_strip(pictures, every_);
}

void ShotsPanel::hide(Desk& desk) {
  if (wanted_pictures_ != 0) want(desk, 0);
}

void ShotsPanel::toolbar(Desk& desk, const FrameFacts& facts) {
  const double frame = head_.value_or(facts.frame);
  const std::vector<double> keys = key_frames(desk.now->shown->rig, desk.selected.empty()        ? "*"
                                                                    : desk.selected == "ambient" ? ""
                                                                                                 : desk.selected);
  const auto go = [&](std::optional<double> to) {
    if (to) desk.studio->go_to(*to);
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {desk.theme.px(3.0F), desk.theme.px(4.0F)});
  if (button(desk, "|<", "To the first frame")) go(facts.first);
  ImGui::SameLine();
  if (button(desk, "<", "One frame back")) go(std::ceil(frame) - 1.0);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(desk.theme.px(64.0F));
  auto typed = static_cast<float>(frame);
  ImGui::InputFloat("##frame", &typed, 0.0F, 0.0F, "%g");
  if (ImGui::IsItemDeactivatedAfterEdit()) go(static_cast<double>(typed));
  tip(desk.theme,
      "The frame that is looked at. What moves and the keyed lights are as they are then; its paint stays "
      "with it.");
  ImGui::SameLine();
  if (button(desk, ">", "One frame on")) go(std::floor(frame) + 1.0);
  ImGui::SameLine();
  if (button(desk, ">|", "To the last frame")) go(facts.last);
  ImGui::SameLine(0.0F, desk.theme.px(10.0F));
  if (button(desk, "< key", "To the key before: of the selected light, or of any")) go(neighbour(keys, frame, false));
  ImGui::SameLine();
  if (button(desk, "key >", "To the next key: of the selected light, or of any")) go(neighbour(keys, frame, true));
  ImGui::PopStyleVar();
  ImGui::SameLine(0.0F, desk.theme.px(10.0F));
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%.2f s", frame / facts.fps);
  tip(desk.theme, fmt::format("{:g} frames a second, frames {} to {}", facts.fps, facts.first, facts.last).c_str());
  const float side = ImGui::GetFrameHeight();
  ImGui::SameLine(ImGui::GetContentRegionMax().x - desk.theme.px(148.0F) - side);
  const bool together = together_shown(desk, facts);
  if (tab("Keys", !together)) together_ = false;
  tip(desk.theme, "Keys of the selected light over the frames");
  ImGui::SameLine(0.0F, desk.theme.px(2.0F));
  if (tab("Solve together", together)) together_ = true;
  tip(desk.theme, "One rig for what is painted on several frames or through several cameras");
  ImGui::SameLine(0.0F, desk.theme.px(6.0F));
  if (button(desk, "x", "Hide this panel; the View menu brings it back", side)) desk.show_shots = false;
}

bool ShotsPanel::together_shown(const Desk& desk, const FrameFacts& facts) const {
  if (together_) return *together_;
  const bool in_time = facts.moving || !desk.now->shown->rig.keys.empty();
  return !in_time && facts.several_cameras();
}

void ShotsPanel::refresh_strip(const Desk& desk, const FrameFacts& facts) {
  const bool same = textured_ && display_ == desk.display && textured_->strip.size() == facts.strip.size() &&
                    std::equal(facts.strip.begin(), facts.strip.end(), textured_->strip.begin(),
                               [](const auto& a, const auto& b) { return a.picture == b.picture; });
  textured_ = desk.now->frames;
  if (same) return;
  display_ = desk.display;
  textures_.clear();
  const DisplayTable table(desk.display);
  for (const FramePicture& each : facts.strip) {
    std::vector<std::uint32_t> codes(each.picture->pixels());
    to_display(*each.picture, table, codes);
    textures_.push_back(std::make_unique<PictureTexture>());
    textures_.back()->upload(codes, each.picture->width, each.picture->height);
    textures_.back()->filter(0.5F);
  }
}

void ShotsPanel::strip(Desk& desk, const FrameFacts& facts) {
  const Theme& theme = desk.theme;
  const Shot& shot = desk.now->facts->shot;
  const float height = theme.px(kPictureHeight);
  const float width =
      std::max(1.0F, std::floor(height * static_cast<float>(shot.width) / static_cast<float>(shot.height)));
  const float gap = theme.px(4.0F);
  const float controls = theme.px(64.0F);
  const float room = ImGui::GetContentRegionAvail().x - controls;
  const int fitting = std::clamp(static_cast<int>((room + gap) / (width + gap)), 1, 15);
  const int pictures = fitting % 2 == 1 ? fitting : fitting - 1;
  want(desk, pictures);
  refresh_strip(desk, facts);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  float x = at.x + 0.5F * (room - static_cast<float>(pictures) * (width + gap) + gap);
  const int before = std::min(pictures / 2, static_cast<int>(std::max(facts.frame, 0.0)) / every_);
  for (int k = -before; k < pictures - before; ++k, x += width + gap) {
    const double frame = facts.frame + k * every_;
    const ImVec2 hi(x + width, at.y + height);
    const auto found = std::find_if(facts.strip.begin(), facts.strip.end(),
                                    [&](const FramePicture& each) { return each.frame == frame; });
    if (found != facts.strip.end()) {
      const auto i = static_cast<std::size_t>(found - facts.strip.begin());
      list.AddImage(textures_[i]->id(), {x, at.y}, hi, {0, 0}, {1, 1},
                    found->old ? IM_COL32(255, 255, 255, 120) : IM_COL32(255, 255, 255, 255));
    } else {
      list.AddRectFilled({x, at.y}, hi, IM_COL32(32, 32, 32, 255));
    }
    list.AddRect({x - 1.0F, at.y - 1.0F}, {hi.x + 1.0F, hi.y + 1.0F},
                 k == 0 ? paint_colors::kAccent : IM_COL32(24, 24, 24, 255), 0.0F, 0, theme.px(k == 0 ? 2.0F : 1.0F));
    ImGui::PushFont(theme.small);
    const std::string number = number_text(frame);
    list.AddText({x + theme.px(4.0F), hi.y - theme.px(15.0F)}, IM_COL32(0, 0, 0, 220), number.c_str());
    list.AddText({x + theme.px(3.0F), hi.y - theme.px(16.0F)}, paint_colors::kText, number.c_str());
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({x, at.y});
    ImGui::PushID(k);
    if (ImGui::InvisibleButton("frame", {width, height})) desk.studio->go_to(frame);
    tip(theme,
        "The shot at this frame under the lights shown; in a path-traced style quickly made, of few paths. Click to go "
        "there.");
    ImGui::PopID();
  }
  ImGui::SetCursorScreenPos({at.x + room + theme.px(6.0F), at.y + 0.5F * (height - ImGui::GetFrameHeight())});
  ImGui::SetNextItemWidth(controls - theme.px(6.0F));
  ImGui::DragInt("##every", &every_, 0.05F, 1, 48, "every %d", ImGuiSliderFlags_AlwaysClamp);
  tip(theme, "Frames from one small picture to the next. They are made when there is nothing else to do.");
  ImGui::SetCursorScreenPos({at.x, at.y + height + theme.px(6.0F)});
  ImGui::Dummy({0.0F, 0.0F});
}

void ShotsPanel::draw(Desk& desk) {
  const FrameFacts& facts = *desk.now->frames;
  if (head_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left) && facts.frame == *head_) head_.reset();
  toolbar(desk, facts);
  if (together_shown(desk, facts)) return this->together(desk, facts);
  strip(desk, facts);
  timeline(desk, facts);
}

}  // namespace luminist
