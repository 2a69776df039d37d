#include "bench/bench_statistics.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace luminist {

Bounded median(std::vector<Bounded> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end(), [](const Bounded& a, const Bounded& b) {
    return a.value != b.value ? a.value < b.value : a.at_least < b.at_least;
  });
  const std::size_t upper = values.size() / 2;
  const std::size_t lower = (values.size() - 1) / 2;
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(upper) + 1;
  const bool at_least = std::any_of(values.begin(), end, [](const Bounded& value) { return value.at_least; });
  return {0.5 * (values[lower].value + values[upper].value), at_least};
}

double median(std::vector<double> values) {
  std::vector<Bounded> exact;
  exact.reserve(values.size());
  for (const double value : values) exact.push_back({value, false});
  return median(std::move(exact)).value;
}

double exponent(std::span<const double> x, std::span<const double> y) {
  LUM_CHECK(x.size() == y.size(), "one y for each x");
  double count = 0.0, sum_x = 0.0, sum_y = 0.0, sum_xx = 0.0, sum_xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(x[i] > 0.0) || !(y[i] > 0.0)) continue;
    const double u = std::log(x[i]);
    const double v = std::log(y[i]);
    count += 1.0, sum_x += u, sum_y += v, sum_xx += u * u, sum_xy += u * v;
  }
  const double spread = count * sum_xx - sum_x * sum_x;
  return spread > 1e-12 * count * sum_xx ? (count * sum_xy - sum_x * sum_y) / spread : 0.0;
}

}  // namespace luminist
