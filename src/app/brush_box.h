#pragma once
// app/brush_box.h -- the brushes at hand: each tool keeps its own settings.
#include <array>
#include <span>
#include <string>
#include <vector>

#include "paint/brush.h"

namespace luminist {

/// What the hand holds, in the order of the tool strip.
enum class Tool { kLight, kBrighten, kDarken, kShadow, kShadowEraser, kCopy, kErase, kImportance, kPick, kEdit };
inline constexpr int kTools = 10;

struct ToolFacts {
  const char* name;
  const char* doc;
  PaintTool paint;  ///< of what paints; kPick and kEdit do not
};
const ToolFacts& facts_of(Tool tool);

class BrushBox {
 public:
  BrushBox();

  [[nodiscard]] Tool tool() const { return tool_; }
  void take(Tool tool);
  /// The tool before the last take(): what an eyedropper goes back to.
  void take_last() { take(last_); }
  [[nodiscard]] Brush& brush() { return brushes_[static_cast<std::size_t>(tool_)]; }
  [[nodiscard]] const Brush& brush() const { return brushes_[static_cast<std::size_t>(tool_)]; }
  /// With the colour in front, ready to paint with.
  [[nodiscard]] Brush ready() const;

  // Colours are the box's, whatever the tool: linear, may exceed 1.
  [[nodiscard]] const Vec3& color() const { return colors_[0]; }
  [[nodiscard]] const Vec3& other_color() const { return colors_[1]; }
  void set_color(const Vec3& color) { colors_[0] = color; }
  void swap_colors() { std::swap(colors_[0], colors_[1]); }
  void default_colors() { colors_ = {Vec3(1.0F), Vec3(0.0F)}; }
  /// A key light's warm white, sky blues, embers... and what was added by hand.
  [[nodiscard]] std::vector<Vec3>& palette() { return palette_; }

  /// How much the hand is steadied: 0 not at all, towards 1 the stroke trails behind the pointer.
  [[nodiscard]] float& steadiness() { return steadiness_; }
  void scale_diameter(float factor);
  void set_opacity(float opacity) { brush().opacity = std::clamp(opacity, 0.0F, 1.0F); }

 private:
  Tool tool_ = Tool::kLight;
  Tool last_ = Tool::kLight;
  std::array<Brush, kTools> brushes_;
  std::array<Vec3, 2> colors_{Vec3(1.0F), Vec3(0.0F)};
  std::vector<Vec3> palette_;
  float steadiness_ = 0.0F;
};

}  // namespace luminist
