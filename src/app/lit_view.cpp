#include "app/lit_view.h"

#include <utility>

#include "app/display.h"
#include "rig/light_links.h"
#include "studio/shot_view.h"

namespace luminist {
namespace {

/// Equal for lights and styles that make equal pictures: every snapshot has a state of its own.
std::string signature_of(const ParamState& state) {
  std::string signature = link_signature(state.rig) + state.rig.shadow_light;
  for (const ParamBlock* block : state.blocks()) {
    const auto bytes = block->bytes();
    signature.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  for (const Light& light : state.rig.lights) signature += light.muted ? '0' : '1';
  return signature;
}

bool same(const LitView::Wish& one, const LitView::Wish& other) {
  return one.width == other.width && one.height == other.height && one.signature == other.signature &&
         one.camera.world_from_camera == other.camera.world_from_camera && one.camera.fov_y == other.camera.fov_y;
}

}  // namespace

void LitView::ask_solid(Desk& desk) {
  if (waiting_ || unreadable_) return;
  waiting_ = true;
  asked_ = {};
  answer_ = std::make_shared<Answer>();
  desk.studio->post_patiently("read the scene", [answer = answer_](Workbench& bench) -> Result<void> {
    if (!bench.has_session()) return {};
    auto view = bench.session().view().from_anywhere();
    const std::lock_guard lock(answer->mutex);
    answer->done = true;
    answer->unreadable = !view;
    if (!view) return std::move(view).error();
    answer->solid = (*view)->solid();
    return {};
  });
}

void LitView::ask(Desk& desk, Wish wish) {
  if (waiting_) return;
  wish.signature = signature_of(*wish.lights);
  if (same(wish, asked_)) return;
  waiting_ = true;
  asked_ = wish;
  answer_ = std::make_shared<Answer>();
  // Only looked at: whatever is under way in the session, a slider that is held as well, goes on.
  desk.studio->post_patiently("light the view", [answer = answer_, wish](Workbench& bench) -> Result<void> {
    if (!bench.has_session()) return {};
    const auto picture = [&]() -> Result<Image> {
      LUM_TRY(FreeView * view, bench.session().view().from_anywhere());
      return view->picture(wish.camera, wish.width, wish.height, *wish.lights);
    };
    auto drawn = picture();
    const std::lock_guard lock(answer->mutex);
    answer->done = true;
    if (!drawn) return std::move(drawn).error();
    answer->picture = std::make_shared<const Image>(std::move(*drawn));
    return {};
  });
}

void LitView::put_away(Desk& desk) {
  desk.studio->post_patiently("put the view away", [](Workbench& bench) -> Result<void> {
    if (bench.has_session()) bench.session().view().put_away();
    return {};
  });
}

void LitView::take(const Desk& desk) {
  if (waiting_) {
    const std::lock_guard lock(answer_->mutex);
    // A job that was dropped, because the session is opened again, never answers.
    const bool dropped = desk.activity.label.empty() && desk.activity.waiting == 0 && !answer_->done && overdue_++ > 30;
    if (answer_->done || dropped) {
      waiting_ = false;
      overdue_ = 0;
      unreadable_ = unreadable_ || answer_->unreadable;
      if (answer_->solid) solid_ = answer_->solid;
      if (answer_->picture) {
        picture_ = answer_->picture;
        shown_ = asked_;
        show(desk);
      }
    }
  }
  if (picture_ && display_ != desk.display) show(desk);
}

void LitView::show(const Desk& desk) {
  display_ = desk.display;
  const DisplayTable table(display_);
  codes_.resize(picture_->pixels());
  to_display(*picture_, table, codes_);
  texture_.upload(codes_, picture_->width, picture_->height);
}

bool LitView::shows(const Camera& camera) const {
  return shown_ && shown_->camera.world_from_camera == camera.world_from_camera && shown_->camera.fov_y == camera.fov_y;
}

void LitView::forget() {
  waiting_ = false;  // what is on its way shows the other shot
  unreadable_ = false;
  answer_.reset();
  shown_.reset();
  picture_.reset();
  solid_.reset();
  asked_ = {};
}

}  // namespace luminist
