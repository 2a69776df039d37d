#pragma once
// explore/assignment.h -- who goes with whom at the least total cost.
#include <span>
#include <vector>

namespace luminist {

/// A permutation p of 0..n-1 that minimizes the sum of costs[i * n + p[i]]; of equal ones always the same.
/// costs [n x n], finite and >= 0. cost O(n^3). source: Kuhn 1955, with the shortest augmenting paths of Jonker and
/// Volgenant 1987.
std::vector<int> least_cost_assignment(std::span<const double> costs, int n);

}  // namespace luminist
