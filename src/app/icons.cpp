#include "app/icons.h"

#include <array>
#include <cmath>

#include <imgui_internal.h>  // how long an item is hovered

namespace luminist {
namespace {

/// Draws in units of half the icon's size around its centre.
class IconPen {
 public:
  IconPen(ImDrawList& list, const ImVec2& center, float size, ImU32 color)
      : list_(&list), center_(center), unit_(0.5F * size), color_(color), width_(std::max(1.2F, size / 12.0F)) {}

  [[nodiscard]] ImVec2 at(float x, float y) const { return {center_.x + x * unit_, center_.y + y * unit_}; }
  void line(float x0, float y0, float x1, float y1) { list_->AddLine(at(x0, y0), at(x1, y1), color_, width_); }
  void circle(float x, float y, float r) { list_->AddCircle(at(x, y), r * unit_, color_, 24, width_); }
  void disc(float x, float y, float r) { list_->AddCircleFilled(at(x, y), r * unit_, color_, 24); }
  void box(float x0, float y0, float x1, float y1) { list_->AddRect(at(x0, y0), at(x1, y1), color_, 1.5F, 0, width_); }
  void block(float x0, float y0, float x1, float y1) { list_->AddRectFilled(at(x0, y0), at(x1, y1), color_, 1.5F); }
  void arc(float x, float y, float r, float from, float to) {
    list_->PathArcTo(at(x, y), r * unit_, from, to, 20);
    list_->PathStroke(color_, 0, width_);
  }
  void rays(float inner, float outer) {
    for (int i = 0; i < 8; ++i) {
      const float a = 0.785398F * static_cast<float>(i);
      line(inner * std::cos(a), inner * std::sin(a), outer * std::cos(a), outer * std::sin(a));
    }
  }
  void half_disc(float r) {
    list_->PathArcTo(center_, r * unit_, 1.5708F, 4.7124F, 20);
    list_->PathFillConvex(color_);
  }
  void letter(const char* text) {
    const ImVec2 size = ImGui::CalcTextSize(text);
    list_->AddText({center_.x - 0.5F * size.x, center_.y - 0.5F * size.y}, color_, text);
  }

