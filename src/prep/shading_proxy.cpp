#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/check.h"
#include "prep/decimate.h"
#include "prep/proxy.h"
#include "prep/split_sides.h"
#include "prep/subdivide.h"
#include "prep/triangle_tree.h"

namespace luminist {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Taubin's filter: a step towards the mean of the neighbours and a larger one back, so that form stays and bumps go.
constexpr int kSmoothings = 10;
constexpr float kForth = 0.5F, kBack = -0.53F;
constexpr int kLevels = 2;                         // of subdivision, fewer if
constexpr std::size_t kMostTriangles = 2'000'000;  // there would be more
constexpr int kReferenceSteps = 4;                 // of smoothing the normals by which sides are told apart
constexpr int kNormalSteps = 4;                    // of averaging a proxy's normals where it is not subdivided
constexpr float kSameSide = 0.5F;                  // cosine between normals of neighbours that are smoothed together
constexpr float kOtherSide = 0.1F;    // cosine between normals of neighbours, below which they are on different sides
constexpr float kLongestSide = 0.5F;  // of the mesh, in sides of the decimated proxy: normals bend within it
constexpr float kReach = 4.0F;        // sides of the decimated proxy, at least a share of the mesh's radius
constexpr float kLeastReach = 0.1F;
constexpr float kLeastAlike = 0.2F;    // of a normal and one that is lent
constexpr float kLeastFacing = 0.05F;  // cosine between a triangle and the sum of its normals

/// Vertices that share a triangle, each pair both ways; those on borders have none: they stay.
class Neighbourhood {
 public:
  Neighbourhood(std::size_t vertices, const std::vector<Triangle>& triangles) : first_(vertices + 1, 0) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const Triangle& t : triangles) {
      for (std::size_t k = 0; k < 3; ++k)
        pairs.emplace_back(t[k], t[(k + 1) % 3]), pairs.emplace_back(t[(k + 1) % 3], t[k]);
    }
    std::ranges::sort(pairs);
    std::vector<bool> border(vertices, false);
    for (std::size_t i = 0; i < pairs.size();) {
      std::size_t end = i;
      while (end < pairs.size() && pairs[end] == pairs[i]) ++end;
      if (end - i == 1) border[pairs[i].first] = true;
      i = end;
    }
    pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
    for (const auto& [from, to] : pairs) {
      neighbours_.push_back(to);
      ++first_[from + 1];
    }
    for (std::size_t v = 0; v < vertices; ++v) first_[v + 1] += first_[v];
    border_ = std::move(border);
  }

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t v) const {
    return std::span(neighbours_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  [[nodiscard]] bool on_border(std::size_t v) const { return border_[v]; }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> neighbours_;
  std::vector<bool> border_;
};

/// Vertices do not follow neighbours on another side: thin parts stay as thick as they are.
void smooth(Mesh& mesh) {
  const Neighbourhood around(mesh.positions.size(), mesh.triangles);
  for (int i = 0; i < kSmoothings; ++i) {
    for (const float step : {kForth, kBack}) {
      const std::vector<Vec3> before = mesh.positions;
      for (std::size_t v = 0; v < before.size(); ++v) {
        Vec3 sum(0.0F);
        float count = 0.0F;
        for (const std::uint32_t other : around.of(v)) {
          if (glm::dot(mesh.normals[v], mesh.normals[other]) < kOtherSide) continue;
          sum += before[other];
          count += 1.0F;
        }
        if (count > 0.0F && !around.on_border(v)) mesh.positions[v] += step * (sum / count - before[v]);
      }
    }
  }
  compute_normals(mesh, kPi);
}

Vec3 face_of(const Mesh& mesh, const Triangle& t) {
  return glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
}

/// At a place on a triangle, not unit.
Vec3 normal_at(const Mesh& mesh, const TriangleTree::Nearest& at) {
  const Triangle& t = mesh.triangles[at.triangle];
  return at.weights.x * mesh.normals[t[0]] + at.weights.y * mesh.normals[t[1]] + at.weights.z * mesh.normals[t[2]];
}

/// Decimation keeps vertices of the mesh, peaks and pits among them. Each is moved to where the surface around it lies
/// in the mean: by the mean way from the proxy to the mesh, weighted by area and by how much of the proxy there is its.
void move_to_mean(const Mesh& mesh, Mesh& proxy) {
  const TriangleTree tree(proxy);
  struct Way {
    Vec3 way{0.0F};
    float area = 0.0F;
    TriangleTree::Nearest from;
  };
  std::vector<Way> ways(mesh.triangles.size());
  tbb::parallel_for(std::size_t{0}, ways.size(), [&](std::size_t f) {
    const Triangle& t = mesh.triangles[f];
    const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0F;
    const Vec3 face = face_of(mesh, t);
    const auto near = tree.nearest(middle, std::numeric_limits<float>::infinity(),
                                   [&](const auto& at) { return glm::dot(normal_at(proxy, at), face) > 0.0F; });
    if (near) ways[f] = {middle - near->point, glm::length(face), *near};
  });
  std::vector<Vec3> sums(proxy.positions.size(), Vec3(0.0F));
  std::vector<float> weights(proxy.positions.size(), 0.0F);
  for (const Way& way : ways) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = proxy.triangles[way.from.triangle][static_cast<std::size_t>(k)];
      sums[v] += way.area * way.from.weights[k] * way.way;
      weights[v] += way.area * way.from.weights[k];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (weights[v] > 0.0F) proxy.positions[v] += sums[v] / weights[v];
  }
}

