#include "bench/convergence.h"

#include <algorithm>
#include <cmath>

#include "studio/plot.h"

namespace luminist {
namespace {

constexpr double kLeastWork = 0.05;  // render equivalents: where the curves begin
constexpr double kStep = 1.03;       // from one point of a curve to the next

/// The best ratio that a run had seen when it had done that much work.
double ratio_at(const BenchRun& run, double work) {
  double best = 1.0;
  for (const ConvergencePoint& point : run.convergence) {
    if (point.render_equivalents > work) break;
    best = point.epsilon / run.epsilon_start;
  }
  return best;
}

PlotCurve curve(const BenchReport& report) {
  double most = 2.0 * kLeastWork;
  for (const BenchRun& run : report.runs) most = std::max(most, run.total_equivalents);
  PlotCurve result{report.key().method + " " + std::to_string(report.key().width), {}};
  for (double work = kLeastWork; work < kStep * most; work *= kStep) {
    std::vector<double> ratios;
    for (const BenchRun& run : report.runs) ratios.push_back(ratio_at(run, work));
    result.points.push_back({std::min(work, most), median(std::move(ratios))});
  }
  return result;
}

}  // namespace

Image convergence_image(const std::string& title, const std::vector<BenchReport>& reports) {
  std::vector<PlotCurve> curves;
  for (const BenchReport& report : reports) curves.push_back(curve(report));
  return curve_plot(title, "work in render equivalents", "median error over the start's, best so far", curves);
}

}  // namespace luminist