 private:
  ImDrawList* list_;
  ImVec2 center_;
  float unit_;
  ImU32 color_;
  float width_;
};

constexpr float kTurn = 6.28318F;

void draw_lock(IconPen& pen, Icon icon) {
  if (icon == Icon::kOpen) {
    pen.arc(0.0F, -0.2F, 0.35F, 0.5F * kTurn, 0.92F * kTurn);
    pen.box(-0.55F, -0.05F, 0.55F, 0.75F);
    return;
  }
  pen.arc(0.0F, -0.15F, 0.35F, 0.5F * kTurn, kTurn);
  if (icon == Icon::kLocked) {
    pen.block(-0.55F, -0.1F, 0.55F, 0.75F);
  } else {
    pen.box(-0.55F, -0.05F, 0.55F, 0.75F);
    pen.block(-0.5F, 0.3F, 0.5F, 0.7F);
  }
}

void draw_tool(IconPen& pen, Icon icon) {
  switch (icon) {
    case Icon::kSun:
      pen.circle(0, 0, 0.36F), pen.rays(0.58F, 0.9F);
      break;
    case Icon::kBrighten:
      pen.disc(-0.2F, 0.15F, 0.42F), pen.line(0.3F, -0.55F, 0.9F, -0.55F), pen.line(0.6F, -0.85F, 0.6F, -0.25F);
      break;
    case Icon::kDarken:
      pen.circle(-0.2F, 0.15F, 0.42F), pen.line(0.3F, -0.55F, 0.9F, -0.55F);
      break;
    case Icon::kShadow:
      pen.circle(0, 0, 0.7F), pen.half_disc(0.7F);
      break;
    case Icon::kLift:
      pen.circle(0, 0, 0.7F), pen.line(-0.75F, 0.75F, 0.75F, -0.75F);
      break;
    case Icon::kCopy:
      pen.box(-0.7F, -0.7F, 0.3F, 0.3F), pen.box(-0.3F, -0.3F, 0.7F, 0.7F);
      break;
    case Icon::kErase:
      pen.line(-0.75F, 0.2F, 0.1F, -0.65F), pen.line(0.1F, -0.65F, 0.7F, -0.05F), pen.line(0.7F, -0.05F, 0.05F, 0.6F);
      pen.line(-0.75F, 0.2F, -0.35F, 0.6F), pen.line(-0.35F, 0.6F, 0.8F, 0.6F), pen.line(-0.35F, -0.2F, 0.3F, 0.4F);
      break;
    case Icon::kTarget:
      pen.circle(0, 0, 0.75F), pen.circle(0, 0, 0.4F), pen.disc(0, 0, 0.12F);
      break;
    case Icon::kDropper:
      pen.line(-0.75F, 0.75F, 0.25F, -0.25F), pen.line(0.0F, -0.5F, 0.5F, 0.0F), pen.disc(0.5F, -0.5F, 0.25F);
      break;
    default:
      break;
  }
}

}  // namespace

Icon icon_of(Tool tool) {
  static constexpr std::array<Icon, kTools> icons = {Icon::kSun,     Icon::kBrighten, Icon::kDarken, Icon::kShadow,
                                                     Icon::kLift,    Icon::kCopy,     Icon::kErase,  Icon::kTarget,
                                                     Icon::kDropper, Icon::kArrow};
  return icons[static_cast<std::size_t>(tool)];
}

void draw_icon(ImDrawList& list, Icon icon, const ImVec2& center, float size, ImU32 color) {
  IconPen pen(list, center, size, color);
  switch (icon) {
    case Icon::kLocked:
    case Icon::kOpen:
    case Icon::kPartly:
      draw_lock(pen, icon);
      break;
    case Icon::kEye:
    case Icon::kEyeOff:
      pen.arc(0.0F, 0.55F, 0.95F, 0.625F * kTurn, 0.875F * kTurn);
      if (icon == Icon::kEye) pen.arc(0.0F, -0.55F, 0.95F, 0.125F * kTurn, 0.375F * kTurn), pen.disc(0, 0, 0.25F);
      if (icon == Icon::kEyeOff) pen.line(-0.7F, 0.6F, 0.7F, -0.6F);
      break;
    case Icon::kSolo:
      pen.letter("S");
      break;
    case Icon::kPlus:
      pen.line(-0.6F, 0, 0.6F, 0), pen.line(0, -0.6F, 0, 0.6F);
      break;
    case Icon::kMore:
      pen.disc(-0.6F, 0, 0.14F), pen.disc(0, 0, 0.14F), pen.disc(0.6F, 0, 0.14F);
      break;
    case Icon::kFolded:
      pen.line(-0.2F, -0.45F, 0.25F, 0), pen.line(0.25F, 0, -0.2F, 0.45F);
      break;
    case Icon::kUnfolded:
      pen.line(-0.45F, -0.2F, 0, 0.25F), pen.line(0, 0.25F, 0.45F, -0.2F);
      break;
    case Icon::kUp:
    case Icon::kDown: {
      const float up = icon == Icon::kUp ? 1.0F : -1.0F;
      pen.line(-0.6F, 0.3F * up, 0, -0.35F * up), pen.line(0, -0.35F * up, 0.6F, 0.3F * up);
      break;
    }
    case Icon::kMerge:
      pen.line(0, -0.8F, 0, 0.25F), pen.line(-0.4F, -0.15F, 0, 0.25F), pen.line(0, 0.25F, 0.4F, -0.15F);
      pen.line(-0.7F, 0.7F, 0.7F, 0.7F);
      break;
    case Icon::kArrow:
      pen.line(-0.45F, -0.8F, -0.45F, 0.55F), pen.line(-0.45F, 0.55F, -0.1F, 0.2F), pen.line(-0.1F, 0.2F, 0.2F, 0.8F);
      pen.line(-0.45F, -0.8F, 0.55F, 0.15F), pen.line(0.55F, 0.15F, -0.1F, 0.2F);
      break;
    case Icon::kBucket:
      pen.line(-0.7F, -0.1F, 0.1F, -0.8F), pen.line(0.1F, -0.8F, 0.7F, -0.1F), pen.line(0.7F, -0.1F, -0.1F, 0.6F);
      pen.line(-0.1F, 0.6F, -0.7F, -0.1F), pen.disc(0.72F, 0.5F, 0.18F);
      break;
    default:
      draw_tool(pen, icon);
  }
}

bool icon_button(const Theme& theme, const char* id, Icon icon, float size, bool active, const char* tip_text) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool clicked = ImGui::InvisibleButton(id, {size, size});
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered || active) {
    const ImU32 back = ImGui::GetColorU32(hovered ? ImGuiCol_ButtonHovered : ImGuiCol_Button);
    list.AddRectFilled(at, {at.x + size, at.y + size}, back, theme.px(3.0F));
  }
  const ImU32 color = active ? paint_colors::kAccent : hovered ? paint_colors::kText : IM_COL32(176, 176, 176, 255);
  draw_icon(list, icon, {at.x + 0.5F * size, at.y + 0.5F * size}, 0.56F * size, color);
  tip(theme, tip_text);
  return clicked;
}

void tip(const Theme& theme, const char* text) {
  constexpr float kWait = 0.5F;  // seconds that the pointer rests on an item
  if (*text == '\0' || !ImGui::IsItemHovered() || ImGui::GetCurrentContext()->HoveredIdTimer < kWait) return;
  // Below the item, or above it in the lower half of the window: it must not cover what it explains.
  const ImVec2 lo = ImGui::GetItemRectMin();
  const ImVec2 hi = ImGui::GetItemRectMax();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const bool low = lo.y > 0.6F * display.y;
  const bool right = lo.x > 0.6F * display.x;
  const float gap = theme.px(5.0F);
  ImGui::SetNextWindowPos({right ? std::min(hi.x, display.x - gap) : lo.x, low ? lo.y - gap : hi.y + gap},
                          ImGuiCond_Always, {right ? 1.0F : 0.0F, low ? 1.0F : 0.0F});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(theme.px(320.0F));
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace luminist
