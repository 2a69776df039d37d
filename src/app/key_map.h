#pragma once
// app/key_map.h -- which key does what, as data: Krita's habits, or Photoshop's, or GIMP's.
#include <span>
#include <string>
#include <vector>

namespace luminist {

enum class Deed {
  kNone,
  kUndo,
  kRedo,
  kOpen,
  kSave,
  kSaveAs,
  kQuit,
  kSolve,
  kStop,  ///< a solve, a dialog, a stroke: whatever there is to leave
  kAccept,
  kRevert,
  kAddLight,
  kBrushSmaller,
  kBrushLarger,
  kSwapColors,
  kDefaultColors,
  kToolLight,
  kToolErase,
  kToolShadow,
  kToolImportance,
  kToolPick,
  kToolEdit,
  kDeleteStroke,
  kViewLight,
  kViewPaint,
  kViewResidual,
  kViewImportance,
  kWipe,
  kKeep,
  kOrbit,
  kFit,
  kFullSize,
  kKeys,
  kHidePanels,
  kHandles,
  kDragHighlight,
  kDragShadow,
  kOpacity,  ///< a digit: tenths
};

/// A key of GLFW with the modifiers that must be down, no others.
struct KeyBinding {
  Deed deed = Deed::kNone;
  int key = 0;
  int mods = 0;
};

struct KeyMap {
  std::string name;
  std::vector<KeyBinding> bindings;
  int pick_mods = 0;  ///< held: the brush picks colours

  [[nodiscard]] Deed find(int key, int mods) const;
  /// "Ctrl+Z", the first key of a deed; "" if it has none.
  [[nodiscard]] std::string key_of(Deed deed) const;
};

/// Krita, Photoshop, GIMP.
std::span<const KeyMap> key_maps();
/// "Undo"
const char* name_of(Deed deed);
/// "Ctrl+Shift+Z"
std::string key_name(int key, int mods);

}  // namespace luminist
