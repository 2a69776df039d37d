#pragma once
// app/panels.h -- the parts of the window around the canvas, one file each.
#include "app/desk.h"
#include "app/param_widgets.h"
#include "app/picture_texture.h"

namespace luminist {

/// The strip of tools, and below it nothing: a column of icons.
void tool_strip(Desk& desk);
/// The tool's settings, colours, importance.
void brush_panel(Desk& desk);
void history_panel(Desk& desk);
/// What becomes of the paint: always in sight.
void solve_panel(Desk& desk);
/// What became of each stroke, and what would help.
void verdict_panel(Desk& desk);
/// Other lights for the same paint, the same picture with fewer lights: a tray of pictures to choose from.
class ExplorePanel {
 public:
  void draw(Desk& desk);

 private:
  void refresh(const Desk& desk);
  std::shared_ptr<const std::vector<Offer>> shown_;
  DisplayOptions display_;
  std::vector<std::unique_ptr<PictureTexture>> pictures_;
};
/// Which picture is shown, and how.
void view_bar(Desk& desk);
void menu_bar(Desk& desk);
void status_bar(Desk& desk);

}  // namespace luminist
