#include "verdict/evidence.h"

#include <algorithm>
#include <cmath>

namespace luminist {
namespace {

constexpr std::size_t kSamples = 64;  // of each stroke
constexpr int kVariants = 40;         // of each block
constexpr int kThorough = 160;
constexpr double kClear = 0.65;   // an error that is at most this part of the present one is clearly nearer
constexpr double kOfWish = 0.08;  // and a gain that is at least this part of the wish
constexpr double kChance = 2.0;   // standard errors of a region's mean that a gain must be larger than
constexpr double kPrice = 0.25;   // of a stroke's gain must be left when all is counted

}  // namespace

Result<Evidence> Evidence::create(Renderer& renderer, const ParamState& state, const Target& target,
                                  const Image& picture, const Light* new_light) {
  Evidence evidence(renderer, state, target, picture);
  evidence.new_light_ = new_light;
  if (new_light == nullptr && !state.rig.lights.empty()) evidence.new_light_ = &state.rig.lights.front();
  evidence.regions_ = stroke_regions(renderer.surface(), target);
  evidence.everything_ = sample_regions(evidence.regions_, renderer.surface(), target, kSamples);
  const SampledWish& all = evidence.everything_;
  evidence.share_.assign(evidence.regions_.size(), 0.0);
  for (std::size_t i = 0; i < all.region.size(); ++i) {
    evidence.share_[static_cast<std::size_t>(all.region[i])] += all.weight[i];
  }
  evidence.colors_.resize(all.target.size());
  const Candidate candidate{&state, Candidate::kAllLights};
  if (!all.target.empty()) {
    LUM_TRY_VOID(renderer.evaluate({&candidate, 1}, all.samples, {}, evidence.colors_));
  }
  const bool estimates = renderer.estimates();
  evidence.total_now_ = all.error(evidence.colors_);
  for (std::size_t r = 0; r < evidence.regions_.size(); ++r) {
    evidence.shortfalls_.push_back(luminist::shortfall(evidence.regions_[r], target, picture));
    evidence.wishes_.push_back(only_region(all, static_cast<int>(r)));
    double error = 0.0;
    double chance = 0.0;
    for (std::size_t i = 0; i < all.region.size(); ++i) {
      if (all.region[i] != static_cast<int>(r)) continue;
      error += all.weight[i] * glm::distance(all.target[i], evidence.colors_[i]);
      chance += all.weight[i] * glm::distance(picture.rgb(all.samples.pixels[i]), evidence.colors_[i]);
    }
    const double share = evidence.share_[r];
    evidence.now_.push_back(share > 0.0 ? error / share : 0.0);
    evidence.noise_.push_back(estimates && share > 0.0 ? chance / share : 0.0);
  }
  return evidence;
}

double Evidence::quiet(int region, double error) const {
  const double chance = noise_[static_cast<std::size_t>(region)];
  return std::sqrt(std::max(0.0, error * error - chance * chance));
}

bool Evidence::helps(int region, double own) const {
  const double before = quiet(region, now(region));
  const double after = quiet(region, own);
  const double chance = noise_[static_cast<std::size_t>(region)] / std::sqrt(static_cast<double>(kSamples));
  const double least = std::max(kOfWish * shortfall(region).wished, kChance * chance);
  return after <= kClear * before && before - after >= least;
}

bool Evidence::helps_all(int region, const Trial& trial) const {
  const double gain = share_[static_cast<std::size_t>(region)] * (now(region) - trial.own);
  return helps(region, trial.own) && total_now_ - trial.total >= kPrice * gain;
}

Result<Reached> Evidence::alone(int region, const ParamState& start, bool thorough) {
  const double wished = shortfall(region).wished;
  const double enough = 0.15 * wished + std::min(0.002, 0.05 * wished);
  return search_.search({start}, wish(region), thorough ? kThorough : kVariants, enough);
}

Result<Trial> Evidence::together(int region, std::vector<ParamState> starts, int left_out) {
  SampledWish wished = everything_;
  if (left_out >= 0) {
    for (std::size_t i = 0; i < wished.region.size(); ++i) {
      if (wished.region[i] == left_out) wished.weight[i] = 0.0;
    }
  }
  LUM_TRY(std::vector<Reached> ends, search_.descend(std::move(starts), wished, 4, 5));
  Reached& best =
      *std::min_element(ends.begin(), ends.end(), [](const Reached& a, const Reached& b) { return a.error < b.error; });
  LUM_TRY(const double own, own_error(region, best.state));
  return Trial{std::move(best.state), own, best.error};
}

Result<double> Evidence::own_error(int region, const ParamState& state) {
  LUM_TRY(const std::vector<double> own, search_.measure({&state, 1}, wish(region)));
  return own[0];
}

Result<std::vector<double>> Evidence::damages(const ParamState& state) {
  std::vector<Vec3> colors(everything_.target.size());
  const Candidate candidate{&state, Candidate::kAllLights};
  LUM_TRY_VOID(renderer_->evaluate({&candidate, 1}, everything_.samples, {}, colors));
  std::vector<double> damage(regions_.size(), 0.0);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Vec3& wanted = everything_.target[i];
    damage[static_cast<std::size_t>(everything_.region[i])] +=
        everything_.weight[i] * (glm::distance(wanted, colors[i]) - glm::distance(wanted, colors_[i]));
  }
  return damage;
}

