#include "studio/shot_view.h"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "project/frame_paint.h"
#include "studio/shots.h"
#include "studio/style_reload.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

}  // namespace

ShotView Session::view() {
  return ShotView(*this);
}

Result<void> ShotView::reframe(const std::string& camera, int width, int height) {
  Session& session = *session_;
  Shot shot = session.shot_;
  const std::vector<std::string>& cameras = session.stage_->camera_names;
  const auto whole = [&](const std::string& name) { return name.empty() && !cameras.empty() ? cameras.front() : name; };
  if (whole(camera) != whole(shot.camera)) shot.camera = camera;
  shot.width = width;
  shot.height = height;
  if (same_stage(shot, session.shot_)) return {};
  LUM_TRY(auto stage, open_stage(*session.device_, session.roots_, shot, session.folder_, *session.diagnostics_,
                                 session.stage_->moving));
  Document document = session.project_.document();
  const bool resized = width != session.shot_.width || height != session.shot_.height;
  const bool loses = resized && !Shots(session).painted().empty();
  if (resized) {
    forget_paint(document);
  } else {
    turn_paint(document, session.vantage(), {whole(camera), shot.frame});
  }
  write_shot(shot, document);
  const std::string label = fmt::format("Look through {}, {} x {}{}", camera.empty() ? "the first camera" : camera,
                                        width, height, loses ? ", without the paint" : "");
  const Json action = {{"do", "reframe"}, {"camera", camera}, {"size", {width, height}}};
  LUM_TRY_VOID(session.commit(label, action.dump(), document));
  session.solved_.reset();
  session.canvas_.reset();
  session.state_.materials = carried_materials(session.state_.materials, *stage);
  session.stage_ = std::move(stage);
  session.shot_ = std::move(shot);
  return {};
}

Result<FreeView*> ShotView::from_anywhere() {
  Session& session = *session_;
  if (!session.free_view_ || session.free_view_of_ != session.stage_->id) {
    session.free_view_.reset();
    LUM_TRY(auto view,
            FreeView::open(*session.device_, session.roots_, session.shot_, session.folder_, *session.diagnostics_));
    session.free_view_ = std::move(view);
    session.free_view_of_ = session.stage_->id;
  }
  return session.free_view_.get();
}

void ShotView::put_away() {
  if (session_->free_view_) session_->free_view_->put_away();
}

}  // namespace luminist
