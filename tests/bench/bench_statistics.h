#pragma once
// tests/bench/bench_statistics.h -- numbers over several runs, some of which ended before they reached their goal.
#include <span>
#include <vector>

namespace luminist {

/// A number, or a bound that it is not below.
struct Bounded {
  double value = 0.0;
  bool at_least = false;
};

/// The middle of the values, or the mean of the two in the middle; 0 of none. It is a bound where a value up to the
/// middle is one: such a value may belong above it.
Bounded median(std::vector<Bounded> values);
double median(std::vector<double> values);

/// Slope of log y over log x by least squares: the exponent of a power law. Points with a number that is not positive
/// do not count; 0 with fewer than two points or equal x.
double exponent(std::span<const double> x, std::span<const double> y);

}  // namespace luminist
