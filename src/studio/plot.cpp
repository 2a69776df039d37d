#include "studio/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "studio/drawing.h"

namespace luminist {
namespace {

constexpr int kWidth = 900;
constexpr int kHeight = 540;
constexpr int kLeft = 100;
constexpr int kRight = 30;
constexpr int kTop = 70;
constexpr int kBottom = 80;

struct Axis {
  double low = 0.0;
  double high = 1.0;
  bool logarithmic = false;
  std::vector<double> ticks;

  [[nodiscard]] double unit(double value) const {
    if (logarithmic) return std::log(value / low) / std::log(high / low);
    return (value - low) / (high - low);
  }
};

/// 1, 2 or 5 times a power of ten: the largest such step that gives at least four.
double tick_step(double span) {
  const double decade = std::pow(10.0, std::floor(std::log10(span)));
  for (const double factor : {5.0, 2.0, 1.0, 0.5, 0.2}) {
    if (span / (factor * decade) >= 4.0) return factor * decade;
  }
  return 0.1 * decade;
}

Axis work_axis(double most) {
  Axis axis;
  axis.high = std::max(most, 1.0);
  const double step = tick_step(axis.high);
  for (int i = 0; static_cast<double>(i) * step <= axis.high * 1.0001; ++i) axis.ticks.push_back(i * step);
  return axis;
}

/// Logarithmic; starts and ends at 1, 2 or 5 times a power of ten.
Axis log_axis(double least, double most) {
  Axis axis;
  axis.logarithmic = true;
  std::vector<double> marks;
  for (int decade = -12; decade <= 6; ++decade) {
    for (const double factor : {1.0, 2.0, 5.0}) marks.push_back(factor * std::pow(10.0, decade));
  }
  const auto above = std::upper_bound(marks.begin(), marks.end(), most * 1.0001);
  const auto below = std::lower_bound(marks.begin(), marks.end(), least * 0.9999);
  axis.high = above == marks.end() ? most : *above;
  axis.low = below == marks.begin() ? marks.front() : *(below - 1);
  const bool crowded = axis.high / axis.low > 1e4;
  for (const double mark : marks) {
    const bool decade = std::abs(std::log10(mark) - std::round(std::log10(mark))) < 1e-9;
    if (mark >= axis.low * 0.9999 && mark <= axis.high * 1.0001 && (decade || !crowded)) axis.ticks.push_back(mark);
  }
  return axis;
}

class Plot {
 public:
  Plot(Axis x, Axis y) : image_(kWidth, kHeight, 3), drawing_(image_), x_(std::move(x)), y_(std::move(y)) {
    drawing_.fill(0, 0, kWidth, kHeight, rgb8(250, 250, 248));
  }

  [[nodiscard]] DrawPoint at(double x, double y) const {
    return {static_cast<float>(kLeft + x_.unit(x) * (kWidth - kLeft - kRight)),
            static_cast<float>(kHeight - kBottom - y_.unit(y) * (kHeight - kTop - kBottom))};
  }

  void draw_axes(const std::string& title, const std::string& x_name, const std::string& y_name) {
    const Vec3 ink = rgb8(50, 50, 54);
    const Vec3 grid = rgb8(222, 222, 220);
    for (const double tick : x_.ticks) {
      drawing_.line(at(tick, y_.low), at(tick, y_.high), 1.0F, grid);
      const std::string label = fmt::format("{:.6g}", tick);
      drawing_.text(static_cast<int>(at(tick, y_.low).x) - text_width(label, kTextScale) / 2, kHeight - kBottom + 10,
                    label, kTextScale, ink);
    }
    for (const double tick : y_.ticks) {
      drawing_.line(at(x_.low, tick), at(x_.high, tick), 1.0F, grid);
      const std::string label = fmt::format("{:.6g}", tick);
      drawing_.text(kLeft - 10 - text_width(label, kTextScale),
                    static_cast<int>(at(x_.low, tick).y) - 7 * kTextScale / 2, label, kTextScale, ink);
    }
    drawing_.line(at(x_.low, y_.low), at(x_.high, y_.low), 1.5F, ink);
    drawing_.line(at(x_.low, y_.low), at(x_.low, y_.high), 1.5F, ink);
    drawing_.text(kLeft, 16, title, kTextScale, ink);
    drawing_.text(kLeft, kTop - 24, y_name, kTextScale, ink);
    drawing_.text(kWidth - kRight - text_width(x_name, kTextScale), kHeight - 34, x_name, kTextScale, ink);
  }

