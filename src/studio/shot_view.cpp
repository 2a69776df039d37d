#include "studio/shot_view.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"
#include "project/frame_paint.h"
#include "project/state_document.h"
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
  const Vantage present = session.vantage();
  const Vantage next{camera_name(camera, session.stage_->camera_names), shot.frame};
  if (next != present) shot.camera = camera;
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
    turn_paint(document, present, next);
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

Result<void> ShotView::look_through(const Vantage& at) {
  Session& session = *session_;
  const Vantage present = session.vantage();
  LUM_TRY(const std::string camera, known_camera(at.camera, session.stage_->camera_names));
  if (camera == present.camera) return session.go_to(at.frame);
  if (!std::isfinite(at.frame)) return Error{ErrorKind::kUsage, "a frame is a number", "", "frame", ""};
  Shot shot = session.shot_;
  shot.camera = camera;
  shot.frame = at.frame;
  LUM_TRY(auto stage, open_stage(*session.device_, session.roots_, shot, session.folder_, *session.diagnostics_,
                                 session.stage_->moving));
  ParamState next = session.state_;
  LUM_TRY_VOID(pose_lights(next.rig, *session.stage_, *stage, at.frame));
  Document document = session.project_.document();
  turn_paint(document, present, {camera, at.frame});
  write_shot(shot, document);
  write_state(next, document);
  const Json action = {{"do", "reframe"}, {"camera", camera}, {"frame", at.frame}};
  LUM_TRY_VOID(session.commit(fmt::format("Look through {} at frame {}", camera, number_text(at.frame)), action.dump(),
                              document));
  session.solved_.reset();
  session.canvas_.reset();
  session.stage_ = std::move(stage);
  session.shot_ = std::move(shot);
  session.state_ = std::move(next);
  session.state_.materials = carried_materials(session.state_.materials, *session.stage_);
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
