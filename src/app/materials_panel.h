#pragma once
// app/materials_panel.h -- what light falls on: the scene's materials as a list, and the parameters of one of them.
#include <memory>
#include <string>
#include <vector>

#include "app/desk.h"
#include "app/param_widgets.h"

namespace luminist {

/// A section that is folded until it is asked for, since light comes first.
class MaterialsPanel {
 public:
  void draw(Desk& desk, ParamWidgets& widgets);

 private:
  /// How much of the picture a material fills, and its mean colour there.
  struct Seen {
    int material = 0;  ///< index in the state
    std::size_t pixels = 0;
    Vec3 albedo{0.5F};
  };
  void heading(const Desk& desk);
  void look(const Desk& desk);
  void row(Desk& desk, const Seen& seen);
  void details(Desk& desk, const MaterialParams& material, ParamWidgets& widgets);

  bool open_ = false;
  std::string in_sight_;                    ///< the chosen one, once the list was scrolled to it
  std::shared_ptr<const ShotFacts> facts_;  ///< of which seen_ is
  std::vector<Seen> seen_;                  ///< of every material, the largest first
};

/// The panel shows the material at a place of the picture, in pixels; where there is none nothing changes.
void choose_material(Desk& desk, const Vec2& picture);

}  // namespace luminist
