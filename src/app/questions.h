#pragma once
// app/questions.h -- what is asked in the middle of the window: files, keys, leaving.
#include "app/desk.h"
#include "app/file_dialog.h"

namespace luminist {

class Questions {
 public:
  void draw(Desk& desk);
  void leave(Desk& desk) { desk.question = Question::kNone; }  ///< whatever is asked

 private:
  void begin(Desk& desk);
  void files(Desk& desk);
  void keys(Desk& desk);
  void quit(Desk& desk);
  void answer(Desk& desk, const std::filesystem::path& path);

  FileDialog dialog_;
  std::filesystem::path folder_;  ///< where files were chosen last
};

/// Opens what a path names: a project or a scene.
void open_path(Desk& desk, const std::filesystem::path& path);

}  // namespace luminist
