#include "solve/exploration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "solve/light_variants.h"

namespace luminist {
namespace {

// Of a light as it is, and as many of it as it was: the fewer the lights, the more can be had.
constexpr int kVariants = 75;
constexpr int kVariantsOfOne = 150;

std::vector<std::vector<ParamState>> one_by_one(std::vector<ParamState> states) {
  std::vector<std::vector<ParamState>> groups;
  for (ParamState& state : states) groups.emplace_back().push_back(std::move(state));
  return groups;
}

}  // namespace

std::vector<FastFind> cheapest_distinct(const CellProblem& problem, std::vector<FastFind> finds, std::size_t count,
                                        const CellPoint* taken, double start_cost) {
  constexpr double kDistinct = 0.1;
  std::stable_sort(finds.begin(), finds.end(), cheaper);
  std::map<int, std::size_t> chosen_of;  // by block
  for (const FastFind& find : finds) chosen_of[find.block] = 0;
  const std::size_t share = (count + chosen_of.size() - 1) / std::max<std::size_t>(1, chosen_of.size());
  std::vector<CellField> seen;
  if (taken != nullptr) seen.push_back(problem.picture(*taken));
  std::vector<FastFind> chosen;
  for (FastFind& find : finds) {
    if (chosen.size() == count) break;
    if (chosen_of[find.block] == share) continue;
    CellField picture = problem.picture(find.point);
    const bool known = std::any_of(seen.begin(), seen.end(), [&](const CellField& other) {
      double difference = 0.0;
      for (std::size_t c = 0; c < other.size(); ++c) {
        difference += problem.level().cells.weight[c] * glm::distance(picture[c], other[c]);
      }
      return difference < kDistinct * std::min(find.point.cost, std::abs(start_cost - find.point.cost));
    });
    if (known) continue;
    ++chosen_of[find.block];
    seen.push_back(std::move(picture));
    chosen.push_back(std::move(find));
  }
  return chosen;
}

Exploration::Exploration(const CellProblem& problem, ParamState base, ParamState start, std::vector<int> blocks,
                         const Vec3& focus, bool known)
    : problem_(&problem),
      base_(std::move(base)),
      start_(std::move(start)),
      blocks_(std::move(blocks)),
      focus_(focus),
      known_(known) {}

Result<void> Exploration::measure(std::vector<std::vector<ParamState>> groups, int block, int other) {
  const std::vector<const ParamBlock*> blocks = std::as_const(base_).blocks();
  const UnitMap map = UnitMap::create(blocks, problem_->frame());
  const std::array<int, 2> varied{block, other};
  const std::vector<int> touched = problem_->parts().touched_by(base_, map, std::span(varied).first(other < 0 ? 1 : 2));
  std::vector<ParamState> states;
  for (std::vector<ParamState>& group : groups) std::move(group.begin(), group.end(), std::back_inserter(states));
  LUM_TRY(std::vector<CellPoint> points, problem_->measure(std::move(states), &*home_, touched));
  auto begin = points.begin();
  for (const std::vector<ParamState>& group : groups) {
    const auto end = begin + static_cast<std::ptrdiff_t>(group.size());
    const auto best = std::min_element(begin, end, [](const auto& a, const auto& b) { return a.cost < b.cost; });
    if (best != end) finds_.push_back({std::move(*best), other < 0 ? block : -1});
    begin = end;
  }
  return {};
}

Result<bool> Exploration::step(Random& random) {
  if (!home_) {
    LUM_TRY(home_, problem_->measure(base_));
    LUM_TRY(const CellPoint start, problem_->measure(start_));
    start_cost_ = start.cost;
  }
  const CellPoint& home = *home_;
  const SampleCells& cells = problem_->level().cells;
  const CellField picture = problem_->picture(home);
  LightPlaces places{cells.position, cells.normal, {}, focus_};
  for (std::size_t c = 0; c < picture.size(); ++c) {
    places.say.push_back(cells.weight[c] * glm::length(picture[c] - cells.target[c]));
  }
  const int block = blocks_[next_++];
  const int variants = blocks_.size() == 1 ? kVariantsOfOne : kVariants;
  const ParamState as_it_was = with_block_of(home.state, start_, block);
  for (const ParamState* centre : {&home.state, &as_it_was}) {
    LUM_TRY_VOID(
        measure(one_by_one(light_variants(*centre, block, places, problem_->frame(), variants, random)), block, -1));
  }
  if (!known_) {
    LUM_TRY_VOID(measure(one_by_one({as_it_was}), block, -1));
    LUM_TRY_VOID(measure(light_scans(home.state, start_, block, problem_->frame()), block, -1));
    LUM_TRY_VOID(exchange(block));
  }
  return next_ < blocks_.size();
}

Result<void> Exploration::exchange(int block) {
  for (std::size_t i = next_; i < blocks_.size(); ++i) {
    std::vector<ParamState> exchanged = light_exchange(home_->state, block, blocks_[i]);
    LUM_TRY_VOID(measure(one_by_one(std::move(exchanged)), block, blocks_[i]));
  }
  return {};
}

std::vector<FastFind> Exploration::take(std::size_t count) {
  if (!home_) return {};
  return cheapest_distinct(*problem_, std::exchange(finds_, {}), count, &*home_, start_cost_);
}

}  // namespace luminist
