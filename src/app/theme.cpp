#include "app/theme.h"

#include <array>
#include <cmath>
#include <filesystem>

namespace luminist {
namespace {

/// Latin, punctuation, arrows and the Greek that the paper's symbols need.
constexpr std::array<ImWchar, 13> kGlyphs = {0x20,   0xFF,   0x0370, 0x03FF, 0x2010, 0x2027, 0x2190,
                                             0x2193, 0x2212, 0x2212, 0x2713, 0x2713, 0};

ImFont* load(const std::array<const char*, 2>& files, float size_px) {
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  config.GlyphRanges = kGlyphs.data();
  std::error_code error;
  for (const char* file : files) {
    if (!std::filesystem::exists(file, error)) continue;
    if (ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(file, size_px, &config)) return font;
  }
  return nullptr;
}

ImVec4 grey(float value, float alpha = 1.0F) {
  return {value, value, value, alpha};
}

void set_colors(ImGuiStyle& style) {
  const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(paint_colors::kAccent);
  const auto tint = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = grey(0.84F);
  c[ImGuiCol_TextDisabled] = grey(0.5F);
  c[ImGuiCol_WindowBg] = grey(0.185F);
  c[ImGuiCol_ChildBg] = grey(0.0F, 0.0F);
  c[ImGuiCol_PopupBg] = grey(0.16F, 0.98F);
  c[ImGuiCol_Border] = grey(0.1F, 0.8F);
  c[ImGuiCol_FrameBg] = grey(0.135F);
  c[ImGuiCol_FrameBgHovered] = grey(0.16F);
  c[ImGuiCol_FrameBgActive] = grey(0.12F);
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = c[ImGuiCol_TitleBgCollapsed] = grey(0.15F);
  c[ImGuiCol_MenuBarBg] = grey(0.15F);
  c[ImGuiCol_ScrollbarBg] = grey(0.0F, 0.0F);
  c[ImGuiCol_ScrollbarGrab] = grey(0.32F);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = grey(0.42F);
  c[ImGuiCol_CheckMark] = accent;
  c[ImGuiCol_SliderGrab] = grey(1.0F, 0.14F);  // digits are read through it
  c[ImGuiCol_SliderGrabActive] = tint(0.4F);
  c[ImGuiCol_Button] = grey(0.25F);
  c[ImGuiCol_ButtonHovered] = grey(0.31F);
  c[ImGuiCol_ButtonActive] = grey(0.2F);
  c[ImGuiCol_Header] = grey(0.24F);
  c[ImGuiCol_HeaderHovered] = grey(0.28F);
  c[ImGuiCol_HeaderActive] = grey(0.26F);
  c[ImGuiCol_Separator] = grey(0.11F);
  c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = tint(0.6F);
  c[ImGuiCol_Tab] = grey(0.185F);
  c[ImGuiCol_TabHovered] = grey(0.28F);
  c[ImGuiCol_TabActive] = grey(0.25F);
  c[ImGuiCol_TabUnfocused] = grey(0.185F);
  c[ImGuiCol_TabUnfocusedActive] = grey(0.25F);
  c[ImGuiCol_PlotLines] = c[ImGuiCol_PlotHistogram] = accent;
  c[ImGuiCol_TextSelectedBg] = tint(0.35F);
  c[ImGuiCol_NavHighlight] = tint(0.0F);
  c[ImGuiCol_ModalWindowDimBg] = grey(0.05F, 0.6F);
}

}  // namespace

Theme make_theme(float scale) {
  Theme theme;
  theme.scale = scale;
  const auto size = [&](float points) { return std::round(points * scale); };
  theme.text =
      load({"/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"},
           size(14.0F));
  theme.strong = load(
      {"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
      size(14.0F));
  theme.small =
      load({"/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"},
           size(12.0F));
  if (theme.text == nullptr) theme.text = ImGui::GetIO().Fonts->AddFontDefault();
  if (theme.strong == nullptr) theme.strong = theme.text;
  if (theme.small == nullptr) theme.small = theme.text;
  ImGui::GetIO().MouseDoubleClickTime = 0.5F;  // frames may be slow where the processor draws them
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {10.0F, 8.0F};
  style.FramePadding = {7.0F, 4.0F};
  style.ItemSpacing = {7.0F, 6.0F};
  style.ItemInnerSpacing = {6.0F, 4.0F};
  style.IndentSpacing = 14.0F;
  style.ScrollbarSize = 11.0F;
  style.GrabMinSize = 9.0F;
  style.WindowBorderSize = 0.0F;
  style.ChildBorderSize = 0.0F;
  style.PopupBorderSize = 1.0F;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = style.TabRounding = 3.0F;
  style.ScrollbarRounding = 6.0F;
  style.WindowRounding = 0.0F;
  style.ScaleAllSizes(scale);
  set_colors(style);
  return theme;
}

}  // namespace luminist
