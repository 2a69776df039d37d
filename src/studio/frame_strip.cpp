#include "studio/frame_strip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "params/param_text.h"
#include "studio/shots.h"

namespace luminist {
namespace {

constexpr double kPixels = 40'000.0;      // about 230 x 170: enough to see light by, a tenth of a shot's work
constexpr double kPathPixels = 14'000.0;  // about 137 x 102; paths cost more
constexpr double kPathSamples = 6.0;      // paths a pixel
constexpr int kStripHeight = 64;          // pixels
constexpr std::size_t kFewestStages = 4;

std::string shot_text(const Shot& shot) {
  return fmt::format("{}|{}{}|{}|{}x{}|{}|{}", shot.scene, shot.scene_options.floor, shot.scene_options.wall,
                     shot.camera, shot.width, shot.height, shot.style, shot.fps);
}

/// The same for the same lights, whatever frame they are posed at.
std::string lights_text(const ParamState& lights) {
  LightRig rig = lights.rig;
  pose(rig, 0.0);
  return rig_to_toml(rig) + block_to_json(lights.style).dump() + material_bytes(lights);
}

Shot small_shot(const Shot& shot, bool paths, double frame) {
  Shot small = shot;
  const double scale =
      std::min(1.0, std::sqrt((paths ? kPathPixels : kPixels) / (static_cast<double>(shot.width) * shot.height)));
  small.width = std::max(1, static_cast<int>(std::lround(scale * shot.width)));
  small.height = std::max(1, static_cast<int>(std::lround(scale * shot.height)));
  small.frame = frame;
  return small;
}

/// A style's numbers for a path-traced picture that is made while somebody waits: few paths, smoothed.
void hurry(ParamBlock& style) {
  if (const auto samples = style.schema().by_role("samples")) {
    style.set(*samples, 0, std::min(style.get(*samples), kPathSamples));
  }
  if (const auto denoise = style.schema().by_role("denoise")) style.set(*denoise, 0, 1.0);
}

}  // namespace

void FrameStrip::attend(const Session& session) {
  std::string shot = shot_text(session.shot());
  if (shot == shot_) return;
  shot_ = std::move(shot);
  stages_.clear();
  drawn_.clear();
  preview_.reset();
}

Result<const Stage*> FrameStrip::stage_at(Session& session, double frame) {
  const bool still = session.stage().moving == nullptr;
  auto found =
      std::find_if(stages_.begin(), stages_.end(), [&](const Kept& kept) { return still || kept.frame == frame; });
  if (found == stages_.end()) {
    const Shot small = small_shot(session.shot(), session.stage().paths != nullptr, frame);
    Diagnostics told_already;
    Kept kept{frame, nullptr};
    LUM_TRY(kept.stage, open_stage(*device_, roots_, small, session.project().folder().parent_path(), told_already,
                                   session.stage().moving));
    const std::size_t most = std::max(kFewestStages, static_cast<std::size_t>(pictures_) + 2);
    if (stages_.size() >= most) stages_.erase(stages_.begin());
    stages_.push_back(std::move(kept));
  } else {
    std::rotate(found, found + 1, stages_.end());
  }
  return stages_.back().stage.get();
}

Result<Image> FrameStrip::draw(Session& session, const ParamState& lights, double frame) {
  LUM_TRY(const Stage* stage, stage_at(session, frame));
  ParamState posed = lights;
  LUM_TRY_VOID(pose_lights(posed.rig, session.stage(), *stage, frame));
  if (stage->paths != nullptr) hurry(posed.style);
  return stage->renderer->render(posed);
}

std::vector<double> FrameStrip::wanted(const Session& session) const {
  std::vector<double> frames;
  for (int k = 0; static_cast<int>(frames.size()) < pictures_ && k <= pictures_; ++k) {
    for (const int side : {1, -1}) {
      const double frame = session.shot().frame + side * k * step_;
      if ((k > 0 || side > 0) && frame >= 0.0 && static_cast<int>(frames.size()) < pictures_) frames.push_back(frame);
    }
  }
  return frames;
}

Result<bool> FrameStrip::step(Session& session, const ParamState& lights) {
  attend(session);
  if (pictures_ <= 0) return false;
  lights_ = lights_text(lights);
  if (failed_ == shot_ + lights_) return false;
  for (const double frame : wanted(session)) {
    const auto found =
        std::find_if(drawn_.begin(), drawn_.end(), [&](const Drawn& each) { return each.frame == frame; });
    if (found != drawn_.end() && found->lights == lights_) continue;
    failed_ = shot_ + lights_;  // until it went well
    LUM_TRY(const Image picture, draw(session, lights, frame));
    failed_.clear();
    const int height = std::min(kStripHeight, picture.height);
    const int width = std::max(1, height * picture.width / picture.height);
    Drawn drawn{frame, lights_, std::make_shared<const Image>(resized(picture, width, height))};
    if (found != drawn_.end()) {
      *found = std::move(drawn);
    } else {
      drawn_.push_back(std::move(drawn));
    }
    return true;
  }
  return false;
}

Result<void> FrameStrip::preview(Session& session, const ParamState& lights, double frame) {
  attend(session);
  Preview next{frame, lights, nullptr};
  pose(next.lights.rig, frame);
  LUM_TRY(Image picture, draw(session, next.lights, frame));
  next.picture = std::make_shared<const Image>(std::move(picture));
  preview_ = std::move(next);
  return {};
}

void FrameStrip::tell(Session& session, StudioSnapshot& next) const {
  FrameFacts facts = frame_facts(session);
  const std::vector<double> frames = wanted(session);
  const bool of_shot = shot_text(session.shot()) == shot_;
  for (const Drawn& drawn : drawn_) {
    if (!of_shot || std::find(frames.begin(), frames.end(), drawn.frame) == frames.end()) continue;
    facts.strip.push_back({drawn.frame, drawn.picture, drawn.lights != lights_});
  }
  std::sort(facts.strip.begin(), facts.strip.end(), [](const auto& a, const auto& b) { return a.frame < b.frame; });
  if (preview_ && of_shot) {
    facts.previewed = preview_->frame;
    next.picture = preview_->picture;
    next.shown = std::make_shared<const ParamState>(preview_->lights);
    next.unanswered = 0;  // its paint is of another frame
  }
  next.frames = std::make_shared<const FrameFacts>(std::move(facts));
}

FrameFacts frame_facts(Session& session) {
  const Shot& shot = session.shot();
  FrameFacts facts;
  facts.camera = Shots(session).present().camera;
  facts.frame = shot.frame;
  facts.fps = shot.fps;
  facts.moving = session.stage().moving != nullptr;
  facts.painted = Shots(session).painted();
  std::vector<double> frames = key_frames(session.shown().rig, "*");
  for (const PaintedFrame& painted : facts.painted) frames.push_back(painted.at.frame);
  frames.push_back(shot.frame);
  frames.push_back(facts.moving ? session.stage().moving->animation.seconds() * shot.fps : 2.0 * shot.fps);
  constexpr double kMost = 1e6;  // frames: more have no place on a ruler
  const auto whole = [&](double frame) { return static_cast<int>(std::clamp(frame, -kMost, kMost)); };
  facts.first = std::min(0, whole(std::floor(*std::min_element(frames.begin(), frames.end()))));
  facts.last = whole(std::ceil(*std::max_element(frames.begin(), frames.end()) - 1e-6));
  if (const Solved* solved = session.solved(); solved != nullptr && session.has_proposal()) {
    for (const SolvedFrame& each : solved->frames) {
      facts.solved.push_back({each.at, each.weight, each.start, each.found, each.verdict, {}});
    }
  }
  return facts;
}

}  // namespace luminist
