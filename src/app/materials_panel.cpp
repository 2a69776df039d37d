#include "app/materials_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/icons.h"
#include "params/param_text.h"

namespace luminist {
namespace {

constexpr int kRows = 4;  // of the list that are in sight at once, with the parameters below them

void swatch(const Desk& desk, const Vec3& color) {
  const float side = desk.theme.px(14.0F);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float down = 0.5F * (ImGui::GetFrameHeight() - side);
  const Vec3 shown = glm::clamp(color, Vec3(0.0F), Vec3(1.0F));
  const ImU32 code = ImGui::ColorConvertFloat4ToU32(
      {srgb_from_linear(shown.x), srgb_from_linear(shown.y), srgb_from_linear(shown.z), 1.0F});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled({at.x, at.y + down}, {at.x + side, at.y + down + side}, code, desk.theme.px(3.0F));
  list.AddRect({at.x, at.y + down}, {at.x + side, at.y + down + side}, IM_COL32(120, 120, 120, 255),
               desk.theme.px(3.0F));
  ImGui::Dummy({side, side});
}

/// The assignments that make a material the scene's own again.
std::vector<std::string> own_values(const MaterialParams& material) {
  std::vector<std::string> assignments;
  for (const ParamSpec& spec : material.params.schema().specs()) {
    std::string text;
    for (const double value : spec.default_value) {
      if (!text.empty()) text.append(",");
      text.append(number_text(shortest_double(static_cast<float>(value))));
    }
    assignments.push_back(fmt::format("materials/{}/{}={}", material.name, spec.name, text));
  }
  return assignments;
}

}  // namespace

void choose_material(Desk& desk, const Vec2& picture) {
  const SurfaceBuffer& surface = desk.now->facts->surface;
  const int x = static_cast<int>(std::floor(picture.x));
  const int y = static_cast<int>(std::floor(picture.y));
  if (x < 0 || y < 0 || x >= surface.width || y >= surface.height) return;
  const std::uint32_t material = surface.material[surface.index(x, y)];
  const std::vector<MaterialParams>& all = desk.now->shown->materials;
  if (material > 0 && material <= all.size()) desk.material = all[material - 1].name;
}

void MaterialsPanel::look(const Desk& desk) {
  const std::size_t count = desk.now->shown->materials.size();
  if (facts_ == desk.now->facts && seen_.size() == count) return;
  facts_ = desk.now->facts;
  seen_.assign(count, {});
  for (std::size_t i = 0; i < count; ++i) seen_[i].material = static_cast<int>(i);
  const SurfaceBuffer& surface = facts_->surface;
  std::vector<Vec3> sum(count, Vec3(0.0F));
  for (std::size_t pixel = 0; pixel < surface.pixels(); ++pixel) {
    const std::uint32_t material = surface.material[pixel];
    if (material == 0 || material > count) continue;
    ++seen_[material - 1].pixels;
    sum[material - 1] += glm::max(surface.albedo[pixel], surface.specular[pixel]);  // a metal has colour there
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (seen_[i].pixels > 0) seen_[i].albedo = sum[i] / static_cast<float>(seen_[i].pixels);
  }
  std::ranges::stable_sort(seen_, std::ranges::greater(), &Seen::pixels);
}

void MaterialsPanel::row(Desk& desk, const Seen& seen) {
  const MaterialParams& material = desk.now->shown->materials[static_cast<std::size_t>(seen.material)];
  const ParamBlock& params = material.params;
  ImGui::PushID(seen.material);
  lock_button(desk, "lock", params.locks(), params.schema().dofs(), {"materials/" + material.name},
              ImGui::GetFrameHeight());
  ImGui::SameLine(0.0F, desk.theme.px(6.0F));
  const MaterialTurn turn = turn_of(params);
  swatch(desk, seen.albedo * turn.tint);
  ImGui::SameLine(0.0F, desk.theme.px(8.0F));
  const bool hidden = seen.pixels == 0;
  if (hidden) ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
  ImGui::PushStyleVar(ImGuiStyleVar_SelectableTextAlign, {0.0F, 0.5F});
  const std::string words = material.name + (turn.nothing() ? "" : "  (changed)");
  const bool chosen = desk.material == material.name;
  if (ImGui::Selectable(words.c_str(), chosen, 0, {0.0F, ImGui::GetFrameHeight()})) {
    desk.material = in_sight_ = material.name;
  }
  if (chosen && std::exchange(in_sight_, material.name) != material.name) ImGui::SetScrollHereY();
  ImGui::PopStyleVar();
  if (hidden) ImGui::PopStyleColor();
  const double share = 100.0 * static_cast<double>(seen.pixels) / static_cast<double>(facts_->surface.pixels());
  tip(desk.theme, hidden ? "Nothing of it is in the picture. Click to see its parameters."
                         : fmt::format("{:.1f} % of the picture. Click to see its parameters.", share).c_str());
  ImGui::PopID();
}

void MaterialsPanel::details(Desk& desk, const MaterialParams& material, ParamWidgets& widgets) {
  ImGui::Separator();
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted(material.name.c_str());
  ImGui::PopFont();
  widgets.draw(desk, material.params, "materials/" + material.name);
  ImGui::Spacing();
  ImGui::BeginDisabled(turn_of(material.params).nothing());
  if (ImGui::Button("As the scene has it")) {
    desk.studio->change("set", [own = own_values(material)](Session& session) { return session.set(own); });
  }
  ImGui::EndDisabled();
  tip(desk.theme, "Takes back what was changed of this material; its locks stay.");
}

/// The line that folds the section, with what is free or changed in it.
void MaterialsPanel::heading(const Desk& desk) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 start = ImGui::GetCursorPos();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::Selectable("##materials", false, ImGuiSelectableFlags_None, {0.0F, side})) open_ = !open_;
  tip(desk.theme,
      "What light falls on: tint, highlights and roughness of the scene's materials. All of it is locked: free a "
      "material where not only the light, but the surface, too, may become what is painted.");
  draw_icon(*ImGui::GetWindowDrawList(), open_ ? Icon::kUnfolded : Icon::kFolded,
            {at.x + 0.5F * side, at.y + 0.5F * side}, 0.5F * side, paint_colors::kDim);
  const ImVec2 end = ImGui::GetCursorPos();
  int changed = 0;
  int free = 0;
  for (const MaterialParams& material : desk.now->shown->materials) {
    changed += turn_of(material.params).nothing() ? 0 : 1;
    free += material.params.locks() < material.params.schema().dofs() ? 1 : 0;
  }
  ImGui::SetCursorPos({start.x + 1.1F * side, start.y});
  ImGui::AlignTextToFramePadding();
  ImGui::PushFont(desk.theme.strong);
  ImGui::TextUnformatted("Materials");
  ImGui::PopFont();
  if (changed > 0 || free > 0) {
    ImGui::SameLine(0.0F, desk.theme.px(10.0F));
    ImGui::TextDisabled("%d changed, %d free", changed, free);
  }
  ImGui::SetCursorPos(end);
}

void MaterialsPanel::draw(Desk& desk, ParamWidgets& widgets) {
  heading(desk);
  if (!open_) return;
  look(desk);
  const float side = ImGui::GetFrameHeight();
  if (icon_button(desk.theme, "pick material", Icon::kTarget, side, desk.pick_material,
                  "Click here, then on the picture, to choose the material there.")) {
    desk.pick_material = !desk.pick_material;
  }
  ImGui::SameLine(0.0F, desk.theme.px(6.0F));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(desk.pick_material ? "Click on the picture" : "Choose in the picture");
  const auto rows = static_cast<float>(std::min<std::size_t>(kRows, seen_.size()));
  const float height = rows * (side + ImGui::GetStyle().ItemSpacing.y) + ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("materials", {0.0F, height});
  for (const Seen& seen : seen_) row(desk, seen);
  ImGui::EndChild();
  const std::vector<MaterialParams>& all = desk.now->shown->materials;
  const auto chosen = std::ranges::find(all, desk.material, &MaterialParams::name);
  if (chosen != all.end()) {
    details(desk, *chosen, widgets);
  } else if (!seen_.empty()) {
    desk.material = all[static_cast<std::size_t>(seen_.front().material)].name;
  }
}

}  // namespace luminist