Result<Reached> Evidence::rival(std::vector<ParamState> starts) {
  starts.insert(starts.begin(), *state_);
  return search_.search(std::move(starts), everything_, kVariants, 0.0);
}

Result<std::vector<Unlocking>> Evidence::unlockings(int region, std::size_t keep, LockedKind kind) {
  return best_unlockings(*renderer_, *state_, wish(region), keep, kind);
}

Result<std::optional<Evidence::Addition>> Evidence::added_light(int region) {
  if (new_light_ == nullptr) return std::optional<Addition>();
  const BankFocus focus = focus_of(everything_, region, colors_, surface());
  LUM_TRY(const LightBank bank, LightBank::create(*renderer_, *state_, everything_, {&focus, 1}, *new_light_));
  // The stroke counts as much as all others together.
  std::vector<double> weight = everything_.weight;
  const double share = std::max(share_[static_cast<std::size_t>(region)], 1e-9);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    if (everything_.region[i] == region) weight[i] *= std::max(1.0, (1.0 - share) / share);
  }
  const LightBank::Pick pick = bank.best(weight);
  if (!(pick.gain > 0.0)) return std::optional<Addition>();
  const ParamState start = with_light(*state_, *new_light_, pick.light, "light");
  LUM_TRY(std::vector<Reached> alone, search_.descend({start}, wish(region), 3, 3));
  LUM_TRY(Trial trial, together(region, {start, alone[0].state}));
  return std::optional(Addition{pick.light, std::move(alone[0]), std::move(trial)});
}

Result<std::optional<double>> Evidence::estimated_epsilon(double epsilon, std::span<const int> unmet) {
  if (new_light_ == nullptr || !(total_now_ > 0.0)) return std::optional<double>();
  std::vector<BankFocus> foci;
  for (const int region : unmet) {
    if (foci.size() < 3) foci.push_back(focus_of(everything_, region, colors_, surface()));
  }
  LUM_TRY(const LightBank bank, LightBank::create(*renderer_, *state_, everything_, foci, *new_light_));
  return std::optional(epsilon * std::min(1.0, everything_.error(bank.fitted()) / total_now_));
}

Result<const AttainableColors*> Evidence::attainable() {
  if (!bound_asked_) {
    LUM_TRY(attainable_, AttainableColors::create(*renderer_, *state_, *picture_));
    bound_asked_ = true;
  }
  return attainable_ ? &*attainable_ : nullptr;
}

}  // namespace luminist
