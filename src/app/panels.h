#pragma once
// app/panels.h -- the parts of the window around the canvas, one file each.
#include "app/desk.h"
#include "app/param_widgets.h"

namespace luminist {

/// The strip of tools, and below it nothing: a column of icons.
void tool_strip(Desk& desk);
/// The tool's settings, colours, importance.
void brush_panel(Desk& desk);
/// Lights as a list, and the parameters of the one that is selected.
void lights_panel(Desk& desk, ParamWidgets& widgets);
void style_panel(Desk& desk, ParamWidgets& widgets);
void history_panel(Desk& desk);
/// What becomes of the paint: always in sight.
void solve_panel(Desk& desk);
/// What became of each stroke, and what would help.
void verdict_panel(Desk& desk);
/// Which picture is shown, and how.
void view_bar(Desk& desk);
void menu_bar(Desk& desk);
void status_bar(Desk& desk);

}  // namespace luminist
