#include "prep/chart_packing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/check.h"

namespace luminist {
namespace {

struct TurnedBox {
  glm::dvec2 turn{1.0, 0.0};
  glm::dvec2 lo{0.0};
  glm::dvec2 size{0.0};
};

glm::dvec2 turned(const glm::dvec2& at, const glm::dvec2& turn) {
  return {at.x * turn.x - at.y * turn.y, at.x * turn.y + at.y * turn.x};
}

TurnedBox box_of(const std::vector<glm::dvec2>& border, double angle) {
  const glm::dvec2 turn(std::cos(angle), std::sin(angle));
  glm::dvec2 lo(std::numeric_limits<double>::infinity());
  glm::dvec2 hi(-lo);
  for (const glm::dvec2& p : border) {
    const glm::dvec2 at = turned(p, turn);
    lo = glm::min(lo, at), hi = glm::max(hi, at);
  }
  return {turn, lo, hi - lo};
}

/// The smallest of boxes two degrees apart, lying down.
TurnedBox smallest_box(const std::vector<glm::dvec2>& border) {
  constexpr int kAngles = 45;
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kAngles; ++i) {
    const TurnedBox box = box_of(border, 0.5 * kPi * i / kAngles);
    if (box.size.x * box.size.y < least) least = box.size.x * box.size.y, best = i;
  }
  const TurnedBox box = box_of(border, 0.5 * kPi * best / kAngles);
  return box.size.y > box.size.x ? box_of(border, 0.5 * kPi * best / kAngles + 0.5 * kPi) : box;
}

/// The upper contour of the boxes in a strip of some width, as steps from left to right.
class Skyline {
 public:
  explicit Skyline(double width) : width_(width), steps_{{0.0, 0.0}} {}

  /// The lower left corner of a box at the lowest place, the leftmost of them.
  glm::dvec2 add(const glm::dvec2& size) {
    std::size_t best = steps_.size();
    double best_y = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const double right = steps_[i].x + size.x;
      if (right > width_) break;
      double y = 0.0;
      for (std::size_t j = i; j < steps_.size() && steps_[j].x < right && y < best_y; ++j) y = std::max(y, steps_[j].y);
      if (y < best_y) best_y = y, best = i;
    }
    LUM_CHECK(best < steps_.size(), "the strip is as wide as the widest box");
    const glm::dvec2 at(steps_[best].x, best_y);
    raise(best, at, size);
    height_ = std::max(height_, at.y + size.y);
    return at;
  }
  [[nodiscard]] double height() const { return height_; }

 private:
  void raise(std::size_t first, const glm::dvec2& at, const glm::dvec2& size) {
    const double right = at.x + size.x;
    std::size_t last = first;
    while (last + 1 < steps_.size() && steps_[last + 1].x <= right) ++last;
    const double after = steps_[last].y;
    const auto begin = steps_.begin() + static_cast<std::ptrdiff_t>(first);
    steps_.erase(begin, begin + static_cast<std::ptrdiff_t>(last - first + 1));
    std::vector<glm::dvec2> steps{{at.x, at.y + size.y}};
    if (right < width_) steps.emplace_back(right, after);
    // Where the next step begins at the right end there is no ground left between.
    const auto next = steps_.begin() + static_cast<std::ptrdiff_t>(first);
    steps_.insert(next, steps.begin(), steps.end());
  }

  double width_;
  double height_ = 0.0;
  std::vector<glm::dvec2> steps_;  ///< left end and height of each
};

struct Strip {
  std::vector<glm::dvec2> corners;  ///< [boxes]
  double side = 0.0;                ///< of the square around all
};

Strip strip_of(const std::vector<TurnedBox>& boxes, const std::vector<std::size_t>& order, double width,
               double margin) {
  Strip strip;
  strip.corners.resize(boxes.size());
  Skyline skyline(width);
  for (const std::size_t i : order) strip.corners[i] = skyline.add(boxes[i].size + margin) + 0.5 * margin;
  strip.side = std::max(width, skyline.height());
  return strip;
}

}  // namespace

glm::dvec2 ChartPacking::place(std::size_t chart, const glm::dvec2& at) const {
  return scale * (turned(at, charts[chart].turn) + charts[chart].offset);
}

ChartPacking pack(const std::vector<std::vector<glm::dvec2>>& borders, const std::vector<double>& areas) {
  ChartPacking packing;
  if (borders.empty()) return packing;
  std::vector<TurnedBox> boxes;
  double total = 0.0, covered = 0.0, widest = 0.0;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    boxes.push_back(smallest_box(borders[i]));
    total += boxes[i].size.x * boxes[i].size.y, covered += areas[i], widest = std::max(widest, boxes[i].size.x);
  }
  const double margin = std::min(std::sqrt(total) / 256.0, 0.1 * std::sqrt(total / static_cast<double>(boxes.size())));
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return boxes[a].size.y > boxes[b].size.y; });
  Strip best;
  for (const double slack : {1.0, 1.04, 1.08, 1.12, 1.16, 1.2, 1.25, 1.3, 1.4}) {
    // A little more than the widest, because sums of widths round.
    const double width = std::max(slack * std::sqrt(total), (widest + margin) * (1.0 + 1e-9));
    Strip strip = strip_of(boxes, order, width, margin);
    if (best.corners.empty() || strip.side < best.side) best = std::move(strip);
  }
  packing.scale = best.side > 0.0 ? 1.0 / best.side : 1.0;
  packing.utilization = covered * packing.scale * packing.scale;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    packing.charts.push_back({boxes[i].turn, best.corners[i] - boxes[i].lo});
  }
  return packing;
}

}  // namespace luminist
