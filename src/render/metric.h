#pragma once
// render/metric.h -- the reference of the error that the solver minimizes; engines must agree with it.
#include <vector>

#include "base/image.h"
#include "render/target.h"
#include "style/style.h"

namespace luminist {

/// epsilon = sum_i I_i |T_i - R_i|_2 / sum_i I_i over pixels, after the style's blur of T and R (paper, section 5).
/// Sums in double, the pixels of a row in order and then the rows. returns 0 where the importance sums to 0.
double picture_error(const Image& picture, const Target& target, const StyleMetric& metric);

/// The sums of that error by row, so that where a few rows change only those are summed again. The same numbers as
/// picture_error() of pictures that the metric does not blur, or that are blurred already.
class RowErrors {
 public:
  /// T and I, 3 and 1 channels, against R in the rows y0 to y1 - 1; all of them the first time. cost O(their pixels)
  void compare(const Image& picture, const Image& color, const Image& importance, int y0, int y1);
  /// All of them. cost O(pixels)
  void compare(const Image& picture, const Image& color, const Image& importance) {
    compare(picture, color, importance, 0, picture.height);
  }
  [[nodiscard]] double error() const;  ///< cost O(rows)

 private:
  struct Row {
    double error = 0.0, importance = 0.0;
  };
  std::vector<Row> rows_;
};

/// The picture as the metric compares it: blurred, if it blurs.
Image as_compared(const Image& picture, const StyleMetric& metric);
/// A target as the metric compares it: what is wanted and what was there before are blurred, if it blurs.
Target as_compared(const Target& target, const StyleMetric& metric);

/// I_i |T_i - R_i|_2, 1 channel: where the error is.
Image residual_map(const Image& picture, const Target& target);

}  // namespace luminist
