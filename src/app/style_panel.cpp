#include "app/style_panel.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/style_parts.h"
#include "studio/shot_camera.h"
#include "studio/shot_view.h"

namespace luminist {
namespace {

constexpr std::array<std::pair<int, int>, 6> kSizes = {
    {{320, 240}, {640, 480}, {960, 540}, {1280, 720}, {1920, 1080}, {2048, 858}}};

std::string size_words(int width, int height) {
  return fmt::format("{} x {}", width, height);
}

void reframe(const Desk& desk, const std::string& camera, int width, int height) {
  desk.studio->change("open the shot again", [camera, width, height](Session& session) {
    return session.view().reframe(camera, width, height);
  });
}

void restyle(const Desk& desk, const std::string& name) {
  desk.studio->change("compile the style " + name, [name](Session& session) { return session.restyle(name); });
}

/// What another size costs.
void say_what_goes(const Desk& desk) {
  if (!desk.now->any_paint && (!desk.now->frames || desk.now->frames->painted.empty())) return;
  ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kWarn);
  ImGui::TextUnformatted("The paint of every camera goes with the size; undo brings both back.");
  ImGui::PopStyleColor();
  ImGui::Separator();
}

void heading(const Theme& theme, const std::string& text) {
  ImGui::Spacing();
  ImGui::PushFont(theme.strong);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopFont();
}

void dim_text(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, paint_colors::kDim);
  ImGui::TextWrapped("%s", text.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void camera_choices(Desk& desk) {
  const ShotFacts& facts = *desk.now->facts;
  const std::string now = camera_name(facts.shot.camera, facts.cameras);
  for (const std::string& camera : facts.cameras) {
    if (ImGui::Selectable(camera.c_str(), camera == now)) reframe(desk, camera, facts.shot.width, facts.shot.height);
    tip(desk.theme,
        "Look through this camera. What is painted stays with the camera that it is painted through; "
        "View > Frames and keys > Solve together finds one rig for all.");
  }
}

const std::vector<Style>& StylePanel::overlays(const Desk& desk) {
  if (!std::exchange(read_, true)) {
    for (const std::string& name : style_names(desk.roots)) {
      auto style = load_style(desk.roots, name);
      if (!style) continue;
      if (style->engine == StyleEngine::kPath) traced_.insert(name);
      if (!style->shades()) overlays_.push_back(std::move(*style));
    }
  }
  return overlays_;
}

void StylePanel::shot_rows(Desk& desk) {
  const ShotFacts& facts = *desk.now->facts;
  const Shot& shot = facts.shot;
  row_label(desk.theme, "Camera", "From where the shot is seen: a camera of the scene.");
  ImGui::SetNextItemWidth(-1.0F);
  if (ImGui::BeginCombo("##camera", camera_name(facts.shot.camera, facts.cameras).c_str())) {
    camera_choices(desk);
    ImGui::EndCombo();
  }
  row_label(desk.theme, "Size", "Pixels of the picture, width by height. Large ones make lights follow more slowly.");
  ImGui::SetNextItemWidth(-1.0F);
  if (!ImGui::BeginCombo("##size", size_words(shot.width, shot.height).c_str(), ImGuiComboFlags_HeightLarge)) {
    size_[0] = shot.width;
    size_[1] = shot.height;
    return;
  }
  say_what_goes(desk);
  for (const auto& [width, height] : kSizes) {
    const bool same = width == shot.width && height == shot.height;
    if (ImGui::Selectable(size_words(width, height).c_str(), same)) reframe(desk, shot.camera, width, height);
    tip(desk.theme, "Render and paint in this size.");
  }
  ImGui::Separator();
  ImGui::SetNextItemWidth(desk.theme.px(120.0F));
  ImGui::InputInt2("##typed", size_);
  tip(desk.theme, "Any other width and height.");
  ImGui::SameLine();
  if (ImGui::Button("Use")) {
    reframe(desk, shot.camera, size_[0], size_[1]);
    ImGui::CloseCurrentPopup();
  }
  tip(desk.theme, "Render and paint in the size that is typed here.");
  ImGui::EndCombo();
}

void StylePanel::style_rows(Desk& desk) {
  const ShotFacts& facts = *desk.now->facts;
  const StyleParts parts = parts_of(facts.shot.style);
  const std::vector<Style>& all = overlays(desk);
  row_label(desk.theme, "Style", "How light becomes a picture. A folder below styles/, without programming.");
  ImGui::SetNextItemWidth(-1.0F);
  if (ImGui::BeginCombo("##style", parts.base.c_str())) {
    for (const std::string& name : facts.styles) {
      if (ImGui::Selectable(name.c_str(), name == parts.base)) {
        // The path tracer draws no lines.
        restyle(desk, traced_.contains(name) ? name : StyleParts{name, parts.lines}.name());
      }
    }
    ImGui::EndCombo();
  }
  const bool traced = traced_.contains(parts.base);
  for (const Style& lines : all) {
    row_label(desk.theme, "", "");
    bool on = parts.lines == lines.name;
    ImGui::BeginDisabled(traced);
    if (ImGui::Checkbox((lines.name + " over it").c_str(), &on)) {
      restyle(desk, StyleParts{parts.base, on ? lines.name : ""}.name());
    }
    ImGui::EndDisabled();
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
      tip(desk.theme, traced ? "Lines are drawn by the raster engine; this style is path traced." : lines.doc.c_str());
    }
  }
}

void StylePanel::draw(Desk& desk, ParamWidgets& widgets) {
  const ShotFacts& facts = *desk.now->facts;
  shot_rows(desk);
  ImGui::Separator();
  style_rows(desk);
  ImGui::Separator();
  materials_.draw(desk, widgets);
  ImGui::Separator();
  const StyleParts parts = parts_of(facts.shot.style);
  const std::vector<Style>& all = overlays(desk);
  const auto lines = std::ranges::find(all, parts.lines, &Style::name);
  const bool stacked = lines != all.end();
  const auto of_lines = [&](const ParamSpec& spec) { return stacked && lines->schema->find(spec.name).has_value(); };
  if (stacked) heading(desk.theme, parts.base);
  const std::string& doc = facts.style_doc;
  dim_text(stacked && doc.ends_with(lines->doc) ? doc.substr(0, doc.size() - lines->doc.size()) : doc);
  ImGui::Spacing();
  const ParamBlock& block = desk.now->shown->style;
  widgets.draw(desk, block, "style", [&](const ParamSpec& spec) { return !of_lines(spec); });
  if (!stacked) return;
  heading(desk.theme, lines->name);
  dim_text(lines->doc);
  ImGui::Spacing();
  widgets.draw(desk, block, "style", of_lines);
}

}  // namespace luminist
