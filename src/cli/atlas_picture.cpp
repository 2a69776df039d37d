#include "cli/atlas_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace luminist {
namespace {

constexpr Vec3 kGround(0.35F);

using Corners = std::array<Vec2, 3>;

float cross(const Vec2& a, const Vec2& b) {
  return a.x * b.y - a.y * b.x;
}

std::pair<std::uint32_t, std::uint32_t> edge(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

class AtlasDrawing {
 public:
  AtlasDrawing(const Unwrapped& unwrapped, int size_px)
      : unwrapped_(&unwrapped), image_(size_px, size_px, 3, kGround.x) {}

  Image draw() {
    const auto& triangles = unwrapped_->mesh.triangles;
    for (std::size_t f = 0; f < triangles.size(); ++f) fill(on_picture(f), color_of(f));
    // Vertices at one place of the atlas are one point: seams of the mesh's own attributes are no borders.
    std::map<std::pair<float, float>, std::uint32_t> points;
    const auto point = [&](std::uint32_t v) {
      const Vec2& at = unwrapped_->atlas[v];
      return points.try_emplace({at.x, at.y}, static_cast<std::uint32_t>(points.size())).first->second;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    for (const auto& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k) ++uses[edge(point(t[k]), point(t[(k + 1) % 3]))];
    }
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const Corners p = on_picture(f);
      const auto& t = triangles[f];
      for (std::size_t k = 0; k < 3; ++k) {
        const bool inside = uses[edge(point(t[k]), point(t[(k + 1) % 3]))] == 2;
        line(p[k], p[(k + 1) % 3], Vec3(0.0F), inside ? 0.12F : 0.8F);
      }
    }
    draw_ticks();
    return std::move(image_);
  }

 private:
  [[nodiscard]] Corners on_picture(std::size_t f) const {
    const auto& [a, b, c] = unwrapped_->mesh.triangles[f];
    const auto size = static_cast<float>(image_.width);
    return {size * unwrapped_->atlas[a], size * unwrapped_->atlas[b], size * unwrapped_->atlas[c]};
  }

  [[nodiscard]] Vec3 color_of(std::size_t f) const {
    const auto& [a, b, c] = unwrapped_->mesh.triangles[f];
    const auto& p = unwrapped_->mesh.positions;
    const auto& s = unwrapped_->strokes;
    const float surface = glm::length(glm::cross(p[b] - p[a], p[c] - p[a]));
    const float plane = cross(s[b] - s[a], s[c] - s[a]);
    if (!(surface > 0.0F) || !(plane > 0.0F)) return Vec3(1.0F);
    const float change = std::clamp(std::log2(plane / surface), -1.0F, 1.0F);
    const float rest = 1.0F - std::abs(change);
    return change > 0.0F ? Vec3(1.0F, rest, rest) : Vec3(rest, rest, 1.0F);
  }

  void mix(int x, int y, const Vec3& color, float alpha) {
    if (x < 0 || y < 0 || x >= image_.width || y >= image_.height) return;
    const std::size_t pixel = image_.index(x, y);
    image_.set_rgb(pixel, glm::mix(image_.rgb(pixel), color, alpha));
  }

  void fill(const Corners& p, const Vec3& color) {
    const Vec2 lo = glm::min(p[0], glm::min(p[1], p[2]));
    const Vec2 hi = glm::max(p[0], glm::max(p[1], p[2]));
    const float area = cross(p[1] - p[0], p[2] - p[0]);
    for (int y = static_cast<int>(lo.y); y <= static_cast<int>(hi.y); ++y) {
      for (int x = static_cast<int>(lo.x); x <= static_cast<int>(hi.x); ++x) {
        const Vec2 at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) inside = inside && cross(p[(k + 1) % 3] - p[k], at - p[k]) * area >= 0.0F;
        if (inside) mix(x, y, color, 1.0F);
      }
    }
  }

  void line(const Vec2& from, const Vec2& to, const Vec3& color, float alpha) {
    const Vec2 way = to - from;
    const int steps = static_cast<int>(std::ceil(std::max(std::abs(way.x), std::abs(way.y))));
    for (int i = 0; i <= steps; ++i) {
      const Vec2 at = from + way * (static_cast<float>(i) / static_cast<float>(std::max(steps, 1)));
      mix(static_cast<int>(at.x), static_cast<int>(at.y), color, alpha);
    }
  }

  /// Where u runs, about every twenty pixels: at the first triangle that covers a cell of that size.
  void draw_ticks() {
    constexpr float kCell = 20.0F;
    std::map<std::pair<int, int>, bool> taken;
    for (std::size_t f = 0; f < unwrapped_->mesh.triangles.size(); ++f) {
      const Corners p = on_picture(f);
      const Vec2 middle = (p[0] + p[1] + p[2]) / 3.0F;
      auto& is_taken = taken[{static_cast<int>(middle.x / kCell), static_cast<int>(middle.y / kCell)}];
      if (std::exchange(is_taken, true)) continue;
      const auto& [a, b, c] = unwrapped_->mesh.triangles[f];
      const auto& s = unwrapped_->strokes;
      const Vec2 e = s[b] - s[a];
      const Vec2 g = s[c] - s[a];
      const float area = cross(e, g);
      if (!(std::abs(area) > 0.0F)) continue;
      // (1, 0) = x e + y g in the plane of strokes, carried to the picture.
      const Vec2 u = (g.y / area) * (p[1] - p[0]) - (e.y / area) * (p[2] - p[0]);
      const float length = glm::length(u);
      if (!(length > 0.0F)) continue;
      const Vec2 half = u * (0.35F * kCell / length);
      line(middle - half, middle + half, Vec3(0.0F, 0.25F, 0.0F), 0.9F);
    }
  }

  const Unwrapped* unwrapped_;
  Image image_;
};

}  // namespace

Image draw_atlas(const Unwrapped& unwrapped, int size_px) {
  return AtlasDrawing(unwrapped, size_px).draw();
}

}  // namespace luminist
