#include "app/canvas_panel.h"

#include <cmath>
#include <utility>

#include "app/icons.h"

namespace luminist {
namespace {

/// The share of a picture between two of its borders, on the screen.
void draw_part(ImDrawList& list, const CanvasView& view, ImTextureID texture, float from, float to) {
  const Vec2 size = view.picture_size();
  const Vec2 lo = view.to_screen(Vec2(from * size.x, 0.0F));
  const Vec2 hi = view.to_screen(Vec2(to * size.x, size.y));
  list.AddImage(texture, im(lo), im(hi), {from, 0.0F}, {to, 1.0F});
}

void draw_empty(const Desk& desk, ImDrawList& list, const ScreenRect& rect) {
  const std::string words = desk.activity.label.empty() ? "Open a scene or a project (File menu)"
                                                        : "Working: " + desk.activity.label + " ...";
  const ImVec2 size = ImGui::CalcTextSize(words.c_str());
  const Vec2 center = rect.center();
  list.AddText({center.x - 0.5F * size.x, center.y - 0.5F * size.y}, paint_colors::kDim, words.c_str());
}

}  // namespace

std::string object_at(const ShotFacts& facts, const Vec2& picture) {
  const SurfaceBuffer& surface = facts.surface;
  const int x = static_cast<int>(std::floor(picture.x));
  const int y = static_cast<int>(std::floor(picture.y));
  if (x < 0 || y < 0 || x >= surface.width || y >= surface.height) return "";
  return surface.object_names[surface.object[surface.index(x, y)]];
}

void CanvasPanel::refresh(const Desk& desk, Shown& shown, Channel channel) {
  const StudioSnapshot& now = *desk.now;
  const DisplayOptions display = display_of(channel, desk.display);
  const bool same = !shown.texture.empty() && shown.picture == now.picture && shown.painted == now.painted &&
                    shown.facts == now.facts && shown.unanswered == now.unanswered && shown.channel == channel &&
                    shown.display == display;
  if (same) return;
  if (!table_ || table_->options() != display) table_ = std::make_unique<DisplayTable>(display);
  const Image image = channel_image(now, channel);
  codes_.resize(image.pixels());
  to_display(image, *table_, codes_);
  shown.texture.upload(codes_, image.width, image.height);
  shown.picture = now.picture;
  shown.painted = now.painted;
  shown.facts = now.facts;
  shown.unanswered = now.unanswered;
  shown.channel = channel;
  shown.display = display;
}

/// The picture that was kept, in place of the paint.
void CanvasPanel::refresh_kept(const Desk& desk) {
  if (paint_.picture == desk.kept && paint_.display == desk.display && !paint_.painted) return;
  const DisplayTable table(desk.display);
  codes_.resize(desk.kept->pixels());
  to_display(*desk.kept, table, codes_);
  paint_.texture.upload(codes_, desk.kept->width, desk.kept->height);
  paint_.picture = desk.kept;
  paint_.painted.reset();
  paint_.display = desk.display;
}

/// Dots where a stroke is the uppermost paint.
void CanvasPanel::mark_stroke(const Desk& desk, std::uint32_t stroke) const {
  if (stroke == 0) return;
  const PaintedPictures& painted = *desk.now->painted;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int step = std::max(3, static_cast<int>(7.0F * desk.theme.scale / desk.view.zoom()));
  for (int y = 0; y < painted.color.height; y += step) {
    for (int x = 0; x < painted.color.width; x += step) {
      if (painted.stroke[painted.color.index(x, y)] != stroke) continue;
      list.AddCircleFilled(im(desk.view.to_screen(Vec2(x, y))), desk.theme.px(1.6F), paint_colors::kAccent, 8);
    }
  }
}

void CanvasPanel::draw_pictures(Desk& desk) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Vec2 size = desk.view.picture_size();
  const float border = 1.0F;
  const Vec2 lo = desk.view.to_screen(Vec2(0.0F)) - Vec2(border);
  const Vec2 hi = desk.view.to_screen(size) + Vec2(border);
  list.AddRect(im(lo), im(hi), IM_COL32(20, 20, 20, 255));
  const bool weighs = desk.box.tool() == Tool::kImportance && desk.channel == Channel::kLight;
  refresh(desk, front_, desk.wipe ? Channel::kLight : weighs ? Channel::kWeighed : desk.channel);
  front_.texture.filter(desk.view.zoom());
  if (!desk.wipe) {
    draw_part(list, desk.view, front_.texture.id(), 0.0F, 1.0F);
  } else {
    if (desk.wipe_kept && desk.kept) {
      refresh_kept(desk);
    } else {
      refresh(desk, paint_, Channel::kPaint);
    }
    paint_.texture.filter(desk.view.zoom());
    draw_part(list, desk.view, paint_.texture.id(), 0.0F, desk.wipe_at);
    draw_part(list, desk.view, front_.texture.id(), desk.wipe_at, 1.0F);
    const Vec2 top = desk.view.to_screen(Vec2(desk.wipe_at * size.x, 0.0F));
    const Vec2 bottom = desk.view.to_screen(Vec2(desk.wipe_at * size.x, size.y));
    list.AddLine(im(top), im(bottom), paint_colors::kAccent, desk.theme.px(1.5F));
    list.AddCircleFilled({top.x, 0.5F * (top.y + bottom.y)}, desk.theme.px(6.0F), paint_colors::kAccent);
    list.AddText({top.x - desk.theme.px(44.0F), bottom.y - desk.theme.px(22.0F)}, paint_colors::kText,
                 desk.wipe_kept && desk.kept ? " Kept" : "Paint");
    list.AddText({top.x + desk.theme.px(10.0F), bottom.y - desk.theme.px(22.0F)}, paint_colors::kText, "Light");
  }
  mark_stroke(desk, std::exchange(desk.pointed_stroke, 0));
  if (desk.box.tool() == Tool::kEdit) draw_selected(desk);
  ink_.settle(*desk.now);
  ink_.draw(list, desk.view, desk.now->facts->surface, desk.display.exposure);
}

