#include "solve/nelder_mead.h"

#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"

namespace luminist {

NelderMead::NelderMead(std::vector<double> start, const NelderMeadOptions& options)
    : options_(options),
      best_(std::move(start)),
      best_value_(std::numeric_limits<double>::infinity()),
      round_start_value_(best_value_) {
  LUM_CHECK(!best_.empty(), "a simplex has at least one dimension");
  begin(best_);
}

void NelderMead::begin(const std::vector<double>& centre) {
  vertex_.assign(1, centre);
  for (int axis = 0; axis < static_cast<int>(centre.size()); ++axis) vertex_.push_back(corner(centre, axis));
  value_.assign(vertex_.size(), std::numeric_limits<double>::infinity());
  round_start_value_ = best_value_;
  phase_ = Phase::kBuild;
  vertex_due_ = 0;
  trial_ = vertex_[0];
}

std::vector<double> NelderMead::corner(const std::vector<double>& centre, int axis) const {
  std::vector<double> point = centre;
  double& x = point[static_cast<std::size_t>(axis)];
  x += x + options_.size > 1.0 ? -options_.size : options_.size;  // inside the unit cube where there is room
  return point;
}

void NelderMead::recentre(std::vector<double> best) {
  LUM_CHECK(restarted_ && best.size() == best_.size(), "coordinates change only between two simplexes");
  best_ = std::move(best);
  begin(best_);
}

void NelderMead::tell(double value) {
  LUM_CHECK(!done(), "nothing was asked");
  if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  restarted_ = false;
  if (value < best_value_) {
    best_value_ = value;
    best_ = trial_;
  }
  const auto worst = static_cast<std::size_t>(highest_);
  switch (phase_) {
    case Phase::kBuild:
    case Phase::kShrink:
      value_[static_cast<std::size_t>(vertex_due_)] = value;
      do {
        ++vertex_due_;
      } while (phase_ == Phase::kShrink && vertex_due_ == lowest_);
      if (vertex_due_ < static_cast<int>(vertex_.size())) {
        trial_ = vertex_[static_cast<std::size_t>(vertex_due_)];
      } else {
        choose_move();
      }
      return;
    case Phase::kReflect: {
      const double low = value_[static_cast<std::size_t>(lowest_)];
      const double second = value_[static_cast<std::size_t>(second_)];
      if (value < value_[worst]) accept(value);
      if (value <= low) {
        phase_ = Phase::kExpand;
        try_along(2.0);
      } else if (value >= second) {
        phase_ = Phase::kContract;
        try_along(0.5);
      } else {
        choose_move();
      }
      return;
    }
    case Phase::kExpand:
      if (value < value_[worst]) accept(value);
      choose_move();
      return;
    case Phase::kContract:
      if (value < value_[worst]) {
        accept(value);
        choose_move();
      } else {
        collapse();
      }
      return;
    case Phase::kDone:
      return;
  }
}

void NelderMead::accept(double value) {
  vertex_[static_cast<std::size_t>(highest_)] = trial_;
  value_[static_cast<std::size_t>(highest_)] = value;
}

void NelderMead::choose_move() {
  lowest_ = highest_ = 0;
  for (int i = 1; i < static_cast<int>(value_.size()); ++i) {
    const double value = value_[static_cast<std::size_t>(i)];
    if (value <= value_[static_cast<std::size_t>(lowest_)]) lowest_ = i;
    if (value > value_[static_cast<std::size_t>(highest_)]) highest_ = i;
  }
  second_ = lowest_;
  for (int i = 0; i < static_cast<int>(value_.size()); ++i) {
    if (i == highest_) continue;
    if (value_[static_cast<std::size_t>(i)] > value_[static_cast<std::size_t>(second_)]) second_ = i;
  }
  const double low = value_[static_cast<std::size_t>(lowest_)];
  const double high = value_[static_cast<std::size_t>(highest_)];
  constexpr double kTiny = 1e-10;  // a simplex at zero has collapsed too
  const bool flat =
      !std::isfinite(low) || (std::isfinite(high) && 2.0 * (high - low) <= options_.tolerance * (high + low) + kTiny);
  if (!flat) {
    phase_ = Phase::kReflect;
    try_along(-1.0);
    return;
  }
  const bool first_round = !std::isfinite(round_start_value_);
  const bool gained = first_round || best_value_ < round_start_value_ * (1.0 - options_.restart_gain);
  const bool more = options_.restarts < 0 || restarts_ < options_.restarts;
  if (!more || !std::isfinite(low) || (options_.restart_gain > 0.0 && !gained)) {
    phase_ = Phase::kDone;
    return;
  }
  ++restarts_;
  restarted_ = true;
  begin(best_);
}

void NelderMead::try_along(double factor) {
  const std::size_t n = best_.size();
  const auto worst = static_cast<std::size_t>(highest_);
  trial_.assign(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    double others = 0.0;
    for (std::size_t i = 0; i < vertex_.size(); ++i) {
      if (i != worst) others += vertex_[i][k];
    }
    trial_[k] = others / static_cast<double>(n) * (1.0 - factor) + vertex_[worst][k] * factor;
  }
}

void NelderMead::collapse() {
  const std::vector<double> low = vertex_[static_cast<std::size_t>(lowest_)];
  for (std::vector<double>& vertex : vertex_) {
    for (std::size_t k = 0; k < vertex.size(); ++k) vertex[k] = 0.5 * (vertex[k] + low[k]);
  }
  phase_ = Phase::kShrink;
  vertex_due_ = lowest_ == 0 ? 1 : 0;
  trial_ = vertex_[static_cast<std::size_t>(vertex_due_)];
}

}  // namespace luminist
