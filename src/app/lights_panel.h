#pragma once
// app/lights_panel.h -- the lights as a list, with their groups, and the parameters of the one that is selected.
#include <set>
#include <string>

#include "app/desk.h"
#include "app/param_widgets.h"

namespace luminist {

class LightsPanel {
 public:
  void draw(Desk& desk, ParamWidgets& widgets);

 private:
  void group_row(Desk& desk, const std::string& group);
  void light_row(Desk& desk, const Light& light);
  bool name_field(Desk& desk, const std::string& name);
  void begin_rename(const std::string& name, const std::string& text);
  void end_rename(Desk& desk);
  void buttons(Desk& desk, const Light& light);
  void light_menu(Desk& desk, const Light& light);
  void details(Desk& desk, const Light& light, ParamWidgets& widgets);

  std::set<std::string> folded_;  ///< groups
  std::string renaming_;          ///< a light, or "group:NAME"; "": none
  std::string clicked_twice_;     ///< is renamed once the button is up
  std::string renamed_to_;        ///< as it is typed
  bool rename_began_ = false;     ///< the field has no focus yet
};

/// Which objects a light lights: everything, or some, each to be ticked. In a menu or a list that is open.
void link_choices(Desk& desk, const Light& light);
/// The group of a light: none, one that is there, a new one. In a menu or a list that is open.
void group_choices(Desk& desk, const Light& light);
/// What holds of a light whoever moves it: a row with a list to be ticked, by studio/constraint_words.h.
void constraint_list(Desk& desk, const Light& light);
/// Removal with or without the others making up for it. In a menu that is open.
void removal_choices(Desk& desk, const Light& light);
/// Begins to take objects by clicks on the picture.
void begin_linking(Desk& desk, const Light& light);

}  // namespace luminist
