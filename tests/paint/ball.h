#pragma once
// paint/ball.h -- a picture to paint on: a ball, half of it in a second colour, before a background.
#include <cmath>
#include <string>

#include "base/image.h"
#include "paint/canvas.h"
#include "render/surface_buffer.h"

namespace luminist {

/// A ball of radius 1 at the origin seen from (0, 0, 10) without perspective, its disc of radius 0.4 picture heights in
/// the middle. The left half is the object "ball left" (id 1), the right half "ball right" (id 2).
inline SurfaceBuffer ball_surface(int width, int height) {
  SurfaceBuffer s;
  s.width = width;
  s.height = height;
  s.eye = {0.0F, 0.0F, 10.0F};
  s.position.assign(s.pixels(), Vec3(0.0F));
  s.normal = s.albedo = s.specular = s.position;
  s.roughness.assign(s.pixels(), 0.0F);
  s.object.assign(s.pixels(), 0);
  s.material = s.object;
  s.object_names = {"", "ball left", "ball right"};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float h = 0.4F * static_cast<float>(height);
      const float u = (static_cast<float>(x) + 0.5F - 0.5F * static_cast<float>(width)) / h;
      const float v = (0.5F * static_cast<float>(height) - static_cast<float>(y) - 0.5F) / h;
      if (u * u + v * v >= 1.0F) continue;
      const std::size_t i = s.index(x, y);
      s.normal[i] = {u, v, std::sqrt(1.0F - u * u - v * v)};
      s.position[i] = s.normal[i];
      s.albedo[i] = u < 0.0F ? Vec3(0.8F, 0.4F, 0.2F) : Vec3(0.1F, 0.5F, 0.9F);
      s.object[i] = u < 0.0F ? 1 : 2;
      s.material[i] = s.object[i];
    }
  }
  return s;
}

/// A picture that is different at every pixel, so that what was copied or kept can be told apart.
inline Image varied_picture(int width, int height, float offset = 0.1F) {
  Image image(width, height, 3);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = offset + 0.001F * static_cast<float>(i % 97);
  return image;
}

inline Stroke click(const Brush& brush, float x, float y) {
  return {brush, {{x, y, 1.0F}}};
}

/// A brush that paints its colour as it is.
inline Brush flat_brush() {
  Brush brush;
  brush.texture = 0.0F;
  return brush;
}

}  // namespace luminist