/// Which way the surface under the pointer faces: what a gradient fades away from.
void CanvasPanel::draw_peak(const Desk& desk, const Vec2& screen) const {
  const ShotFacts& facts = *desk.now->facts;
  const Vec2 at = desk.view.to_picture(screen);
  if (object_at(facts, at).empty()) return;
  const SurfaceBuffer& surface = facts.surface;
  const Vec3 normal = surface.normal[surface.index(static_cast<int>(at.x), static_cast<int>(at.y))];
  const Vec3 seen = glm::transpose(Mat3(facts.camera.world_from_camera)) * normal;
  const Vec2 tip = screen + desk.theme.px(26.0F) * Vec2(seen.x, -seen.y);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine(im(screen), im(tip), IM_COL32(0, 0, 0, 160), desk.theme.px(3.0F));
  list.AddLine(im(screen), im(tip), paint_colors::kAccent, desk.theme.px(1.5F));
  list.AddCircleFilled(im(tip), desk.theme.px(2.5F), paint_colors::kAccent);
}

void CanvasPanel::draw_cursor(const Desk& desk) {
  if (!over_ && grip_ == Grip::kNone) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool picks =
      desk.box.tool() == Tool::kPick || desk.pick_clip || desk.pick_material || (mods_ == desk.keys().pick_mods);
  if (desk.space_down || grip_ == Grip::kPan) return ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  if (grip_ == Grip::kLight || (grip_ == Grip::kNone && handles_.over(desk, pointer_))) {
    return ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  if (desk.box.tool() == Tool::kEdit && !picks) return;  // the arrow
  ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  const Vec2 at = grip_ == Grip::kSize ? grip_at_ : pointer_;
  if (picks) {
    const float arm = desk.theme.px(8.0F);
    for (const auto& [color, width] : {std::pair(IM_COL32(0, 0, 0, 200), 3.0F), std::pair(paint_colors::kText, 1.0F)}) {
      list.AddLine({at.x - arm, at.y}, {at.x + arm, at.y}, color, width);
      list.AddLine({at.x, at.y - arm}, {at.x, at.y + arm}, color, width);
    }
    draw_icon(list, desk.pick_clip || desk.pick_material ? Icon::kTarget : Icon::kDropper,
              {at.x + 2.0F * arm, at.y - 2.0F * arm}, desk.theme.px(16.0F), paint_colors::kText);
    return;
  }
  const Brush& brush = desk.box.brush();
  if (brush.gradient > 0.0F && !brush.screen_gradient && grip_ == Grip::kNone) draw_peak(desk, at);
  const float radius = 0.5F * brush.diameter * desk.view.picture_size().y * desk.view.zoom();
  list.AddCircle(im(at), radius + 1.0F, IM_COL32(0, 0, 0, 140), 0, 1.0F);
  list.AddCircle(im(at), radius, IM_COL32(255, 255, 255, 210), 0, 1.0F);
  list.AddCircleFilled(im(at), desk.theme.px(1.5F), IM_COL32(255, 255, 255, 220));
}

void CanvasPanel::draw(Desk& desk, const ScreenRect& rect, std::span<const HandEvent> events) {
  ImGui::SetNextWindowPos(im(rect.lo));
  ImGui::SetNextWindowSize(im(rect.size()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, paint_colors::kDesk);
  ImGui::Begin("canvas", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::InvisibleButton("hand", im(rect.size()));  // owns what is dragged from here
  const bool hovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (!desk.has_shot()) {
    draw_empty(desk, *ImGui::GetWindowDrawList(), rect);
  } else {
    desk.view.place(rect, desk.now->painted->color.width, desk.now->painted->color.height);
    for (const HandEvent& event : events) take(desk, event, hovered);
    send_points(desk);
    over_ = hovered;
    draw_pictures(desk);
    if (desk.show_panels) handles_.draw(desk);
    draw_cursor(desk);
  }
  desk.hand_down = grip_ == Grip::kStroke;
  ImGui::End();
}

}  // namespace luminist
