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
ImU32 outcome_color(StrokeOutcome outcome);
/// The paint as what it is made of: layers, and strokes that can be changed.
class StrokePanel {
 public:
  /// Layers and strokes, and below them the verdict.
  void list(Desk& desk);
  /// The brush of the stroke that is selected, in place of that in the hand.
  void settings(Desk& desk);

 private:
  void layer_row(Desk& desk, std::size_t index);
  void layer_name(Desk& desk, std::size_t index, float width);
  void rename_popup(Desk& desk, const std::string& layer);
  void stroke_row(Desk& desk, std::uint32_t number);
  void take_up(const Desk& desk);

  std::string name_;   ///< as it is typed
  std::string faded_;  ///< layer whose opacity is under the hand
  float opacity_ = 1.0F;
  std::uint32_t stroke_ = 0;  ///< whose brush is held
  Brush brush_;
  bool held_ = false;                   ///< it is not what the session has yet
  const LayerStack* posted_ = nullptr;  ///< what there was when it was sent
};
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
