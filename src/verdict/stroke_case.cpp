#include "verdict/stroke_case.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace luminist {
namespace {

constexpr double kHalfTrue = 0.5;      // of the wish, where nothing comes nearer: as near as light comes
constexpr double kFacing = 0.03;       // cosine below which light grazes
constexpr double kFacingShare = 0.25;  // a surface of which less than this faces a light faces away
constexpr double kDarkening = 1.5;     // times as much to darken as to lighten: a wish for dark
constexpr std::size_t kOpponents = 2;  // that are left out, one at a time
constexpr float kCountsLess = 1.0F / 3.0F;

std::string label_of(const StrokeRegion& region) {
  const std::string name = fmt::format("stroke {}", region.stroke);
  return region.object.empty() ? name : fmt::format("{} on {}", name, region.object);
}

/// The parameter that differs most between two states, in units of its range: "lights/key/color".
std::string most_changed(const ParamState& from, const ParamState& to, const SceneFrame& frame) {
  const UnitMap map = UnitMap::create(from.blocks(), frame);
  const std::vector<double> a = map.to_unit(from.blocks());
  const std::vector<double> b = map.to_unit(to.blocks());
  double most = -1.0;
  std::string name;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::abs(a[k] - b[k]) <= most) continue;
    most = std::abs(a[k] - b[k]);
    const auto block = static_cast<std::size_t>(map.list()[k].block);
    name = from.block_paths()[block] + "/" + from.blocks()[block]->schema()[map.list()[k].param].name;
  }
  return name;
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words) {
  if (words.size() < 2) return words.empty() ? "" : words.front();
  const std::vector<std::string> head(words.begin(), words.end() - 1);
  return fmt::format("{} and {}", fmt::join(head, ", "), words.back());
}

/// "ambient", "fill and rim": the blocks of some parameters as an artist names them.
std::string sources(const std::vector<std::string>& patterns) {
  std::vector<std::string> names;
  for (const std::string& pattern : patterns) {
    std::string name = pattern.substr(0, pattern.rfind('/'));
    if (name.starts_with("lights/")) name = name.substr(7);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return listed(names);
}

}  // namespace

StrokeCase::StrokeCase(Evidence& evidence, const SceneFrame& frame, const Target& target, double epsilon, int region)
    : evidence_(&evidence), frame_(frame), target_(&target), epsilon_(epsilon), region_(region) {
  const StrokeRegion& paint = evidence.regions()[static_cast<std::size_t>(region)];
  verdict_.stroke = paint.stroke;
  verdict_.label = label_of(paint);
  verdict_.wished = evidence.shortfall(region).wished;
  verdict_.missed = evidence.shortfall(region).missed;
}

bool StrokeCase::open() {
  const StrokeRegion& paint = evidence_->regions()[static_cast<std::size_t>(region_)];
  if (paint.pixels.empty()) {
    rule(StrokeOutcome::kImpossible, Cause::kNothingThere,
         "the paint lies on the background, where light shows nothing");
    return false;
  }
  return !evidence_->shortfall(region_).met();
}

Result<void> StrokeCase::try_alone() {
  const StrokeRegion& paint = evidence_->regions()[static_cast<std::size_t>(region_)];
  LUM_TRY(const AttainableColors* attainable, evidence_->attainable());
  if (attainable != nullptr) verdict_.least_missed = attainable->least_error(*target_, paint.pixels);
  LUM_TRY(alone_, reach_alone());
  const double now = evidence_->quiet(region_, evidence_->now(region_));
  const double near = evidence_->quiet(region_, alone_->error);
  verdict_.near_missed = now > 0.0 ? verdict_.missed * std::min(1.0, near / now) : verdict_.missed;
  return {};
}

StrokeVerdict StrokeCase::take() {
  const double chance = evidence_->noise(region_);
  if (chance > 0.0 && verdict_.outcome != StrokeOutcome::kMet) {
    verdict_.text +=
        fmt::format("{}what differs by less than {:.2g} may be chance", verdict_.text.empty() ? "" : ", ", chance);
  }
  return std::move(verdict_);
}

