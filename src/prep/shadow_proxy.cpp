#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "prep/decimate.h"
#include "prep/proxy.h"
#include "prep/triangle_tree.h"

namespace luminist {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr int kSweeps = 24;
constexpr float kFarthest = 0.05F;                       // of the mesh's radius, that a vertex moves
constexpr float kTolerance = 1e-4F;                      // of the mesh's radius
constexpr float kFewestSteps = 2.0F, kMostSteps = 8.0F;  // of samples along a triangle's side

/// A surface with an outside.
class Solid {
 public:
  explicit Solid(const Mesh& mesh) : mesh_(mesh), tree_(mesh) { compute_normals(mesh_, kPi); }

  /// How far a point lies outside, and the way there from the surface (unit); 0 inside.
  float outside(const Vec3& p, Vec3& way) const {
    const auto any = [](const TriangleTree::Nearest&) { return true; };
    const auto near = tree_.nearest(p, std::numeric_limits<float>::infinity(), any);
    if (!near) return 0.0F;
    const float distance = std::sqrt(near->squared_distance);
    way = (p - near->point) / std::max(distance, std::numeric_limits<float>::min());
    return glm::dot(way, normal_at(*near)) > 0.0F ? distance : 0.0F;
  }

 private:
  /// Within a triangle its own; at its edges and corners, where several meet, one that all agree with.
  /// source Baerentzen and Aanaes 2005.
  [[nodiscard]] Vec3 normal_at(const TriangleTree::Nearest& near) const {
    constexpr float kInside = 1e-4F;
    const Triangle& t = mesh_.triangles[near.triangle];
    const auto at = [&](std::size_t k) { return mesh_.positions[t[k]]; };
    const Vec3& w = near.weights;
    if (std::min({w.x, w.y, w.z}) > kInside) return glm::cross(at(1) - at(0), at(2) - at(0));
    return w.x * mesh_.normals[t[0]] + w.y * mesh_.normals[t[1]] + w.z * mesh_.normals[t[2]];
  }

  Mesh mesh_;
  TriangleTree tree_;
};

/// A place on a triangle of the proxy that must not lie beyond a plane.
struct Contact {
  std::uint32_t triangle = 0;
  Vec3 weights{0.0F};
  Vec3 way{0.0F};      ///< normal of the plane
  float limit = 0.0F;  ///< its distance from the origin
};

/// Moves the vertices of a proxy as little as it takes: every contact is met by the least movement of its triangle's
/// corners that does, in turns. source of the scheme: position based dynamics (Mueller et al. 2007).
class PullingIn {
 public:
  PullingIn(const Mesh& mesh, Mesh& proxy)
      : solid_(mesh),
        proxy_(&proxy),
        start_(proxy.positions),
        radius_(mesh.bounds().radius()),
        step_(mesh.mean_side()) {}

  ShadowProxy run() {
    std::vector<std::uint32_t> all(proxy_->triangles.size());
    std::iota(all.begin(), all.end(), 0U);
    std::vector<std::uint32_t> triangles = all;
    for (int sweep = 0; sweep < kSweeps && !triangles.empty(); ++sweep) triangles = move(contacts(triangles));
    ShadowProxy result;
    for (const Contact& contact : contacts(all)) {
      result.sticks_out = std::max(result.sticks_out, beyond(contact));
    }
    for (std::size_t v = 0; v < start_.size(); ++v) {
      result.moved = std::max(result.moved, glm::distance(start_[v], proxy_->positions[v]));
    }
    return result;
  }

 private:
  [[nodiscard]] Vec3 place(const Contact& c) const {
    const Triangle& t = proxy_->triangles[c.triangle];
    const std::vector<Vec3>& p = proxy_->positions;
    return c.weights.x * p[t[0]] + c.weights.y * p[t[1]] + c.weights.z * p[t[2]];
  }
  [[nodiscard]] float beyond(const Contact& c) const { return glm::dot(place(c), c.way) - c.limit; }

  /// Where these triangles stick out of the solid, at samples about as dense as its vertices.
  [[nodiscard]] std::vector<Contact> contacts(const std::vector<std::uint32_t>& triangles) const {
    std::vector<std::vector<Contact>> found(triangles.size());
    tbb::parallel_for(std::size_t{0}, triangles.size(), [&](std::size_t i) {
      const Triangle& t = proxy_->triangles[triangles[i]];
      float longest = 0.0F;
      for (std::size_t k = 0; k < 3; ++k) {
        longest = std::max(longest, glm::distance(proxy_->positions[t[k]], proxy_->positions[t[(k + 1) % 3]]));
      }
      const float wanted = std::clamp(longest / std::max(step_, 1e-30F), kFewestSteps, kMostSteps);
      const int steps = static_cast<int>(std::lround(wanted));
      for (int a = 0; a <= steps; ++a) {
        for (int b = 0; a + b <= steps; ++b) {
          Contact contact{triangles[i], Vec3(a, b, steps - a - b) / static_cast<float>(steps), Vec3(0.0F), 0.0F};
          const Vec3 p = place(contact);
          const float out = solid_.outside(p, contact.way);
          if (out <= kTolerance * radius_) continue;
          contact.limit = glm::dot(p, contact.way) - out;
          found[i].push_back(contact);
        }
      }
    });
    std::vector<Contact> all;
    for (const std::vector<Contact>& list : found) all.insert(all.end(), list.begin(), list.end());
    return all;
  }

  /// Meets the contacts one after the other; returns the triangles of which a corner moved.
  std::vector<std::uint32_t> move(const std::vector<Contact>& contacts) {
    std::vector<bool> moved(proxy_->positions.size(), false);
    for (const Contact& contact : contacts) {
      const float distance = beyond(contact);
      if (distance <= 0.0F) continue;
      const Vec3& w = contact.weights;
      const Vec3 shift = contact.way * (distance / glm::dot(w, w));
      const Triangle& t = proxy_->triangles[contact.triangle];
      for (int k = 0; k < 3; ++k) {
        if (w[k] <= 0.0F) continue;
        const std::uint32_t v = t[static_cast<std::size_t>(k)];
        const Vec3 way = proxy_->positions[v] - w[k] * shift - start_[v];
        const float length = glm::length(way);
        const float farthest = kFarthest * radius_;
        proxy_->positions[v] = start_[v] + way * (length > farthest ? farthest / length : 1.0F);
        moved[v] = true;
      }
    }
    std::vector<std::uint32_t> triangles;
    for (std::uint32_t f = 0; f < proxy_->triangles.size(); ++f) {
      const Triangle& t = proxy_->triangles[f];
      if (moved[t[0]] || moved[t[1]] || moved[t[2]]) triangles.push_back(f);
    }
    return triangles;
  }

  Solid solid_;
  Mesh* proxy_;
  std::vector<Vec3> start_;
  float radius_;
  float step_;
};

}  // namespace

ShadowProxy make_shadow_proxy(const Mesh& mesh, double share) {
  Mesh proxy = decimate_to(mesh, share);
  ShadowProxy result = PullingIn(mesh, proxy).run();
  compute_normals(proxy, kPi);
  result.mesh = std::move(proxy);
  return result;
}

}  // namespace luminist
