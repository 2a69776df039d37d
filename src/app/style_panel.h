#pragma once
// app/style_panel.h -- what is looked at and how: camera, size, the style, the lines over it, the materials.
#include <set>
#include <string>
#include <vector>

#include "app/desk.h"
#include "app/materials_panel.h"
#include "app/param_widgets.h"
#include "style/style.h"

namespace luminist {

/// The cameras of the scene, to look through. In a menu or a list that is open.
void camera_choices(Desk& desk);

class StylePanel {
 public:
  void draw(Desk& desk, ParamWidgets& widgets);

 private:
  void shot_rows(Desk& desk);
  void style_rows(Desk& desk);
  /// Styles that draw lines over others; read once.
  const std::vector<Style>& overlays(const Desk& desk);

  MaterialsPanel materials_;
  bool read_ = false;
  std::vector<Style> overlays_;
  std::set<std::string> traced_;  ///< styles that are path traced
  int size_[2] = {0, 0};          ///< as it is typed
};

}  // namespace luminist