const ParamState* StrokeCase::alone() const {
  return evidence_->helps(region_, alone_->error) ? &alone_->state : nullptr;
}

Result<void> StrokeCase::decide(const std::optional<Rival>& rival) {
  if (alone() == nullptr) return explain();
  if (rival) {
    LUM_TRY(const double own, evidence_->own_error(region_, rival->state));
    if (evidence_->helps(region_, own)) {
      miss(*rival);
      return {};
    }
  }
  return weigh(*alone());
}

void StrokeCase::rule(StrokeOutcome outcome, Cause cause, std::string text) {
  verdict_.outcome = outcome;
  verdict_.cause = cause;
  verdict_.text = std::move(text);
}

/// With more patience the second time, unless it is certain that nothing helps.
Result<Reached> StrokeCase::reach_alone() {
  LUM_TRY(Reached first, evidence_->alone(region_, evidence_->state(), false));
  const bool certain = verdict_.least_missed && *verdict_.least_missed > 0.8 * verdict_.missed;
  if (certain || evidence_->helps(region_, first.error)) return first;
  return evidence_->alone(region_, first.state, true);
}

void StrokeCase::miss(const Rival& rival) {
  rule(StrokeOutcome::kMissed, Cause::kSearchEnded,
       fmt::format("the search ended before it; lights with error {:.4f} instead of {:.4f} are known", rival.epsilon,
                   epsilon_));
  verdict_.remedy.kind = Remedy::Kind::kRestart;
  verdict_.remedy.text = "go on from the better lights";
  verdict_.remedy.state = rival.state;
}

/// It can be had alone: with what does it conflict?
Result<void> StrokeCase::weigh(const ParamState& alone) {
  LUM_TRY(const int partner, opponent(alone));
  LUM_TRY(const auto addition, evidence_->added_light(region_));
  const bool light_helps = addition && evidence_->helps_all(region_, addition->trial);
  blame(partner, most_changed(evidence_->state(), alone, frame_), light_helps);
  if (light_helps) {
    add_light(addition->light);
  } else {
    let_count(partner);
  }
  return {};
}

/// The region without which this stroke would be met; where that is none alone, the one that would lose most.
Result<int> StrokeCase::opponent(const ParamState& alone) {
  LUM_TRY(const std::vector<double> damage, evidence_->damages(alone));
  std::vector<int> order;
  for (int r = 0; r < static_cast<int>(damage.size()); ++r) {
    if (r != region_ && !evidence_->regions()[static_cast<std::size_t>(r)].pixels.empty()) order.push_back(r);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return damage[static_cast<std::size_t>(a)] > damage[static_cast<std::size_t>(b)];
  });
  for (std::size_t k = 0; k < std::min(order.size(), kOpponents); ++k) {
    LUM_TRY(const Trial trial, evidence_->together(region_, {alone, evidence_->state()}, order[k]));
    if (evidence_->helps(region_, trial.own)) return order[k];
  }
  return order.empty() ? -1 : order.front();
}

void StrokeCase::blame(int partner, const std::string& param, bool light_helps) {
  const bool rest = partner < 0 || evidence_->regions()[static_cast<std::size_t>(partner)].stroke == 0;
  if (!rest) {
    const StrokeRegion& other = evidence_->regions()[static_cast<std::size_t>(partner)];
    verdict_.other = other.stroke;
    rule(StrokeOutcome::kConflicting, Cause::kStrokesDisagree,
         fmt::format("{} wants {} otherwise", label_of(other), param));
  } else if (light_helps) {
    rule(StrokeOutcome::kConflicting, Cause::kNeedsLight,
         fmt::format("the rest of the picture needs {} as it is", param));
  } else {
    rule(StrokeOutcome::kConflicting, Cause::kRestDisagrees,
         fmt::format("the rest of the picture wants {} as it is", param));
  }
}