Mesh smooth_decimated(const Mesh& mesh, double share) {
  Mesh proxy = decimate_to(mesh, share);
  if (proxy.triangles.empty()) return proxy;
  move_to_mean(mesh, proxy);
  smooth(proxy);
  return proxy;
}

/// Averages unit normals with those of neighbours on the same side, in steps.
void average(const Mesh& mesh, int steps, std::vector<Vec3>& normals) {
  const Neighbourhood around(mesh.positions.size(), mesh.triangles);
  for (int i = 0; i < steps; ++i) {
    const std::vector<Vec3> before = normals;
    tbb::parallel_for(std::size_t{0}, normals.size(), [&](std::size_t v) {
      Vec3 sum = before[v];
      for (const std::uint32_t other : around.of(v)) {
        if (glm::dot(before[v], before[other]) > kSameSide) sum += before[other];
      }
      normals[v] = unit_or(sum, before[v]);
    });
  }
}

Mesh without_facets(Mesh mesh) {
  int levels = kLevels;
  for (std::size_t count = mesh.triangles.size() << (2U * kLevels); levels > 0 && count > kMostTriangles; count /= 4) {
    --levels;
  }
  // A surface that is no manifold keeps its facets.
  Result<Mesh> subdivided = subdivide_loop(mesh, levels);
  Mesh smoother = subdivided ? std::move(*subdivided) : std::move(mesh);
  std::vector<Vec3> normals = smoother.normals;
  average(smoother, kNormalSteps << static_cast<unsigned>(levels), normals);
  smoother.normals = std::move(normals);
  return smoother;
}

/// Turns normals back towards what they were until no triangle that faced along its normals faces against them: what
/// draws a triangle takes the side of its normals for its front.
void keep_fronts(const Mesh& mesh, std::vector<Vec3>& lent) {
  constexpr int kHalvings = 6;
  std::vector<float> share(lent.size(), 1.0F);
  const auto mixed = [&](std::uint32_t v) {
    return unit_or(glm::mix(mesh.normals[v], lent[v], share[v]), mesh.normals[v]);
  };
  for (int i = 0; i <= kHalvings; ++i) {
    std::vector<bool> wrong(lent.size(), false);
    for (const Triangle& t : mesh.triangles) {
      const Vec3 face = unit_or(face_of(mesh, t), Vec3(0.0F));
      if (glm::dot(face, mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]) <= 3.0F * kLeastFacing) continue;
      if (glm::dot(face, mixed(t[0]) + mixed(t[1]) + mixed(t[2])) > 3.0F * kLeastFacing) continue;
      for (const std::uint32_t v : t) wrong[v] = true;
    }
    for (std::size_t v = 0; v < lent.size(); ++v) {
      if (wrong[v]) share[v] = i == kHalvings ? 0.0F : 0.5F * share[v];
    }
  }
  for (std::uint32_t v = 0; v < lent.size(); ++v) lent[v] = mixed(v);
}

}  // namespace

Mesh make_shading_proxy(const Mesh& mesh, double share) {
  return without_facets(smooth_decimated(mesh, share));
}

LentNormals lend_normals(Mesh& mesh, double share) {
  LUM_CHECK(mesh.normals.size() == mesh.positions.size(), "loading fills normals");
  Mesh proxy = smooth_decimated(mesh, share);
  LentNormals result;
  result.triangles = proxy.triangles.size();
  split_long_sides(mesh, kLongestSide * proxy.mean_side(), kMostTriangles);
  const float reach = std::max(kReach * proxy.mean_side(), kLeastReach * mesh.bounds().radius());
  proxy = without_facets(std::move(proxy));
  const TriangleTree tree(proxy);
  std::vector<Vec3> reference = mesh.normals;
  average(mesh, kReferenceSteps, reference);
  std::vector<Vec3> lent = mesh.normals;
  std::vector<unsigned char> kept(lent.size(), 0);
  tbb::parallel_for(std::size_t{0}, lent.size(), [&](std::size_t v) {
    const auto near = tree.nearest(mesh.positions[v], reach, [&](const TriangleTree::Nearest& at) {
      return glm::dot(normal_at(proxy, at), reference[v]) > kLeastAlike;
    });
    kept[v] = near ? 0 : 1;
    if (near) lent[v] = unit_or(normal_at(proxy, *near), lent[v]);
  });
  keep_fronts(mesh, lent);
  for (std::size_t v = 0; v < lent.size(); ++v) {
    const double turn = std::acos(std::clamp(static_cast<double>(glm::dot(lent[v], mesh.normals[v])), -1.0, 1.0));
    result.mean_turn += turn / static_cast<double>(lent.size());
    result.worst_turn = std::max(result.worst_turn, turn);
    result.kept += kept[v];
  }
  mesh.normals = std::move(lent);
  return result;
}

}  // namespace luminist
