#include "app/tour.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/kept_sessions.h"

namespace luminist {
namespace {

constexpr std::array<const char*, 5> kSteps = {
    "Paint the light you want to see: drag over what shall shine. A light follows your brush.",
    "Paint more, or look at what you asked for: F2 shows the paint, F1 the light again.",
    "The lights are a proposal. Enter accepts them; then you paint on their picture.",
    "N adds a second light. It waits, dark, for the paint that says where it shines.",
    "Locks on the right keep what you like. Paint lists your strokes, to be changed and judged. ? shows all keys."};

bool has_label(const Desk& desk, const char* start) {
  const auto& labels = desk.now->history.labels;
  return std::any_of(labels.begin(), labels.end(), [&](const std::string& label) { return label.starts_with(start); });
}

}  // namespace

Tour::Tour() : step_(was_told("tour") ? static_cast<int>(kSteps.size()) : 0) {}

void Tour::finish() {
  step_ = static_cast<int>(kSteps.size());
  remember_told("tour");
}

void Tour::advance(const Desk& desk) {
  const StudioSnapshot& now = *desk.now;
  if (step_ == 0 && now.proposal) ++step_;
  if (step_ == 1 && desk.channel == Channel::kPaint) ++step_;
  if (step_ <= 2 && has_label(desk, "Accept")) step_ = 3;
  if (step_ == 3 && now.shown->rig.lights.size() > 1) ++step_;
}

void Tour::draw(Desk& desk, const ScreenRect& canvas) {
  if (step_ >= static_cast<int>(kSteps.size()) || !desk.has_shot() || desk.hand_down) return;
  advance(desk);
  const Theme& theme = desk.theme;
  if (canvas.size().x < theme.px(340.0F)) return;  // it waits for room
  const float width = std::clamp(canvas.size().x - theme.px(150.0F), theme.px(316.0F), theme.px(600.0F));
  ImGui::SetNextWindowPos({canvas.hi.x - theme.px(12.0F), canvas.hi.y - theme.px(12.0F)}, ImGuiCond_Always,
                          {1.0F, 1.0F});
  ImGui::SetNextWindowSize({width, 0.0F});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0.1F, 0.1F, 0.1F, 0.94F));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, theme.px(5.0F));
  ImGui::Begin("tour", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kAccent);
  ImGui::Text("%d of %d", step_ + 1, static_cast<int>(kSteps.size()));
  ImGui::PopStyleColor();
  ImGui::SameLine();
  const float buttons = theme.px(150.0F);
  ImGui::PushTextWrapPos(width - buttons);
  ImGui::TextUnformatted(kSteps[static_cast<std::size_t>(step_)]);
  ImGui::PopTextWrapPos();
  ImGui::SameLine(width - buttons + theme.px(6.0F));
  const bool last = step_ + 1 == static_cast<int>(kSteps.size());
  if (ImGui::Button(last ? "Done" : "Next", {theme.px(58.0F), 0.0F})) ++step_;
  ImGui::SameLine();
  const bool close = !last && ImGui::Button("Close", {theme.px(62.0F), 0.0F});
  if (close || step_ >= static_cast<int>(kSteps.size())) finish();
  ImGui::End();
}

}  // namespace luminist
