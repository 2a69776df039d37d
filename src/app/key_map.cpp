#include "app/key_map.h"

#include <array>

// The key codes only: no call of GLFW.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace luminist {
namespace {

constexpr int kCtrl = GLFW_MOD_CONTROL;
constexpr int kShift = GLFW_MOD_SHIFT;
constexpr int kAlt = GLFW_MOD_ALT;

/// What all maps share.
std::vector<KeyBinding> usual() {
  std::vector<KeyBinding> keys = {
      {Deed::kUndo, GLFW_KEY_Z, kCtrl},
      {Deed::kOpen, GLFW_KEY_O, kCtrl},
      {Deed::kSave, GLFW_KEY_S, kCtrl},
      {Deed::kSaveAs, GLFW_KEY_S, kCtrl | kShift},
      {Deed::kQuit, GLFW_KEY_Q, kCtrl},
      {Deed::kSolve, GLFW_KEY_ENTER, kCtrl},
      {Deed::kStop, GLFW_KEY_ESCAPE, 0},
      {Deed::kAccept, GLFW_KEY_ENTER, 0},
      {Deed::kAccept, GLFW_KEY_KP_ENTER, 0},
      {Deed::kRevert, GLFW_KEY_BACKSPACE, 0},
      {Deed::kAddLight, GLFW_KEY_N, 0},
      {Deed::kBrushSmaller, GLFW_KEY_LEFT_BRACKET, 0},
      {Deed::kBrushLarger, GLFW_KEY_RIGHT_BRACKET, 0},
      {Deed::kSwapColors, GLFW_KEY_X, 0},
      {Deed::kDefaultColors, GLFW_KEY_D, 0},
      {Deed::kToolLight, GLFW_KEY_B, 0},
      {Deed::kToolErase, GLFW_KEY_E, 0},
      {Deed::kToolShadow, GLFW_KEY_S, 0},
      {Deed::kToolImportance, GLFW_KEY_I, 0},
      {Deed::kToolEdit, GLFW_KEY_A, 0},
      {Deed::kDeleteStroke, GLFW_KEY_DELETE, 0},
      {Deed::kViewLight, GLFW_KEY_F1, 0},
      {Deed::kViewPaint, GLFW_KEY_F2, 0},
      {Deed::kViewResidual, GLFW_KEY_F3, 0},
      {Deed::kViewImportance, GLFW_KEY_F4, 0},
      {Deed::kWipe, GLFW_KEY_W, 0},
      {Deed::kKeep, GLFW_KEY_K, 0},
      {Deed::kOrbit, GLFW_KEY_V, 0},
      {Deed::kHidePanels, GLFW_KEY_TAB, 0},
      {Deed::kHandles, GLFW_KEY_H, 0},
      {Deed::kDragHighlight, GLFW_KEY_G, 0},
      {Deed::kDragShadow, GLFW_KEY_G, kShift},
      {Deed::kKeys, GLFW_KEY_SLASH, kShift},
      {Deed::kKeys, GLFW_KEY_F12, 0},
  };
  for (int digit = GLFW_KEY_0; digit <= GLFW_KEY_9; ++digit) keys.push_back({Deed::kOpacity, digit, 0});
  return keys;
}

KeyMap map_of(std::string name, std::vector<KeyBinding> own, int pick_mods) {
  KeyMap map{std::move(name), std::move(own), pick_mods};
  const std::vector<KeyBinding> shared = usual();
  map.bindings.insert(map.bindings.end(), shared.begin(), shared.end());
  return map;
}

std::string letter_or_name(int key) {
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return std::string(1, static_cast<char>('A' + key - GLFW_KEY_A));
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return std::string(1, static_cast<char>('0' + key - GLFW_KEY_0));
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  switch (key) {
    case GLFW_KEY_ENTER:
      return "Enter";
    case GLFW_KEY_KP_ENTER:
      return "Keypad Enter";
    case GLFW_KEY_ESCAPE:
      return "Esc";
    case GLFW_KEY_BACKSPACE:
      return "Backspace";
    case GLFW_KEY_DELETE:
      return "Delete";
    case GLFW_KEY_TAB:
      return "Tab";
    case GLFW_KEY_LEFT_BRACKET:
      return "[";
    case GLFW_KEY_RIGHT_BRACKET:
      return "]";
    case GLFW_KEY_SLASH:
      return "/";
    default:
      return "?";
  }
}

}  // namespace

