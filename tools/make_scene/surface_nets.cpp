#include "make_scene/surface_nets.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace luminist {
namespace {

constexpr int kBlock = 8;  // cells along a block that is skipped or sampled as a whole

struct Lattice {
  const Field& field;
  Point3 origin;
  double cell;
  std::array<int, 3> blocks;

  [[nodiscard]] Point3 place(const std::array<int, 3>& at) const { return origin + cell * Point3(at[0], at[1], at[2]); }
  [[nodiscard]] std::uint64_t key(const std::array<int, 3>& at) const {
    const auto word = [](int i) { return static_cast<std::uint64_t>(i + 1); };
    return word(at[0]) | word(at[1]) << 21U | word(at[2]) << 42U;
  }
};

using Samples = std::array<float, (kBlock + 1) * (kBlock + 1) * (kBlock + 1)>;

std::size_t sample_index(int i, int j, int k) {
  return static_cast<std::size_t>((k * (kBlock + 1) + j) * (kBlock + 1) + i);
}

/// The mean of the crossings on a cell's twelve edges, from its eight corner values; false if there is none.
bool cell_vertex(const std::array<float, 8>& corner, Point3& vertex) {
  Point3 sum(0.0);
  int crossings = 0;
  for (int a = 0; a < 8; ++a) {
    for (int axis = 0; axis < 3; ++axis) {
      if ((a >> axis) & 1) continue;
      const int b = a | (1 << axis);
      const double va = corner[static_cast<std::size_t>(a)];
      const double vb = corner[static_cast<std::size_t>(b)];
      if ((va < 0.0) == (vb < 0.0)) continue;
      Point3 p(a & 1, (a >> 1) & 1, a >> 2);
      p[axis] = va / (va - vb);
      sum += p;
      ++crossings;
    }
  }
  if (crossings == 0) return false;
  vertex = sum / static_cast<double>(crossings);
  return true;
}

/// Two Newton steps along the gradient, each at most a cell.
Point3 on_surface(const Field& field, Point3 p, double cell) {
  for (int i = 0; i < 2; ++i) {
    const double value = field(p);
    p -= field_normal(field, p, 0.25 * cell) * std::clamp(value, -cell, cell);
  }
  return p;
}

class Net {
 public:
  explicit Net(const Lattice& lattice) : lattice_(lattice) {}

  void visit(const std::array<int, 3>& block) {
    const std::array<int, 3> first{block[0] * kBlock, block[1] * kBlock, block[2] * kBlock};
    Samples samples;
    for (int k = 0; k <= kBlock; ++k) {
      for (int j = 0; j <= kBlock; ++j) {
        for (int i = 0; i <= kBlock; ++i) {
          samples[sample_index(i, j, k)] =
              static_cast<float>(lattice_.field(lattice_.place({first[0] + i, first[1] + j, first[2] + k})));
        }
      }
    }
    for (int k = 0; k < kBlock; ++k) {
      for (int j = 0; j < kBlock; ++j) {
        for (int i = 0; i < kBlock; ++i) add_cell(samples, first, {i, j, k});
      }
    }
  }

  /// Joins the four cells around every crossed edge.
  Mesh mesh() {
    for (const Edge& edge : edges_) {
      const int u = (edge.axis + 1) % 3;
      const int v = (edge.axis + 2) % 3;
      std::array<std::uint32_t, 4> quad{};
      bool whole = true;
      for (int n = 0; n < 4; ++n) {
        std::array<int, 3> at = edge.cell;
        at[static_cast<std::size_t>(u)] -= n == 1 || n == 2 ? 1 : 0;
        at[static_cast<std::size_t>(v)] -= n >= 2 ? 1 : 0;
        const auto found = vertices_.find(lattice_.key(at));
        whole = whole && found != vertices_.end();
        if (whole) quad[static_cast<std::size_t>(n)] = found->second;
      }
      if (whole) add_quad(quad, edge.inside_first);
    }
    return std::move(mesh_);
  }

 private:
  struct Edge {
    std::array<int, 3> cell;
    int axis;
    bool inside_first;
  };

  void add_cell(const Samples& samples, const std::array<int, 3>& first, const std::array<int, 3>& at) {
    std::array<float, 8> corner{};
    for (int n = 0; n < 8; ++n) {
      corner[static_cast<std::size_t>(n)] =
          samples[sample_index(at[0] + (n & 1), at[1] + ((n >> 1) & 1), at[2] + (n >> 2))];
    }
    Point3 local;
    if (!cell_vertex(corner, local)) return;
    const std::array<int, 3> cell{first[0] + at[0], first[1] + at[1], first[2] + at[2]};
    vertices_.emplace(lattice_.key(cell), static_cast<std::uint32_t>(mesh_.positions.size()));
    mesh_.positions.emplace_back(lattice_.place(cell) + local * lattice_.cell);
    for (int axis = 0; axis < 3; ++axis) {
      const bool inside = corner[0] < 0.0F;
      if (inside != (corner[static_cast<std::size_t>(1 << axis)] < 0.0F)) edges_.push_back({cell, axis, inside});
    }
  }

  void add_quad(std::array<std::uint32_t, 4> q, bool inside_first) {
    if (!inside_first) std::swap(q[1], q[3]);
    const auto& p = mesh_.positions;
    if (glm::length(p[q[0]] - p[q[2]]) <= glm::length(p[q[1]] - p[q[3]])) {
      mesh_.triangles.push_back({q[0], q[1], q[2]}), mesh_.triangles.push_back({q[0], q[2], q[3]});
    } else {
      mesh_.triangles.push_back({q[0], q[1], q[3]}), mesh_.triangles.push_back({q[1], q[2], q[3]});
    }
  }

  const Lattice& lattice_;
  Mesh mesh_;
  std::vector<Edge> edges_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
};

}  // namespace

Mesh surface_nets(const Field& field, const FieldBox& box, double cell, double lipschitz) {
  Lattice lattice{field, box.lo, cell, {}};
  for (int axis = 0; axis < 3; ++axis) {
    lattice.blocks[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((box.hi[axis] - box.lo[axis]) / (cell * kBlock)));
  }
  Net net(lattice);
  const double reach = 0.5 * std::sqrt(3.0) * kBlock * cell * lipschitz;
  for (int k = 0; k < lattice.blocks[2]; ++k) {
    for (int j = 0; j < lattice.blocks[1]; ++j) {
      for (int i = 0; i < lattice.blocks[0]; ++i) {
        const Point3 center = box.lo + cell * kBlock * (Point3(i, j, k) + 0.5);
        if (std::abs(field(center)) < reach) net.visit({i, j, k});
      }
    }
  }
  return net.mesh();
}

void snap_to_field(Mesh& mesh, const Field& field, double cell) {
  mesh.normals.resize(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Point3 p = on_surface(field, Point3(mesh.positions[i]), cell);
    mesh.positions[i] = Vec3(p);
    mesh.normals[i] = Vec3(field_normal(field, p, 0.3 * cell));
  }
}

}  // namespace luminist
