#pragma once
// solve/color_solve.h -- colours of lights in closed form: the picture is linear in them.
#include <array>
#include <span>
#include <vector>

#include "solve/sample_cells.h"

namespace luminist {

/// How residuals add up: the paper's un-squared norm, or plain least squares.
enum class Norm { kUnsquared, kSquared };

/// One light's colour: which channels may change and how far.
struct ColorRange {
  std::array<bool, 3> free{false, false, false};
  std::array<double, 3> low{0.0, 0.0, 0.0};
  std::array<double, 3> high{1.0, 1.0, 1.0};
};

/// sum_c weight_c |target_c - picture_c|, or with squares. picture [cells.size()]
double cell_cost(const SampleCells& cells, std::span<const Vec3> picture, Norm norm);

/// Minimizes cell_cost of rest + sum_k colors[k] * white[k] over the free channels within their ranges.
///
/// rest    [cells] what the colours do not touch.
/// white   [lights] each [cells], the light's part for the colour (1, 1, 1).
/// colors  [lights] in: where the weights of the un-squared norm come from; out: the minimum. Never costs more.
/// method  box-bounded least squares per channel, reweighted for the un-squared norm. cost O(cells lights^2).
void solve_colors(const SampleCells& cells, std::span<const Vec3> rest, std::span<const CellField* const> white,
                  std::span<const ColorRange> ranges, Norm norm, std::span<Vec3> colors);

}  // namespace luminist