/// It cannot be had: why, and what would help?
Result<void> StrokeCase::explain() {
  const Shortfall& shortfall = evidence_->shortfall(region_);
  if (shortfall.dark > kDarkening * shortfall.light) return explain_dark();
  const std::vector<std::string> behind = lights_behind();
  LUM_TRY(const auto unlocking, best_unlocking(LockedKind::kLight));
  if (unlocking && behind.empty()) {
    rule(StrokeOutcome::kImpossible, Cause::kLockedParameter,
         fmt::format("{} {} locked", listed(unlocking->group.patterns),
                     unlocking->group.patterns.size() == 1 ? "is" : "are"));
    unlock(unlocking->group.patterns);
    return {};
  }
  LUM_TRY(const auto addition, evidence_->added_light(region_));
  const bool light_helps =
      addition && (evidence_->helps_all(region_, addition->trial) || evidence_->helps(region_, addition->alone.error));
  if (!behind.empty() && (unlocking || light_helps)) {
    rule(StrokeOutcome::kImpossible, Cause::kFacesAway, fmt::format("the surface faces away from {}", listed(behind)));
  } else if (light_helps) {
    rule(StrokeOutcome::kImpossible, Cause::kNeedsLight, "no light that may change can make it; another light can");
  } else {
    return nothing_helps();
  }
  if (unlocking) {
    unlock(unlocking->group.patterns);
  } else {
    add_light(addition->light);
  }
  return {};
}

/// A wish for dark where what is locked is too light.
Result<void> StrokeCase::explain_dark() {
  LUM_TRY(const auto unlocking, best_unlocking(LockedKind::kLight));
  std::vector<std::string> patterns;
  if (unlocking) {
    patterns = unlocking->group.patterns;
  } else {
    LUM_TRY(patterns, colors_to_unlock());
  }
  if (patterns.empty()) return nothing_helps();
  rule(StrokeOutcome::kImpossible, Cause::kTooDark,
       fmt::format("it is darker than {} {}", sources(patterns), patterns.size() == 1 ? "allows" : "allow"));
  unlock(patterns);
  return {};
}

Result<void> StrokeCase::nothing_helps() {
  if (evidence_->shortfall(region_).attained() >= kHalfTrue) {
    verdict_.text = "as near as light comes to this paint";
    return {};
  }
  // Who paints light is told of light first; a material is named where no light does it.
  LUM_TRY(const auto unlocking, best_unlocking(LockedKind::kMaterial));
  if (unlocking) {
    const std::vector<std::string>& patterns = unlocking->group.patterns;
    rule(StrokeOutcome::kImpossible, Cause::kLockedParameter, fmt::format("{} is locked", listed(patterns)));
    unlock(patterns);
    return {};
  }
  rule(StrokeOutcome::kImpossible, Cause::kBeyondLight, "no light that was tried makes this");
  return {};
}

/// The one group whose unlocking helps and costs least elsewhere.
Result<std::optional<Unlocking>> StrokeCase::best_unlocking(LockedKind kind) {
  LUM_TRY(std::vector<Unlocking> candidates, evidence_->unlockings(region_, 3, kind));
  std::optional<Unlocking> best;
  double least = 0.0;
  for (Unlocking& candidate : candidates) {
    LUM_TRY(const Trial trial, evidence_->together(region_, {candidate.reached.state}));
    if (!evidence_->helps_all(region_, trial) || (best && trial.total > 0.97 * least)) continue;
    least = trial.total;
    best = std::move(candidate);
  }
  return best;
}

