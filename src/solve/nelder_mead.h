#pragma once
// solve/nelder_mead.h -- the downhill simplex, one evaluation at a time (paper, section 5; Nelder and Mead 1965).
#include <vector>

namespace luminist {

struct NelderMeadOptions {
  double size = 0.1;          ///< of the first simplex: one step along each axis
  double tolerance = 1e-4;    ///< halts when 2 |worst - best| <= tolerance (|worst| + |best|)
  int restarts = -1;          ///< from the minimum, with a simplex of the first size; -1: for ever
  double restart_gain = 0.0;  ///< no further restart after one that gained less than this fraction of the value
};

/// Asks for a point, is told its value: `while (!done()) tell(f(point()))`.
///
/// The moves are those of the routine of Press et al. (1992, section 10.4): reflect the worst vertex through the
/// opposite face; go twice as far if that is the best so far; contract to half if it is still the worst but one; shrink
/// towards the best if nothing helped. Values may be infinite. Deterministic. memory O(n^2), cost O(n) a step.
class NelderMead {
 public:
  NelderMead(std::vector<double> start, const NelderMeadOptions& options);

  [[nodiscard]] bool done() const { return phase_ == Phase::kDone; }
  /// What to evaluate next. [n]
  [[nodiscard]] const std::vector<double>& point() const { return trial_; }
  void tell(double value);

  [[nodiscard]] const std::vector<double>& best() const { return best_; }
  [[nodiscard]] double best_value() const { return best_value_; }
  [[nodiscard]] int restarts() const { return restarts_; }  ///< begun so far

  /// True just after tell() began a new simplex at best(): the caller may chart it anew with recentre().
  [[nodiscard]] bool restarted() const { return restarted_; }
  /// The same point in other coordinates; only while restarted().
  void recentre(std::vector<double> best);

 private:
  enum class Phase { kBuild, kReflect, kExpand, kContract, kShrink, kDone };

  void begin(const std::vector<double>& centre);
  void choose_move();
  void try_along(double factor);
  void accept(double value);
  void collapse();
  [[nodiscard]] std::vector<double> corner(const std::vector<double>& centre, int axis) const;

  NelderMeadOptions options_;
  Phase phase_ = Phase::kBuild;
  std::vector<std::vector<double>> vertex_;
  std::vector<double> value_;
  std::vector<double> trial_;
  std::vector<double> best_;
  double best_value_;
  double round_start_value_;  ///< best value when the present simplex began
  int vertex_due_ = 0;        ///< of kBuild and kShrink
  int lowest_ = 0, highest_ = 0, second_ = 0;
  int restarts_ = 0;
  bool restarted_ = false;
};

}  // namespace luminist
