#pragma once
// app/param_widgets.h -- a widget for every parameter, made from its declaration.
#include <array>
#include <functional>
#include <string>

#include "app/desk.h"
#include "app/range_popup.h"
#include "params/param_block.h"

namespace luminist {

/// A colour that may exceed 1: a swatch, which opens a picker of hue and tint, and its strength beside it. Widgets
/// clamp strength to [0, most].
struct ColorEdit {
  bool changed = false;
  bool done = false;  ///< the hand let go
};
ColorEdit color_field(const Theme& theme, const char* id, Vec3& color, float most, float width);

/// One of these for the window: it holds the value under the hand until a snapshot shows it.
class ParamWidgets {
 public:
  /// Every parameter of a block under headings of its groups: lock, name, widget; the tooltip is the declaration's.
  /// path: "lights/key", "ambient", "style". What is turned is shown at once and recorded when the hand lets go.
  void draw(Desk& desk, const ParamBlock& block, const std::string& path);
  /// Only some of them.
  using Filter = std::function<bool(const ParamSpec&)>;
  void draw(Desk& desk, const ParamBlock& block, const std::string& path, const Filter& filter);

 private:
  using Values = std::array<float, 3>;  ///< in the units of the declaration
  void row(Desk& desk, const ParamBlock& block, int param, const std::string& path);
  void name(Desk& desk, const ParamBlock& block, int param, const std::string& path);
  ColorEdit widget(const Desk& desk, const ParamBlock& block, int param, Values& values, float width);
  void turned(Desk& desk, const ParamSpec& spec, const std::string& path, const Values& values, const ColorEdit& edit);

  std::string held_;  ///< path of the parameter under the hand
  Values held_values_{};
  RangePopup range_;
  std::uint64_t let_go_ = 0;  ///< version of the snapshot when the hand let go; 0: it holds
};

/// What stands left of a widget, in line with the parameters' names. The widget goes on behind it.
void row_label(const Theme& theme, const char* name, const char* words);

/// A lock that shows and turns all degrees of freedom that the patterns name.
void lock_button(Desk& desk, const char* id, int locked, int all, const std::vector<std::string>& patterns, float size);

}  // namespace luminist
