#include "app/brush_box.h"

#include <algorithm>

namespace luminist {
namespace {

constexpr std::array<ToolFacts, kTools> kToolFacts = {{
    {"Light", "Paint the light you want to see.", PaintTool::kColor},
    {"Brighten", "Make what is there brighter, by stops.", PaintTool::kBrighten},
    {"Darken", "Make what is there darker, by stops.", PaintTool::kDarken},
    {"Shadow", "Paint a shadow: the picture as it is without the lights that may change.", PaintTool::kShadow},
    {"Lift shadow", "Take a shadow away: the picture with all lights on and no shadows.", PaintTool::kShadowEraser},
    {"Copy", "Paint with an image that was edited elsewhere.", PaintTool::kCopy},
    {"Erase", "Take paint away; what was there comes back.", PaintTool::kErase},
    {"Importance", "Say how much a place counts for the solver.", PaintTool::kImportance},
    {"Pick colour", "Take a colour from the picture.", PaintTool::kColor},
    {"Edit strokes", "Click a stroke to change it, drag it to move it.", PaintTool::kColor},
}};

constexpr float kLeastDiameter = 0.004F;  // picture heights: a few pixels
constexpr float kMostDiameter = 2.0F;

}  // namespace

const ToolFacts& facts_of(Tool tool) {
  return kToolFacts[static_cast<std::size_t>(tool)];
}

BrushBox::BrushBox() {
  for (int i = 0; i < kTools; ++i) {
    Brush& brush = brushes_[static_cast<std::size_t>(i)];
    brush.tool = facts_of(static_cast<Tool>(i)).paint;
    brush.diameter = 0.15F;
    brush.clip.assign(1, '@');  // light seldom runs over an object's edge
  }
  // Light behaves like light: it fades as the surface turns away, and never darkens.
  Brush& light = brushes_[static_cast<std::size_t>(Tool::kLight)];
  light.gradient = 1.0F;
  light.add_light = true;
  brushes_[static_cast<std::size_t>(Tool::kErase)].clip = "";
  brushes_[static_cast<std::size_t>(Tool::kImportance)].clip = "";
  colors_ = {Vec3(1.25F, 1.1F, 0.85F), Vec3(0.0F)};
  palette_ = {{1.25F, 1.1F, 0.85F}, {1.0F, 1.0F, 1.0F},    {2.5F, 2.4F, 2.2F},    {1.3F, 0.85F, 0.12F},
              {1.4F, 0.5F, 0.15F},  {0.9F, 0.16F, 0.08F},  {0.16F, 0.38F, 1.3F},  {0.35F, 0.6F, 0.9F},
              {0.2F, 0.55F, 0.4F},  {0.55F, 0.25F, 0.75F}, {0.25F, 0.25F, 0.28F}, {0.02F, 0.02F, 0.03F}};
}

void BrushBox::take(Tool tool) {
  if (tool == tool_) return;
  last_ = tool_;
  tool_ = tool;
}

Brush BrushBox::ready() const {
  Brush brush = this->brush();
  brush.color = color();
  return brush;
}

void BrushBox::scale_diameter(float factor) {
  brush().diameter = std::clamp(brush().diameter * factor, kLeastDiameter, kMostDiameter);
}

}  // namespace luminist
