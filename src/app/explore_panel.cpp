#include <fmt/format.h>

#include "app/icons.h"
#include "app/panels.h"

namespace luminist {
namespace {

ExploreWatch watch_for(StudioThread* studio, const std::string& what) {
  return [studio, what](const ExploreProgress& progress) {
    return studio->progress(
        fmt::format("{}: {} of at most {}, {}; Esc stops", what, progress.done, progress.planned, progress.doing));
  };
}

void buttons(Desk& desk) {
  StudioThread* studio = desk.studio;
  if (ImGui::Button("Other lights for this paint", {-1.0F, 0.0F})) {
    studio->post("look for other lights",
                 [studio](Workbench& bench) { return bench.offer_alternatives(watch_for(studio, "other lights")); });
  }
  tip(desk.theme,
      "Paint is ambiguous: looks for lights that make it, but are placed differently. Takes a while; Esc "
      "keeps what was found.");
  if (ImGui::Button("The same picture with fewer lights", {-1.0F, 0.0F})) {
    studio->post("look for fewer lights",
                 [studio](Workbench& bench) { return bench.offer_diet(watch_for(studio, "fewer lights")); });
  }
  tip(desk.theme, "Takes one light after another away; the others make up for it. Takes a while; Esc stops.");
}

}  // namespace

void ExplorePanel::refresh(const Desk& desk) {
  if (shown_ == desk.now->offers && display_ == desk.display) return;
  shown_ = desk.now->offers;
  display_ = desk.display;
  pictures_.clear();
  if (!shown_) return;
  const DisplayTable table(desk.display);
  for (const Offer& offer : *shown_) {
    std::vector<std::uint32_t> codes(offer.picture->pixels());
    to_display(*offer.picture, table, codes);
    pictures_.push_back(std::make_unique<PictureTexture>());
    pictures_.back()->upload(codes, offer.picture->width, offer.picture->height);
    pictures_.back()->filter(0.5F);
  }
}

void ExplorePanel::draw(Desk& desk) {
  buttons(desk);
  refresh(desk);
  ImGui::Spacing();
  if (!shown_) return;
  if (shown_->empty()) return ImGui::TextDisabled("Nothing was found.");
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
  for (std::size_t i = 0; i < shown_->size(); ++i) {
    const Offer& offer = (*shown_)[i];
    const float height = width * static_cast<float>(offer.picture->height) / static_cast<float>(offer.picture->width);
    if (i % 2 == 1) ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::ImageButton(pictures_[i]->id(), {width, height}, {0.0F, 0.0F}, {1.0F, 1.0F}, 0)) {
      desk.studio->post("take an offer", [i](Workbench& bench) { return bench.take_offer(i); });
    }
    tip(desk.theme, "Click to see these lights; they become the proposal.");
    ImGui::PushFont(desk.theme.small);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::TextUnformatted(offer.title.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::PopID();
    ImGui::EndGroup();
  }
}

}  // namespace luminist
