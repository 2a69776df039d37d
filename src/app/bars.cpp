// The menu on top and the line below.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/icons.h"
#include "app/kept_sessions.h"
#include "app/panels.h"
#include "app/questions.h"
#include "app/shots_panel.h"
#include "app/style_panel.h"
#include "studio/shot_camera.h"

namespace luminist {
namespace {

void item(Desk& desk, const char* label, Deed deed, bool enabled = true) {
  if (ImGui::MenuItem(label, desk.keys().key_of(deed).c_str(), false, enabled)) perform(desk, deed);
}

void file_menu(Desk& desk) {
  if (!ImGui::BeginMenu("File")) return;
  item(desk, "Open a scene or project...", Deed::kOpen);
  if (ImGui::BeginMenu("Open recent")) {
    const std::vector<std::filesystem::path> files = recent_files();
    if (files.empty()) ImGui::TextDisabled("nothing yet");
    for (const std::filesystem::path& file : files) {
      if (ImGui::MenuItem(file.filename().string().c_str())) open_path(desk, file);
      tip(desk.theme, file.string().c_str());
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  item(desk, "Save", Deed::kSave, desk.has_shot());
  item(desk, "Save as...", Deed::kSaveAs, desk.has_shot());
  if (ImGui::MenuItem("Export pictures and rig...", nullptr, false, desk.has_shot())) desk.ask(Question::kExport);
  ImGui::Separator();
  item(desk, "Quit", Deed::kQuit);
  ImGui::EndMenu();
}

void edit_menu(Desk& desk) {
  if (!ImGui::BeginMenu("Edit")) return;
  const HistoryFacts& history = desk.now->history;
  const auto label = [&](std::size_t command) {
    const std::size_t i = command - history.first;
    return i < history.labels.size() ? history.labels[i] : std::string();
  };
  const std::string undo = history.undo_steps > 0 ? "Undo: " + label(history.undo_steps - 1) : "Undo";
  const std::string redo = history.redo_steps > 0 ? "Redo: " + label(history.undo_steps) : "Redo";
  item(desk, undo.substr(0, 60).c_str(), Deed::kUndo, history.undo_steps > 0);
  item(desk, redo.substr(0, 60).c_str(), Deed::kRedo, history.redo_steps > 0);
  ImGui::EndMenu();
}

void view_menu(Desk& desk) {
  if (!ImGui::BeginMenu("View")) return;
  item(desk, "Fit the picture", Deed::kFit);
  item(desk, "Full size", Deed::kFullSize);
  item(desk, "Hide the panels", Deed::kHidePanels);
  if (ImGui::MenuItem("Frames and keys", nullptr, shots_shown(desk))) desk.show_shots = !shots_shown(desk);
  item(desk, "The shot from anywhere", Deed::kOrbit);
  item(desk, "Handles of barn and cutoffs", Deed::kHandles);
  if (ImGui::BeginMenu("Look through", desk.has_shot() && !desk.now->facts->cameras.empty())) {
    camera_choices(desk);
    ImGui::EndMenu();
  }
  ImGui::Separator();
  item(desk, "Drag a highlight", Deed::kDragHighlight, desk.has_shot());
  item(desk, "Drag a shadow's edge", Deed::kDragShadow, desk.has_shot());
  ImGui::Separator();
  item(desk, "Keep the picture to compare with", Deed::kKeep, desk.has_shot());
  if (ImGui::MenuItem("Wipe against the kept picture", nullptr, desk.wipe_kept, desk.kept != nullptr)) {
    desk.wipe_kept = !desk.wipe_kept;
  }
  ImGui::Separator();
  for (int i = 0; i < static_cast<int>(key_maps().size()); ++i) {
    const std::string label = "Keys as in " + key_maps()[static_cast<std::size_t>(i)].name;
    if (ImGui::MenuItem(label.c_str(), nullptr, desk.key_map == i)) desk.key_map = i;
  }
  ImGui::EndMenu();
}

/// Turning, so that it is seen to live.
void spinner(const Desk& desk) {
  const float r = desk.theme.px(5.0F);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 center(at.x + r, at.y + 0.5F * ImGui::GetTextLineHeight());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float turn = static_cast<float>(std::fmod(4.0 * desk.time, 6.28318));
  list.PathArcTo(center, r, turn, turn + 4.0F, 16);
  list.PathStroke(paint_colors::kAccent, 0, desk.theme.px(1.5F));
  ImGui::Dummy({2.0F * r, ImGui::GetTextLineHeight()});
  ImGui::SameLine();
}

ImU32 color_of(StudioMessage::Kind kind) {
  return kind == StudioMessage::Kind::kError     ? paint_colors::kBad
         : kind == StudioMessage::Kind::kWarning ? paint_colors::kWarn
                                                 : paint_colors::kText;
}

std::string line_of(const StudioMessage& message) {
  std::string line = message.where.empty() ? message.text : message.where + ": " + message.text;
  return message.hint.empty() ? line : line + "; " + message.hint;
}

void message_list(Desk& desk) {
  if (!ImGui::BeginPopup("messages")) return;
  ImGui::PushTextWrapPos(desk.theme.px(560.0F));
  for (const ToldMessage& told : desk.messages) {
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(told.message.kind));
    ImGui::TextUnformatted(line_of(told.message).c_str());
    ImGui::PopStyleColor();
  }
  ImGui::PopTextWrapPos();
  ImGui::EndPopup();
}

/// Where the pointer is: the object, and the light there.
std::string place_line(const Desk& desk) {
  if (!desk.has_shot()) return "";
  const std::string zoom = fmt::format("{:.0f} %", 100.0F * desk.view.zoom());
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Vec2 at = desk.view.to_picture({mouse.x, mouse.y});
  const Image& painted = desk.now->painted->color;
  const Image& picture = desk.now->picture->same_size(painted) ? *desk.now->picture : painted;
  const bool over = desk.view.rect().contains({mouse.x, mouse.y}) && at.x >= 0.0F && at.y >= 0.0F &&
                    at.x < static_cast<float>(picture.width) && at.y < static_cast<float>(picture.height);
  if (!over) return zoom;
  const int x = static_cast<int>(at.x);
  const int y = static_cast<int>(at.y);
  const Vec3 light = picture.rgb(picture.index(x, y));
  const SurfaceBuffer& surface = desk.now->facts->surface;
  const std::string& object = surface.object_names[surface.object[surface.index(x, y)]];
  return fmt::format("{}  {:.3f} {:.3f} {:.3f}   {}", object.empty() ? "background" : object, light.x, light.y, light.z,
                     zoom);
}

}  // namespace

void menu_bar(Desk& desk) {
  if (!ImGui::BeginMainMenuBar()) return;
  file_menu(desk);
  edit_menu(desk);
  view_menu(desk);
  if (ImGui::BeginMenu("Help")) {
    item(desk, "Keys", Deed::kKeys);
    ImGui::EndMenu();
  }
  if (desk.has_shot()) {
    const HistoryFacts& history = desk.now->history;
    const Shot& shot = desk.now->facts->shot;
    const std::string name = history.unsaved ? "unsaved" : history.folder.filename().string();
    const std::vector<std::string>& cameras = desk.now->facts->cameras;
    const std::string camera = cameras.size() > 1 ? "   " + camera_name(shot.camera, cameras) : "";
    const std::string title = fmt::format("{}{}   {}   {} x {}   {}", std::filesystem::path(shot.scene).stem().string(),
                                          camera, shot.style, shot.width, shot.height, name);
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    // Where there is no room its beginning is cut off; the tooltip has the rest.
    const float left = ImGui::GetCursorPosX() + desk.theme.px(16.0F);
    const float right = ImGui::GetWindowWidth() - desk.theme.px(12.0F);
    const ImVec2 window = ImGui::GetWindowPos();
    ImGui::PushClipRect({window.x + left, window.y}, {window.x + right, window.y + ImGui::GetWindowHeight()}, true);
    ImGui::SetCursorPosX(std::max(left, right - width));
    ImGui::TextDisabled("%s", title.c_str());
    ImGui::PopClipRect();
    tip(desk.theme, (title + "\nWhat you do is kept in " + history.folder.string()).c_str());
  }
  ImGui::EndMainMenuBar();
}

void status_bar(Desk& desk) {
  constexpr double kQuick = 0.25;     // seconds that need no words
  constexpr double kReadable = 12.0;  // seconds that a message stays
  const std::string place = place_line(desk);
  const float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(place.c_str()).x;
  const bool busy = !desk.activity.label.empty() && desk.activity.seconds > kQuick;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float most = std::max(0.0F, right - desk.theme.px(24.0F));
  ImGui::PushClipRect(at, {at.x + most, at.y + ImGui::GetTextLineHeightWithSpacing()}, true);
  std::string full;
  if (busy) {
    spinner(desk);
    full = desk.activity.label + " ...";
    ImGui::TextUnformatted(full.c_str());
  } else if (!desk.messages.empty() && desk.time - desk.messages.back().time < kReadable) {
    const StudioMessage& message = desk.messages.back().message;
    full = line_of(message);
    ImGui::PushStyleColor(ImGuiCol_Text, color_of(message.kind));
    ImGui::TextUnformatted(full.c_str());
    ImGui::PopStyleColor();
  } else {
    full = "Click to read what was said.";
    ImGui::TextDisabled("%s", "Ready");
  }
  ImGui::PopClipRect();
  if (ImGui::IsItemClicked() && !busy) ImGui::OpenPopup("messages");
  tip(desk.theme, full.c_str());
  message_list(desk);
  ImGui::SameLine(right);
  ImGui::TextDisabled("%s", place.c_str());
}

}  // namespace luminist
