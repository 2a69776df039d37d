#include "paint/importance.h"

namespace luminist {

float ImportanceMap::implied(std::size_t pixel, bool painted) const {
  if (painted) return 1.0F;
  const float before = previous.empty() ? nu : previous.data[pixel];
  return (1.0F - delta) * nu + delta * before;
}

float ImportanceMap::at(std::size_t pixel, bool painted) const {
  return over(pixel, implied(pixel, painted));
}

float ImportanceMap::over(std::size_t pixel, float below) const {
  if (paint.empty()) return below;
  return paint.data[2 * pixel] + (1.0F - paint.data[2 * pixel + 1]) * below;
}

void put_importance(Image& paint, std::size_t pixel, float value, float amount) {
  float* layer = &paint.data[2 * pixel];
  layer[0] = (1.0F - amount) * layer[0] + amount * value;
  layer[1] = (1.0F - amount) * layer[1] + amount;
}

void erase_importance(Image& paint, std::size_t pixel, float amount, const Image* below) {
  for (std::size_t c = 0; c < 2; ++c) {
    float& value = paint.data[2 * pixel + c];
    value *= 1.0F - amount;
    if (below != nullptr) value += amount * below->data[2 * pixel + c];
  }
}

}  // namespace luminist
