#pragma once
// app/file_dialog.h -- choosing a file, without a desktop's help.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/theme.h"

namespace luminist {

/// What is looked for.
struct FileWish {
  std::string title;
  std::string button;                   ///< "Open"
  std::vector<std::string> extensions;  ///< ".glb"; a folder with one of these (".lum") counts as a file
  bool new_name = false;                ///< a name may be typed that is not there yet
  std::string name;                     ///< suggested
  bool folders = false;                 ///< a folder is wanted, and no file
};

/// By mouse, or by keys alone: arrows walk through the list, Tab completes a name, Enter opens, Alt+Up goes up.
class FileDialog {
 public:
  void open(FileWish wish, const std::filesystem::path& folder);
  /// Draws into the present popup. returns the path that was chosen; closed() says whether it was left.
  std::optional<std::filesystem::path> draw(const Theme& theme);
  [[nodiscard]] bool left() const { return left_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  struct Entry {
    std::string name;
    bool folder = false;
  };
  void go(const std::filesystem::path& folder);
  void places(const Theme& theme);
  bool list(const Theme& theme);
  bool name_field(const Theme& theme);
  static int edit_name(ImGuiInputTextCallbackData* data);
  void walk(int step);
  /// The first name in the list that begins so; "" if there is none.
  [[nodiscard]] std::string completed(const std::string& start) const;
  [[nodiscard]] bool wanted(const std::filesystem::path& path) const;

  FileWish wish_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string fault_;  ///< why a folder cannot be read
  std::string name_;
  std::filesystem::path asked_;  ///< what is there already, once the lighter was asked whether to replace it
  bool left_ = false;
  int walked_ = -1;           ///< entry that the arrows are at
  bool scroll_ = false;       ///< until it is in sight
  bool wants_focus_ = false;  ///< the keys go to the name
};

}  // namespace luminist
