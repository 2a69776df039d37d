#include "app/file_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>

namespace luminist {
namespace {

namespace fs = std::filesystem;

}  // namespace

void FileDialog::open(FileWish wish, const fs::path& folder) {
  wish_ = std::move(wish);
  name_ = wish_.name;
  left_ = false;
  asked_.clear();
  std::error_code error;
  go(fs::is_directory(folder, error) ? folder : fs::current_path(error));
}

bool FileDialog::wanted(const fs::path& path) const {
  const std::string extension = path.extension().string();
  return std::find(wish_.extensions.begin(), wish_.extensions.end(), extension) != wish_.extensions.end();
}

void FileDialog::go(const fs::path& folder) {
  std::error_code error;
  const fs::path absolute = fs::weakly_canonical(folder, error);
  fs::directory_iterator all(absolute, fs::directory_options::skip_permission_denied, error);
  if (error) {
    fault_ = absolute.string() + ": " + error.message();
    return;
  }
  fault_.clear();
  folder_ = absolute;
  entries_.clear();
  for (const fs::directory_entry& entry : all) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.')) continue;
    const bool is_folder = entry.is_directory(error);
    const bool whole = is_folder && wanted(entry.path());  // a project
    if (is_folder && !whole) {
      entries_.push_back({name, true});
    } else if (!wish_.folders && wanted(entry.path())) {
      entries_.push_back({name, false});
    }
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

void FileDialog::places(const Theme& theme) {
  if (ImGui::Button("Up")) go(folder_.parent_path());
  ImGui::SameLine();
  if (const char* home = std::getenv("HOME"); home != nullptr) {
    if (ImGui::Button("Home")) go(home);
    ImGui::SameLine();
  }
  if (ImGui::Button("Here")) go(fs::current_path());
  ImGui::SameLine(0.0F, theme.px(12.0F));
  ImGui::TextUnformatted(folder_.string().c_str());
}

/// returns whether an entry was chosen by a double click.
bool FileDialog::list(const Theme& theme) {
  bool chosen = false;
  std::string next;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
  ImGui::BeginChild("entries", {0.0F, theme.px(280.0F)});
  if (entries_.empty()) ImGui::TextDisabled("There is nothing here that fits.");
  for (const Entry& entry : entries_) {
    const std::string shown = entry.folder ? entry.name + "/" : entry.name;
    if (ImGui::Selectable(shown.c_str(), !entry.folder && entry.name == name_, ImGuiSelectableFlags_AllowDoubleClick)) {
      if (entry.folder) {
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) next = entry.name;
      } else {
        name_ = entry.name;
        chosen = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
      }
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  if (!next.empty()) go(folder_ / next);
  return chosen;
}

std::optional<fs::path> FileDialog::draw(const Theme& theme) {
  ImGui::PushFont(theme.strong);
  ImGui::TextUnformatted(wish_.title.c_str());
  ImGui::PopFont();
  places(theme);
  bool chosen = list(theme);
  if (!fault_.empty()) ImGui::TextColored({0.87F, 0.43F, 0.38F, 1.0F}, "%s", fault_.c_str());
  ImGui::SetNextItemWidth(-theme.px(190.0F));
  if (ImGui::IsWindowAppearing() && wish_.new_name) ImGui::SetKeyboardFocusHere();
  chosen |= ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  chosen |= ImGui::Button(wish_.button.c_str(), {theme.px(86.0F), 0.0F});
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {theme.px(86.0F), 0.0F})) left_ = true;
  if (!chosen || (name_.empty() && !wish_.folders)) return std::nullopt;
  fs::path path = fs::path(name_).is_absolute() ? fs::path(name_) : folder_ / name_;
  std::error_code error;
  if (!wish_.new_name && fs::is_directory(path, error) && !wanted(path)) {
    go(path);
    name_.clear();
    return std::nullopt;
  }
  if (wish_.new_name && !wish_.folders && !wanted(path)) path += wish_.extensions.front();
  if (wish_.new_name && !wish_.folders && path != asked_ && fs::exists(path, error)) {
    asked_ = path;
    fault_ = path.filename().string() + " is there already; press " + wish_.button + " again to replace it";
    return std::nullopt;
  }
  return path;
}

}  // namespace luminist
