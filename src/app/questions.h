#pragma once
// app/questions.h -- what is asked in the middle of the window: files, keys, leaving.
#include "app/desk.h"
#include "app/file_dialog.h"
#include "app/kept_sessions.h"
#include "studio/picture_export.h"

namespace luminist {

class Questions {
 public:
  void draw(Desk& desk);
  /// Sessions that were never saved, for Question::kRecover. returns whether there are any.
  bool find_kept(const std::filesystem::path& folder);
  void leave(Desk& desk) { desk.question = Question::kNone; }  ///< whatever is asked

 private:
  void begin(Desk& desk);
  void files(Desk& desk);
  void keys(Desk& desk);
  void quit(Desk& desk);
  void recover(Desk& desk);
  void choose_export(Desk& desk);
  void answer(Desk& desk, const std::filesystem::path& path);

  FileDialog dialog_;
  std::vector<KeptSession> kept_;
  PictureChoice choice_;          ///< what is exported
  std::filesystem::path folder_;  ///< where files were chosen last
};

/// Opens what a path names: a project or a scene.
void open_path(Desk& desk, const std::filesystem::path& path);

}  // namespace luminist
