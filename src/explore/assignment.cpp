#include "explore/assignment.h"

#include <limits>

#include "base/check.h"

namespace luminist {
namespace {

constexpr int kNobody = -1;

/// Rows that have a column, with prices that keep every reduced cost at or above zero.
struct Matching {
  std::span<const double> costs;
  int n = 0;
  std::vector<double> row_price;
  std::vector<double> column_price;
  std::vector<int> row_of;  // [columns]

  [[nodiscard]] double reduced(int row, int column) const {
    const auto r = static_cast<std::size_t>(row);
    const auto c = static_cast<std::size_t>(column);
    return costs[r * static_cast<std::size_t>(n) + c] - row_price[r] - column_price[c];
  }
};

/// Gives one more row a column: the shortest path in reduced costs from the row to a free column (Dijkstra), along
/// which the rows change theirs.
void add_row(Matching& m, int row) {
  const auto size = static_cast<std::size_t>(m.n);
  std::vector<double> distance(size, std::numeric_limits<double>::infinity());
  std::vector<int> before(size, kNobody);  // the column from whose row a column was reached
  std::vector<bool> settled(size, false);
  int column = kNobody;
  int at = row;
  double walked = 0.0;
  while (true) {
    int nearest = kNobody;
    for (int c = 0; c < m.n; ++c) {
      const auto j = static_cast<std::size_t>(c);
      if (settled[j]) continue;
      const double length = walked + m.reduced(at, c);
      if (length < distance[j]) {
        distance[j] = length;
        before[j] = column;
      }
      if (nearest == kNobody || distance[j] < distance[static_cast<std::size_t>(nearest)]) nearest = c;
    }
    column = nearest;
    const auto j = static_cast<std::size_t>(column);
    settled[j] = true;
    walked = distance[j];
    if (m.row_of[j] == kNobody) break;
    at = m.row_of[j];
  }
  m.row_price[static_cast<std::size_t>(row)] += walked;
  for (std::size_t j = 0; j < size; ++j) {
    if (!settled[j] || m.row_of[j] == kNobody) continue;
    m.row_price[static_cast<std::size_t>(m.row_of[j])] += walked - distance[j];
    m.column_price[j] -= walked - distance[j];
  }
  while (column != kNobody) {
    const int previous = before[static_cast<std::size_t>(column)];
    m.row_of[static_cast<std::size_t>(column)] =
        previous == kNobody ? row : m.row_of[static_cast<std::size_t>(previous)];
    column = previous;
  }
}

}  // namespace

std::vector<int> least_cost_assignment(std::span<const double> costs, int n) {
  const auto size = static_cast<std::size_t>(n);
  LUM_CHECK(n >= 0 && costs.size() == size * size, "costs are square");
  Matching matching{costs, n, std::vector<double>(size, 0.0), std::vector<double>(size, 0.0),
                    std::vector<int>(size, kNobody)};
  for (int row = 0; row < n; ++row) add_row(matching, row);
  std::vector<int> column_of(size, kNobody);
  for (int c = 0; c < n; ++c) {
    column_of[static_cast<std::size_t>(matching.row_of[static_cast<std::size_t>(c)])] = c;
  }
  return column_of;
}

}  // namespace luminist
