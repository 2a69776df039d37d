#pragma once
// solve/box_solve.h -- least squares with bounds.
#include <span>

namespace luminist {

/// min x'Ax - 2b'x within [low, high], A symmetric positive semidefinite, row by row [n x n]; x holds the start, which
/// is moved into the bounds. What A does not touch (a zero on its diagonal) stays. Never worse than the start.
///
/// method  active set: the free coordinates are solved exactly, walk there until a bound stops one, and a coordinate
///         that would rather leave its bound is let go. cost O(n^3) for each change of the set.
/// source  Nocedal and Wright 2006, section 16.5.
void solve_box(std::span<const double> a, std::span<const double> b, std::span<const double> low,
               std::span<const double> high, std::span<double> x);

}  // namespace luminist
