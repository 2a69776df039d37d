#pragma once
// app/icons.h -- small signs, drawn as lines so that they are sharp at any scale.
#include <imgui.h>

#include "app/brush_box.h"
#include "app/theme.h"

namespace luminist {

enum class Icon {
  kSun,
  kBrighten,
  kDarken,
  kShadow,
  kLift,
  kCopy,
  kErase,
  kTarget,
  kDropper,
  kBucket,
  kLocked,
  kOpen,
  kPartly,  ///< some locked, some open
  kEye,
  kEyeOff,
  kSolo,
  kPlus,
  kTrash,
  kArrow,
  kUp,
  kDown,
  kMerge,
  kMore,  ///< three dots: a menu
  kFolded,
  kUnfolded,
};
Icon icon_of(Tool tool);

void draw_icon(ImDrawList& list, Icon icon, const ImVec2& center, float size, ImU32 color);

/// A flat square button. active: in the accent colour. tip may be empty. returns whether it was clicked.
bool icon_button(const Theme& theme, const char* id, Icon icon, float size, bool active, const char* tip);

/// A tooltip of the last item once the pointer rests on it, wrapped.
void tip(const Theme& theme, const char* text);

}  // namespace luminist