  /// Line number `index` of several, and its name in the legend below the title.
  void draw_line(const PlotCurve& curve, std::size_t index) {
    static constexpr std::array<std::array<int, 3>, 6> kColors{
        {{24, 96, 168}, {196, 78, 32}, {36, 130, 70}, {130, 70, 160}, {150, 120, 20}, {90, 90, 95}}};
    const auto& [red, green, blue] = kColors[index % kColors.size()];
    const Vec3 color = rgb8(red, green, blue);
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const PlotCurve::Point& from = curve.points[i - 1];
      const PlotCurve::Point& to = curve.points[i];
      drawing_.line(at(from.x, from.y), at(to.x, to.y), 2.5F, color);
    }
    const int y = kHeight - kBottom - 24 - static_cast<int>(index) * 22;  // lower left: errors fall to the right
    drawing_.text(kLeft + 40, y, curve.name, kTextScale, color);
    const auto middle = static_cast<float>(y + 7 * kTextScale / 2);
    drawing_.line({kLeft + 10.0F, middle}, {kLeft + 32.0F, middle}, 3.0F, color);
  }

  /// The best so far holds until a better one is found, and to the end of the work.
  void draw_curve(const std::vector<ConvergencePoint>& points, double work) {
    const Vec3 color = rgb8(24, 96, 168);
    DrawPoint last{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const DrawPoint here = at(points[i].render_equivalents, std::max(points[i].epsilon, y_.low));
      if (i > 0) {
        drawing_.line(last, {here.x, last.y}, 2.5F, color);
        drawing_.line({here.x, last.y}, here, 2.5F, color);
      }
      if (points.size() <= 60) drawing_.line(here, here, 7.0F, color);
      last = here;
    }
    if (!points.empty()) drawing_.line(last, {at(work, y_.low).x, last.y}, 2.5F, color);
  }

  [[nodiscard]] Image take() { return std::move(image_); }

 private:
  Image image_;
  Drawing drawing_;
  Axis x_;
  Axis y_;
};

}  // namespace

Image convergence_plot(const SolveReport& report) {
  double most_work = report.render_equivalents;
  double least = std::max(report.epsilon, 1e-12);
  double most = std::max(report.epsilon_start, least);
  for (const ConvergencePoint& point : report.convergence) {
    most_work = std::max(most_work, point.render_equivalents);
    if (point.epsilon > 0.0) least = std::min(least, point.epsilon);
    if (std::isfinite(point.epsilon)) most = std::max(most, point.epsilon);
  }
  Plot plot(work_axis(most_work), log_axis(least, most));
  plot.draw_axes(fmt::format("{} solver: {} pictures compared, {:.3g} render equivalents", report.solver, report.evals,
                             report.render_equivalents),
                 "work in render equivalents", "error, best so far");
  plot.draw_curve(report.convergence, most_work);
  return plot.take();
}

Image curve_plot(const std::string& title, const std::string& x_name, const std::string& y_name,
                 const std::vector<PlotCurve>& curves) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  PlotCurve::Point least{kNone, kNone};
  PlotCurve::Point most{0.0, 0.0};
  std::vector<PlotCurve> drawn;
  for (const PlotCurve& curve : curves) {
    drawn.push_back({curve.name, {}});
    for (const PlotCurve::Point& point : curve.points) {
      if (!(point.x > 0.0 && point.y > 0.0) || !std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      drawn.back().points.push_back(point);
      least = {std::min(least.x, point.x), std::min(least.y, point.y)};
      most = {std::max(most.x, point.x), std::max(most.y, point.y)};
    }
  }
  if (!(most.x > 0.0)) least = most = {1.0, 1.0};
  Plot plot(log_axis(least.x, most.x), log_axis(least.y, most.y));
  plot.draw_axes(title, x_name, y_name);
  for (std::size_t i = 0; i < drawn.size(); ++i) plot.draw_line(drawn[i], i);
  return plot.take();
}

}  // namespace luminist
