#include "app/file_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "app/icons.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

std::string shown_name(const std::string& name, bool folder) {
  return folder ? name + "/" : name;
}

}  // namespace

void FileDialog::open(FileWish wish, const fs::path& folder) {
  wish_ = std::move(wish);
  name_ = wish_.name;
  left_ = false;
  asked_.clear();
  wants_focus_ = true;
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
  walked_ = -1;
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
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const Entry& entry = entries_[static_cast<std::size_t>(i)];
    const std::string shown = shown_name(entry.name, entry.folder);
    const bool at = i == walked_ || (!entry.folder && entry.name == name_);
    if (i == walked_ && std::exchange(scroll_, false)) ImGui::SetScrollHereY(0.5F);
    if (ImGui::Selectable(shown.c_str(), at, ImGuiSelectableFlags_AllowDoubleClick)) {
      wants_focus_ = true;
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

void FileDialog::walk(int step) {
  if (entries_.empty()) return;
  walked_ = std::clamp(walked_ + step, 0, static_cast<int>(entries_.size()) - 1);
  scroll_ = true;
}

std::string FileDialog::completed(const std::string& start) const {
  for (const Entry& entry : entries_) {
    if (entry.name.starts_with(start)) return shown_name(entry.name, entry.folder);
  }
  return "";
}

/// Arrows and Tab in the field of the name.
int FileDialog::edit_name(ImGuiInputTextCallbackData* data) {
  FileDialog& dialog = *static_cast<FileDialog*>(data->UserData);
  std::string name;
  if (data->EventFlag == ImGuiInputTextFlags_CallbackHistory) {
    dialog.walk(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
    if (dialog.walked_ < 0) return 0;
    const Entry& entry = dialog.entries_[static_cast<std::size_t>(dialog.walked_)];
    name = shown_name(entry.name, entry.folder);
  } else {
    name = dialog.completed(std::string(data->Buf, static_cast<std::size_t>(data->BufTextLen)));
  }
  if (name.empty()) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, name.c_str());
  return 0;
}

/// returns whether Enter was pressed.
bool FileDialog::name_field(const Theme& theme) {
  ImGui::SetNextItemWidth(-theme.px(190.0F));
  if (std::exchange(wants_focus_, false)) ImGui::SetKeyboardFocusHere();
  const ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory |
                                    ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_AutoSelectAll;
  const bool entered = ImGui::InputText("##name", &name_, flags, edit_name, this);
  tip(theme, "A name or a path. Arrows walk through the list, Tab completes, Enter opens, Alt+Up goes up.");
  if (ImGui::GetIO().KeyAlt && ImGui::IsKeyPressed(ImGuiKey_UpArrow, false)) {
    go(folder_.parent_path());
    name_.clear();
  }
  if (entered) wants_focus_ = true;
  return entered;
}

std::optional<fs::path> FileDialog::draw(const Theme& theme) {
  ImGui::PushFont(theme.strong);
  ImGui::TextUnformatted(wish_.title.c_str());
  ImGui::PopFont();
  places(theme);
  bool chosen = list(theme);
  if (!fault_.empty()) ImGui::TextColored({0.87F, 0.43F, 0.38F, 1.0F}, "%s", fault_.c_str());
  chosen |= name_field(theme);
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
