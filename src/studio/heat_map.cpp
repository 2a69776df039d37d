#include "studio/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "studio/drawing.h"

namespace luminist {
namespace {

/// Linear RGB of an OKLab colour (lightness, green-red, blue-yellow).
Vec3 rgb_from_oklab(const Vec3& lab) {
  const auto cubed = [](float v) { return v * v * v; };
  const float l = cubed(lab.x + 0.3963377774F * lab.y + 0.2158037573F * lab.z);
  const float m = cubed(lab.x - 0.1055613458F * lab.y - 0.0638541728F * lab.z);
  const float s = cubed(lab.x - 0.0894841775F * lab.y - 1.2914855480F * lab.z);
  return {4.0767416621F * l - 3.3077115913F * m + 0.2309699292F * s,
          -1.2684380046F * l + 2.6097574011F * m - 0.3413193965F * s,
          -0.0041960863F * l - 0.7034186147F * m + 1.7076147010F * s};
}

/// Lightness, chroma and hue (degrees) at equal distances of t. Lightness is linear in t.
constexpr std::array kStops = {Vec3(0.06F, 0.00F, 290.0F), Vec3(0.25F, 0.10F, 290.0F), Vec3(0.43F, 0.15F, 335.0F),
                               Vec3(0.61F, 0.18F, 390.0F), Vec3(0.79F, 0.15F, 430.0F), Vec3(0.97F, 0.06F, 465.0F)};

}  // namespace

Vec3 heat_color(float t) {
  const float at = std::clamp(std::isfinite(t) ? t : 1.0F, 0.0F, 1.0F) * static_cast<float>(kStops.size() - 1);
  const auto index = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const Vec3 stop = glm::mix(kStops[index], kStops[index + 1], at - static_cast<float>(index));
  const float hue = stop.z * static_cast<float>(kPi / 180.0);
  const Vec3 color = rgb_from_oklab({stop.x, stop.y * std::cos(hue), stop.y * std::sin(hue)});
  return glm::clamp(color, 0.0F, 1.0F);
}

Image heat_map(const Image& values, float white) {
  Image map(values.width, values.height, 3);
  const auto channels = static_cast<std::size_t>(values.channels);
  for (std::size_t pixel = 0; pixel < values.pixels(); ++pixel) {
    map.set_rgb(pixel, heat_color(white > 0.0F ? values.data[pixel * channels] / white : 0.0F));
  }
  return map;
}

Image heat_map_with_scale(const Image& values, float white) {
  constexpr int kBar = 8;
  constexpr int kGap = 3;
  const Image map = heat_map(values, white);
  Image sheet(map.width, map.height + kBar + text_height(1) + 3 * kGap, 3);
  Drawing drawing(sheet);
  drawing.picture(0, 0, map);
  const int top = map.height + kGap;
  for (int x = 0; x < map.width; ++x) {
    drawing.fill(x, top, 1, kBar, heat_color((static_cast<float>(x) + 0.5F) / static_cast<float>(map.width)));
  }
  const std::string most = fmt::format("{:.3g} or more", white);
  const std::string brief = fmt::format("{:.3g}", white);
  const std::string& label = text_width("0 " + most, 1) <= map.width ? most : brief;
  const Vec3 ink(0.6F);
  drawing.text(0, top + kBar + kGap, "0", 1, ink);
  drawing.text(std::max(0, map.width - text_width(label, 1)), top + kBar + kGap, label, 1, ink);
  return sheet;
}

float quantile(const Image& values, double share) {
  std::vector<float> sorted;
  const auto channels = static_cast<std::size_t>(values.channels);
  for (std::size_t pixel = 0; pixel < values.pixels(); ++pixel) {
    if (std::isfinite(values.data[pixel * channels])) sorted.push_back(values.data[pixel * channels]);
  }
  if (sorted.empty()) return 0.0F;
  const auto rank = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(rank), sorted.end());
  return sorted[rank];
}

}  // namespace luminist
