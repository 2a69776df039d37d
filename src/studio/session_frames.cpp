// The part of a session that moves through time.
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "params/param_text.h"
#include "project/frame_paint.h"
#include "project/state_document.h"
#include "studio/session.h"
#include "studio/shots.h"

namespace luminist {

using Json = nlohmann::json;

Result<void> Session::go_to(double frame) {
  if (!std::isfinite(frame)) return Error{ErrorKind::kUsage, "a frame is a number", "", "frame", ""};
  if (frame == shot_.frame) return {};
  Shot shot = shot_;
  shot.frame = frame;
  std::unique_ptr<Stage> stage;
  if (stage_->moving) {
    LUM_TRY(stage, open_stage(*device_, roots_, shot, folder_, *diagnostics_, stage_->moving));
  }
  ParamState next = state_;
  LUM_TRY_VOID(pose_lights(next.rig, *stage_, stage ? *stage : *stage_, frame));
  Document document = project_.document();
  turn_paint(document, vantage(), {vantage().camera, frame});
  write_shot(shot, document);
  write_state(next, document);
  LUM_TRY_VOID(commit("Go to frame " + number_text(frame), Json{{"do", "go_to"}, {"frame", frame}}.dump(), document));
  solved_.reset();
  canvas_.reset();
  if (stage) stage_ = std::move(stage);
  shot_ = std::move(shot);
  state_ = std::move(next);
  return {};
}

Result<int> Session::set_keys(const std::string& pattern, KeyInterpolation interpolation) {
  return Shots(*this).set_keys(pattern, interpolation);
}

Result<int> Session::remove_keys(const std::string& pattern) {
  return Shots(*this).remove_keys(pattern, shot_.frame);
}

}  // namespace luminist
