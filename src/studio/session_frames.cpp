// The part of a session that moves through time.
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"
#include "project/paint_document.h"
#include "project/state_document.h"
#include "studio/session.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

/// Light and parameter of what a pattern names; style parameters have no keys.
struct Keyed {
  std::string light;  ///< empty: the ambient
  int param = 0;
};

Result<std::vector<Keyed>> keyed_by(const ParamState& state, const std::string& pattern) {
  LUM_TRY(const std::vector<ParamPlace> places, params_matching(state, pattern));
  std::vector<Keyed> keyed;
  for (const ParamPlace& place : places) {
    if (place.block > state.rig.lights.size()) continue;
    keyed.push_back({place.block == 0 ? "" : state.rig.lights[place.block - 1].name, place.param});
  }
  if (!keyed.empty()) return keyed;
  return Error{ErrorKind::kUsage, fmt::format("\"{}\" is of the style, which has no keys", pattern), "", pattern,
               "name a light, as lights/key/color"};
}

}  // namespace

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
  pose(next.rig, frame);
  Document document = project_.document();
  turn_paint(document, shot_.frame, frame);
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
  LUM_TRY(const std::vector<Keyed> keyed, keyed_by(state_, pattern));
  ParamState next = state_;
  for (const Keyed& each : keyed) set_key(next.rig, each.light, each.param, shot_.frame, interpolation);
  const std::string& word = key_interpolation_words()[static_cast<std::size_t>(interpolation)];
  LUM_TRY_VOID(commit_state(fmt::format("Key {} at frame {}", pattern, number_text(shot_.frame)),
                            Json{{"do", "key"}, {"pattern", pattern}, {"interpolation", word}}.dump(),
                            std::move(next)));
  return static_cast<int>(keyed.size());
}

Result<int> Session::remove_keys(const std::string& pattern) {
  LUM_TRY(const std::vector<Keyed> keyed, keyed_by(state_, pattern));
  ParamState next = state_;
  int count = 0;
  for (const Keyed& each : keyed) count += remove_key(next.rig, each.light, each.param, shot_.frame) ? 1 : 0;
  if (count == 0) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" has no key at frame {}", pattern, number_text(shot_.frame)), "",
                 pattern, "go to a frame with a key"};
  }
  pose(next.rig, shot_.frame);
  LUM_TRY_VOID(commit_state(fmt::format("Remove keys of {} at frame {}", pattern, number_text(shot_.frame)),
                            Json{{"do", "remove_key"}, {"pattern", pattern}}.dump(), std::move(next)));
  return count;
}

}  // namespace luminist
