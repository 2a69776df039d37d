#include "make_scene/drape.h"

#include <cstdint>
#include <vector>

namespace luminist {
namespace {

struct Link {
  std::uint32_t a;
  std::uint32_t b;
  double length;
  double stiffness;
};

class Sheet {
 public:
  explicit Sheet(const Drape& drape) : drape_(drape) {
    for (int j = 0; j <= drape.rows; ++j) {
      for (int i = 0; i <= drape.columns; ++i) {
        places_.push_back(drape.start(static_cast<double>(i) / drape.columns, static_cast<double>(j) / drape.rows));
      }
    }
    before_ = places_;
    link(1, 0, 1.0), link(0, 1, 1.0);
    link(1, 1, 0.5), link(1, -1, 0.5);
    link(2, 0, 0.35), link(0, 2, 0.35), link(5, 0, 0.12), link(0, 5, 0.12);
  }

  void step() {
    constexpr double kDrop = 9.81 / (120.0 * 120.0);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Point3 velocity = 0.985 * (places_[i] - before_[i]);
      before_[i] = places_[i];
      places_[i] += velocity - Point3(0.0, kDrop, 0.0);
    }
    for (int round = 0; round < 8; ++round) {
      for (const Link& l : links_) satisfy(l);
      for (std::size_t i = 0; i < places_.size(); ++i) collide(i);
    }
  }

  [[nodiscard]] const Point3& at(int i, int j) const {
    i = std::clamp(i, 0, drape_.columns), j = std::clamp(j, 0, drape_.rows);
    return places_[index(i, j)];
  }

 private:
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(drape_.columns + 1) + static_cast<std::size_t>(i);
  }

  void link(int di, int dj, double stiffness) {
    const Point2 cell{drape_.size.x / drape_.columns, drape_.size.y / drape_.rows};
    const double length = glm::length(Point2(di * cell.x, dj * cell.y));
    for (int j = 0; j <= drape_.rows; ++j) {
      for (int i = 0; i <= drape_.columns; ++i) {
        if (i + di > drape_.columns || j + dj > drape_.rows || j + dj < 0) continue;
        links_.push_back({static_cast<std::uint32_t>(index(i, j)), static_cast<std::uint32_t>(index(i + di, j + dj)),
                          length, stiffness});
      }
    }
  }

  void satisfy(const Link& l) {
    const Point3 span = places_[l.b] - places_[l.a];
    const double length = glm::length(span);
    if (length < 1e-9) return;
    const Point3 move = span * (0.5 * l.stiffness * (length - l.length) / length);
    places_[l.a] += move;
    places_[l.b] -= move;
  }

  void collide(std::size_t i) {
    Point3& p = places_[i];
    if (drape_.ceiling) p.y = std::min(p.y, drape_.ceiling(p));
    const double distance = drape_.obstacle(p) - drape_.thickness;
    if (distance >= 0.0) return;
    const Point3 normal = field_normal(drape_.obstacle, p, 1e-4);
    p -= normal * distance;
    const Point3 slide = p - before_[i];
    const Point3 tangential = slide - normal * glm::dot(slide, normal);
    const double length = glm::length(tangential);
    const double stopped = length > 0.0 ? std::min(1.0, -distance * drape_.friction / length) : 1.0;  // Coulomb
    p -= tangential * stopped;
    before_[i] = p - tangential * (1.0 - stopped);  // contacts do not bounce
  }

  const Drape& drape_;
  std::vector<Point3> places_;
  std::vector<Point3> before_;
  std::vector<Link> links_;
};

}  // namespace

Mesh fallen(const Drape& drape) {
  Sheet sheet(drape);
  for (int i = 0; i < drape.steps; ++i) sheet.step();
  Mesh mesh;
  for (int j = 0; j <= drape.rows; ++j) {
    for (int i = 0; i <= drape.columns; ++i) {
      const Point3 along = sheet.at(i + 1, j) - sheet.at(i - 1, j);
      const Point3 across = sheet.at(i, j + 1) - sheet.at(i, j - 1);
      mesh.positions.emplace_back(sheet.at(i, j));
      mesh.normals.emplace_back(glm::normalize(glm::cross(across, along)));
      mesh.uvs.emplace_back(static_cast<float>(i) / static_cast<float>(drape.columns),
                            static_cast<float>(j) / static_cast<float>(drape.rows));
    }
  }
  const auto stride = static_cast<std::uint32_t>(drape.columns + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(drape.rows); ++j) {
    for (std::uint32_t i = 0; i + 1 < stride; ++i) {
      const std::uint32_t a = j * stride + i;
      mesh.triangles.push_back({a, a + stride + 1, a + 1});
      mesh.triangles.push_back({a, a + stride, a + stride + 1});
    }
  }
  return mesh;
}

}  // namespace luminist