Deed KeyMap::find(int key, int mods) const {
  for (const KeyBinding& binding : bindings) {
    if (binding.key == key && binding.mods == mods) return binding.deed;
  }
  return Deed::kNone;
}

std::string KeyMap::key_of(Deed deed) const {
  for (const KeyBinding& binding : bindings) {
    if (binding.deed == deed) return deed == Deed::kOpacity ? "0 to 9" : key_name(binding.key, binding.mods);
  }
  return "";
}

std::span<const KeyMap> key_maps() {
  static const std::array<KeyMap, 3> maps = {map_of("Krita",
                                                    {{Deed::kRedo, GLFW_KEY_Z, kCtrl | kShift},
                                                     {Deed::kToolPick, GLFW_KEY_P, 0},
                                                     {Deed::kFit, GLFW_KEY_F, 0},
                                                     {Deed::kFullSize, GLFW_KEY_1, kCtrl}},
                                                    kCtrl),
                                             map_of("Photoshop",
                                                    {{Deed::kRedo, GLFW_KEY_Z, kCtrl | kShift},
                                                     {Deed::kToolPick, GLFW_KEY_I, 0},
                                                     {Deed::kToolImportance, GLFW_KEY_M, 0},
                                                     {Deed::kFit, GLFW_KEY_0, kCtrl},
                                                     {Deed::kFullSize, GLFW_KEY_1, kCtrl}},
                                                    kAlt),
                                             map_of("GIMP",
                                                    {{Deed::kRedo, GLFW_KEY_Y, kCtrl},
                                                     {Deed::kToolPick, GLFW_KEY_O, 0},
                                                     {Deed::kToolLight, GLFW_KEY_P, 0},
                                                     {Deed::kToolErase, GLFW_KEY_E, kShift},
                                                     {Deed::kFit, GLFW_KEY_J, kCtrl | kShift},
                                                     {Deed::kFullSize, GLFW_KEY_1, kCtrl}},
                                                    kCtrl)};
  return maps;
}

const char* name_of(Deed deed) {
  static constexpr std::array<const char*, 38> names = {"",
                                                        "Undo",
                                                        "Redo",
                                                        "Open",
                                                        "Save",
                                                        "Save as",
                                                        "Quit",
                                                        "Solve",
                                                        "Stop, or leave what is open",
                                                        "Accept the lights",
                                                        "Revert the lights",
                                                        "Add a light",
                                                        "Smaller brush",
                                                        "Larger brush",
                                                        "Swap colours",
                                                        "White and black",
                                                        "Light brush",
                                                        "Eraser",
                                                        "Shadow brush",
                                                        "Importance brush",
                                                        "Pick a colour",
                                                        "Edit strokes",
                                                        "Delete the stroke",
                                                        "Show the light",
                                                        "Show the paint",
                                                        "Show the residual",
                                                        "Show the importance",
                                                        "Wipe between paint and light",
                                                        "Keep the picture to compare with",
                                                        "The shot from anywhere",
                                                        "Fit the picture",
                                                        "Picture at full size",
                                                        "These keys",
                                                        "Hide the panels",
                                                        "Handles of barn and cutoffs",
                                                        "Drag a highlight",
                                                        "Drag a shadow's edge",
                                                        "Opacity in tenths"};
  return names[static_cast<std::size_t>(deed)];
}

std::string key_name(int key, int mods) {
  if (key == GLFW_KEY_SLASH && mods == kShift) return "?";
  std::string name;
  if ((mods & kCtrl) != 0) name.append("Ctrl+");
  if ((mods & kAlt) != 0) name.append("Alt+");
  if ((mods & kShift) != 0) name.append("Shift+");
  return name.append(letter_or_name(key));
}

}  // namespace luminist
