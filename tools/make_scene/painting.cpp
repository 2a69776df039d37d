#include "make_scene/painting.h"

#include <cmath>

namespace luminist {

Image paint_color(int width, int height, const ColorField& color) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Vec3 sum(0.0F);
      for (int s = 0; s < 4; ++s)
        sum += color((x + 0.25 + 0.5 * (s & 1)) / width, (y + 0.25 + 0.5 * (s >> 1)) / height);
      image.set_rgb(image.index(x, y), 0.25F * sum);
    }
  }
  return image;
}

Image paint_normals(int width, int height, const HeightField& field, const Point2& extent) {
  Image heights(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      heights.at(x, y, 0) = static_cast<float>(field((x + 0.5) / width, (y + 0.5) / height));
    }
  }
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double east = heights.at((x + 1) % width, y, 0) - heights.at((x + width - 1) % width, y, 0);
      const double south = heights.at(x, (y + 1) % height, 0) - heights.at(x, (y + height - 1) % height, 0);
      const Point3 n = glm::normalize(Point3(-0.5 * east * width / extent.x, 0.5 * south * height / extent.y, 1.0));
      image.set_rgb(image.index(x, y), Vec3(n * 0.5 + 0.5));
    }
  }
  return image;
}

Image paint_roughness(int width, int height, const HeightField& roughness, double metallic) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double r = roughness((x + 0.5) / width, (y + 0.5) / height);
      image.set_rgb(image.index(x, y), {0.0F, static_cast<float>(r), static_cast<float>(metallic)});
    }
  }
  return image;
}

Vec3 swatch(unsigned rgb) {
  const auto channel = [&](unsigned shift) {
    return linear_from_srgb(static_cast<float>((rgb >> shift) & 255U) / 255.0F);
  };
  return {channel(16U), channel(8U), channel(0U)};
}

Vec3 mix(const Vec3& a, const Vec3& b, double t) {
  return a + (b - a) * static_cast<float>(t);
}

}  // namespace luminist
