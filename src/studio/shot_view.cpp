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
  if (camera_name(camera, session.stage_->camera_names) != session.vantage().camera) shot.camera = camera;
  shot.width = width;
  shot.height = height;
  if (same_stage(shot, session.shot_)) return {};
  const bool resized = width != session.shot_.width || height != session.shot_.height;
  const bool loses = resized && !Shots(session).painted().empty();
  const std::string label = fmt::format("Look through {}, {} x {}{}", camera.empty() ? "the first camera" : camera,
                                        width, height, loses ? ", without the paint" : "");
  const Json action = {{"do", "reframe"}, {"camera", camera}, {"size", {width, height}}};
  return show(std::move(shot), label, action.dump());
}

Result<void> ShotView::look_through(const Vantage& at) {
  Session& session = *session_;
  const Vantage present = session.vantage();
  LUM_TRY(const std::string camera, known_camera(at.camera, session.stage_->camera_names));
  if (!std::isfinite(at.frame)) return Error{ErrorKind::kUsage, "a frame is a number", "", "frame", ""};
  if (Vantage{camera, at.frame} == present) return {};
  Shot shot = session.shot_;
  shot.frame = at.frame;
  const std::string frame = number_text(at.frame);
  if (camera == present.camera) {
    return show(std::move(shot), "Go to frame " + frame, Json{{"do", "go_to"}, {"frame", at.frame}}.dump());
  }
  shot.camera = camera;
  const Json action = {{"do", "reframe"}, {"camera", camera}, {"frame", at.frame}};
  return show(std::move(shot), fmt::format("Look through {} at frame {}", camera, frame), action.dump());
}

Result<void> ShotView::show(Shot shot, const std::string& label, const std::string& action) {
  Session& session = *session_;
  Shot at_present = shot;
  at_present.frame = session.shot_.frame;
  std::unique_ptr<Stage> stage;  // null: the session's shows it, too
  if (session.stage_->moving || !same_stage(at_present, session.shot_)) {
    LUM_TRY(stage, open_stage(*session.device_, session.roots_, shot, session.folder_, *session.diagnostics_,
                              session.stage_->moving));
  }
  ParamState next = session.state_;
  LUM_TRY_VOID(pose_lights(next.rig, *session.stage_, stage ? *stage : *session.stage_, shot.frame));
  Document document = session.project_.document();
  if (shot.width != session.shot_.width || shot.height != session.shot_.height) {
    forget_paint(document);
  } else {
    turn_paint(document, session.vantage(), {camera_name(shot.camera, session.stage_->camera_names), shot.frame});
  }
  write_shot(shot, document);
  write_state(next, document);
  LUM_TRY_VOID(session.commit(label, action, document));
  session.solved_.reset();
  session.canvas_.reset();
  if (stage) {
    next.materials = carried_materials(next.materials, *stage);
    session.stage_ = std::move(stage);
  }
  session.shot_ = std::move(shot);
  session.state_ = std::move(next);
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