/// All locked colours at once; those that then change much.
Result<std::vector<std::string>> StrokeCase::colors_to_unlock() {
  ParamState state = evidence_->state();
  for (const LockedGroup& group : locked_groups(state)) {
    const bool color = group.params.size() == 1 &&
                       state.blocks()[static_cast<std::size_t>(group.block)]->schema()[group.params[0]].role == "color";
    if (color) state = unlocked(state, group);
  }
  LUM_TRY(const Reached reached, evidence_->alone(region_, state, false));
  std::vector<std::string> patterns;
  if (!evidence_->helps(region_, reached.error)) return patterns;
  const std::vector<std::string> paths = state.block_paths();
  for (std::size_t b = 0; b < paths.size(); ++b) {
    const auto color = state.blocks()[b]->schema().by_role("color");
    if (!color || role_free(*evidence_->state().blocks()[b], "color")) continue;
    const Vec3 before = evidence_->state().blocks()[b]->vec3(*color);
    const Vec3 after = reached.state.blocks()[b]->vec3(*color);
    if (glm::length(after) < 0.7F * glm::length(before)) {
      patterns.push_back(paths[b] + "/" + state.blocks()[b]->schema()[*color].name);
    }
  }
  return patterns;
}

/// The lights that may change and cannot reach the stroke, if that is all of them: its surface faces away from where
/// they are locked.
std::vector<std::string> StrokeCase::lights_behind() const {
  std::vector<std::string> behind;
  const SampledWish& wish = evidence_->wish(region_);
  for (const Light& light : evidence_->state().rig.lights) {
    if (light.muted || !any_free(light.params)) continue;
    const auto position = light.params.schema().by_role("position");
    const auto direction = light.params.schema().by_role("direction");
    if (role_free(light.params, "position") || (!position && (!direction || role_free(light.params, "direction")))) {
      return {};  // it may come from anywhere
    }
    double facing = 0.0;
    for (std::size_t i = 0; i < wish.target.size(); ++i) {
      const std::uint32_t pixel = wish.samples.pixels[i];
      const Vec3 way = position ? light.params.vec3(*position) - evidence_->surface().position[pixel]
                                : -light.params.vec3(*direction);
      const float cosine = glm::dot(evidence_->surface().normal[pixel], way) / std::max(glm::length(way), 1e-12F);
      if (cosine > kFacing) facing += wish.weight[i];
    }
    if (facing > kFacingShare) return {};
    behind.push_back(light.name);
  }
  return behind;
}

void StrokeCase::unlock(std::vector<std::string> patterns) {
  verdict_.remedy.kind = Remedy::Kind::kUnlock;
  verdict_.remedy.text = fmt::format("unlock {}", listed(patterns));
  verdict_.remedy.patterns = std::move(patterns);
}
void StrokeCase::add_light(const StartLight& light) {
  verdict_.remedy.kind = Remedy::Kind::kAddLight;
  verdict_.remedy.text = "add a light here";
  verdict_.remedy.light = light;
}
/// This stroke counts fully, or if it does, the other a third.
void StrokeCase::let_count(int partner) {
  Remedy& remedy = verdict_.remedy;
  const auto mean = [&](int region) {
    double sum = 0.0;
    const auto& pixels = evidence_->regions()[static_cast<std::size_t>(region)].pixels;
    for (const std::uint32_t pixel : pixels) sum += target_->importance.data[pixel];
    return pixels.empty() ? 0.0F : static_cast<float>(sum / static_cast<double>(pixels.size()));
  };
  remedy.kind = Remedy::Kind::kImportance;
  if (mean(region_) < 0.9F || partner < 0) {
    remedy.stroke = verdict_.stroke;
    remedy.importance = 1.0F;
    remedy.text = "raise the importance here to 1";
    return;
  }
  const StrokeRegion& other = evidence_->regions()[static_cast<std::size_t>(partner)];
  remedy.stroke = other.stroke;
  remedy.importance = kCountsLess * mean(partner);
  remedy.text = other.stroke == 0
                    ? fmt::format("lower the importance of what is not painted to {:.2g}", remedy.importance)
                    : fmt::format("lower the importance of stroke {} to {:.2g}", other.stroke, remedy.importance);
}

}  // namespace luminist
