#include "studio/shots.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

/// What a pattern names that can have keys.
Result<std::vector<KeyPlace>> keyed_by(const ParamState& state, const std::string& pattern) {
  LUM_TRY(const std::vector<ParamPlace> places, params_matching(state, pattern));
  std::vector<KeyPlace> keyed;
  for (const ParamPlace& place : places) {
    if (place.block > state.rig.lights.size()) continue;
    keyed.push_back({place.block == 0 ? "" : state.rig.lights[place.block - 1].name, place.param, place.component});
  }
  if (!keyed.empty()) return keyed;
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" is of the style or the materials, which have no keys", pattern),
               "", pattern, "name a light, as lights/key/color"};
}

const std::string& word_of(KeyInterpolation interpolation) {
  return key_interpolation_words()[static_cast<std::size_t>(interpolation)];
}

Result<void> check_frame(double frame) {
  if (std::isfinite(frame)) return {};
  return Error{ErrorKind::kUsage, "a frame is a number", "", "frame", ""};
}

}  // namespace

Result<int> Shots::set_keys(const std::string& pattern, KeyInterpolation interpolation) {
  LUM_TRY(const std::vector<KeyPlace> keyed, keyed_by(session_->state_, pattern));
  const double frame = session_->shot_.frame;
  ParamState next = session_->state_;
  for (const KeyPlace& each : keyed) set_key(next.rig, each, frame, interpolation);
  const Json action = {{"do", "key"}, {"pattern", pattern}, {"interpolation", word_of(interpolation)}};
  LUM_TRY_VOID(session_->commit_state(fmt::format("Key {} at frame {}", pattern, number_text(frame)), action.dump(),
                                      std::move(next)));
  return static_cast<int>(keyed.size());
}

template <class Edit>
Result<int> Shots::edit_keys(const std::string& pattern, double frame, const std::string& label,
                             const std::string& action, const Edit& edit) {
  LUM_TRY_VOID(check_frame(frame));
  LUM_TRY(const std::vector<KeyPlace> keyed, keyed_by(session_->state_, pattern));
  ParamState next = session_->state_;
  int count = 0;
  for (const KeyPlace& each : keyed) count += edit(next.rig, each) ? 1 : 0;
  if (count == 0) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" has no key at frame {}", pattern, number_text(frame)), "",
                 pattern, "name a frame with a key"};
  }
  pose(next.rig, session_->shot_.frame);
  LUM_TRY_VOID(session_->commit_state(label, action, std::move(next)));
  return count;
}

Result<int> Shots::remove_keys(const std::string& pattern, double frame) {
  return edit_keys(pattern, frame, fmt::format("Remove keys of {} at frame {}", pattern, number_text(frame)),
                   Json{{"do", "remove_key"}, {"pattern", pattern}, {"frame", frame}}.dump(),
                   [&](LightRig& rig, const KeyPlace& place) { return remove_key(rig, place, frame); });
}

Result<int> Shots::move_keys(const std::string& pattern, double from, double to) {
  LUM_TRY_VOID(check_frame(to));
  return edit_keys(pattern, from,
                   fmt::format("Move keys of {} from frame {} to {}", pattern, number_text(from), number_text(to)),
                   Json{{"do", "move_key"}, {"pattern", pattern}, {"from", from}, {"to", to}}.dump(),
                   [&](LightRig& rig, const KeyPlace& place) { return move_key(rig, place, from, to); });
}

Result<int> Shots::interpolate_keys(const std::string& pattern, double frame, KeyInterpolation interpolation) {
  const std::string& word = word_of(interpolation);
  const Json action = {{"do", "key_interpolation"}, {"pattern", pattern}, {"frame", frame}, {"interpolation", word}};
  return edit_keys(
      pattern, frame, fmt::format("Keys of {} at frame {} go on {}", pattern, number_text(frame), word), action.dump(),
      [&](LightRig& rig, const KeyPlace& place) { return set_interpolation(rig, place, frame, interpolation); });
}

std::vector<PaintedFrame> Shots::painted() const {
  std::vector<PaintedFrame> painted = painted_frames(session_->project_.document(), present());
  const std::vector<std::string>& cameras = session_->stage_->camera_names;
  std::erase_if(painted, [&](const PaintedFrame& each) {
    return each.at.camera != present().camera && std::ranges::find(cameras, each.at.camera) == cameras.end();
  });
  return painted;
}

Result<Vantage> Shots::known(Vantage at) const {
  const std::vector<std::string>& cameras = session_->stage_->camera_names;
  LUM_TRY(at.camera, known_camera(at.camera, cameras));
  return at;
}

Result<void> Shots::clear_paint(Vantage at) {
  LUM_TRY(at, known(std::move(at)));
  if (at == present()) return session_->clear_paint();
  Document document = session_->project_.document();
  const std::string name = vantage_text(at, session_->stage_->camera_names);
  if (!clear_frame_paint(document, present(), at)) {
    return Error{ErrorKind::kNothingToDo, fmt::format("nothing is painted at {}", name), "", "frame", ""};
  }
  return session_->commit(fmt::format("Clear the paint of {}", name),
                          Json{{"do", "clear_paint"}, {"frame", at.frame}, {"camera", at.camera}}.dump(), document);
}

std::string vantage_text(const Vantage& at, std::span<const std::string> cameras) {
  const std::string frame = "frame " + number_text(at.frame);
  return cameras.size() > 1 ? fmt::format("{}, {}", at.camera, frame) : frame;
}

}  // namespace luminist
