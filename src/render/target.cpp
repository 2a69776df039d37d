#include "render/target.h"

#include <cmath>

#include "base/check.h"
#include "base/math.h"

namespace luminist {

bool sanitize_pixel(Target& target, std::size_t pixel) {
  if (!is_finite(target.before.rgb(pixel))) target.before.set_rgb(pixel, Vec3(0.0F));
  float& importance = target.importance.data[pixel];
  if (is_finite(target.color.rgb(pixel)) && std::isfinite(importance) && importance >= 0.0F) return false;
  target.color.set_rgb(pixel, target.before.rgb(pixel));
  importance = 0.0F;
  return true;
}

SanitizeReport sanitize(Target& target) {
  LUM_CHECK(target.color.channels == 3 && target.before.channels == 3 && target.importance.channels == 1,
            "colours have three channels, an importance one");
  LUM_CHECK(target.color.same_size(target.before) && target.color.same_size(target.importance), "all are of one size");
  SanitizeReport report;
  for (std::size_t pixel = 0; pixel < target.color.pixels(); ++pixel) {
    if (sanitize_pixel(target, pixel) && report.masked++ == 0) {
      const auto width = static_cast<std::size_t>(target.color.width);
      report.first_x = static_cast<int>(pixel % width);
      report.first_y = static_cast<int>(pixel / width);
    }
  }
  return report;
}

}  // namespace luminist
