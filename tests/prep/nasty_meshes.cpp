#include "prep/nasty_meshes.h"

#include <random>

#include "raster/mesh_scenes.h"

namespace luminist::test {
namespace {

Mesh with_normals(Mesh mesh) {
  mesh.normals.clear();
  compute_normals(mesh, kPi);
  return mesh;
}

Mesh crumpled_sphere() {
  std::mt19937 random(5);
  Mesh mesh = sphere_mesh(1.0F, 20);
  const std::vector<std::uint32_t> place = places_of(mesh.positions);
  std::vector<float> radius(mesh.positions.size());
  for (float& r : radius) r = 0.85F + 0.3F * static_cast<float>(random() % 1000) / 1000.0F;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) mesh.positions[v] *= radius[place[v]];
  return with_normals(std::move(mesh));
}

Mesh dust() {
  std::mt19937 random(9);
  Mesh mesh;
  for (int i = 0; i < 300; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Vec3 at(random() % 997, random() % 997, random() % 997);
    for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
      mesh.positions.push_back(at + 0.5F * corner);
    }
    for (const auto& t : std::vector<std::array<std::uint32_t, 3>>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
      mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return with_normals(std::move(mesh));
}

Mesh with_bad_triangles() {
  Mesh mesh = box_mesh();
  mesh.triangles.push_back(mesh.triangles[3]);
  mesh.triangles.push_back({0, 0, 1});
  mesh.positions.push_back(0.5F * (mesh.positions[0] + mesh.positions[1]));
  mesh.normals.push_back(mesh.normals[0]);
  mesh.triangles.push_back({0, 1, static_cast<std::uint32_t>(mesh.positions.size() - 1)});
  return mesh;
}

Mesh of(std::vector<Vec3> positions, std::vector<std::array<std::uint32_t, 3>> triangles) {
  Mesh mesh;
  mesh.positions = std::move(positions), mesh.triangles = std::move(triangles);
  return with_normals(std::move(mesh));
}

}  // namespace

Mesh torus_mesh(double large, double small, int around, int across) {
  Mesh mesh;
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>((i % around) * across + j % across); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2.0 * kPi * i / around;
      const double v = 2.0 * kPi * j / across;
      const double r = large + small * std::cos(v);
      mesh.positions.emplace_back(r * std::cos(u), r * std::sin(u), small * std::sin(v));
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return with_normals(std::move(mesh));
}

Mesh tube_mesh(double radius, double height, int around, int along) {
  Mesh mesh;
  const auto index = [&](int i, int j) { return static_cast<std::uint32_t>(j * around + i % around); };
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i < around; ++i) {
      const double u = 2.0 * kPi * i / around;
      mesh.positions.emplace_back(radius * std::cos(u), height * j / along, -radius * std::sin(u));
      if (j == along) continue;
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return with_normals(std::move(mesh));
}

Mesh plate_with_holes(int holes) {
  const int width = 2 * holes + 1;
  const auto solid = [&](int x, int y) { return x >= 0 && y >= 0 && x < width && y < 3 && !(y == 1 && x % 2 == 1); };
  Mesh mesh;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
    mesh.triangles.push_back({first, first + 1, first + 2}), mesh.triangles.push_back({first, first + 2, first + 3});
  };
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!solid(x, y)) continue;
      const auto at = [&](int dx, int dy, int z) { return Vec3(x + dx, y + dy, z); };
      add(at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
      add(at(0, 0, 0), at(0, 1, 0), at(1, 1, 0), at(1, 0, 0));
      if (!solid(x - 1, y)) add(at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0));
      if (!solid(x + 1, y)) add(at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1));
      if (!solid(x, y - 1)) add(at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1));
      if (!solid(x, y + 1)) add(at(0, 1, 0), at(0, 1, 1), at(1, 1, 1), at(1, 1, 0));
    }
  }
  return with_normals(std::move(mesh));
}

Mesh moebius_mesh(int steps) {
  Mesh band;
  for (int i = 0; i < steps; ++i) {
    const double u = 2.0 * kPi * i / steps;
    for (const double v : {-0.3, 0.3}) {
      const double r = 1.0 + v * std::cos(0.5 * u);
      band.positions.emplace_back(r * std::cos(u), v * std::sin(0.5 * u), r * std::sin(u));
    }
  }
  for (int i = 0; i < steps; ++i) {
    const bool last = i + 1 == steps;
    const auto a = static_cast<std::uint32_t>(2 * i);
    const std::uint32_t b = last ? 1 : a + 2;
    const std::uint32_t c = last ? 0 : a + 3;
    band.triangles.push_back({a, a + 1, b});
    band.triangles.push_back({b, a + 1, c});
  }
  return with_normals(std::move(band));
}

std::vector<NamedMesh> nasty_meshes() {
  std::vector<NamedMesh> meshes;
  meshes.push_back({"sphere", sphere_mesh(1.0F, 24)});
  meshes.push_back({"torus", torus_mesh(1.0, 0.4, 48, 24)});
  meshes.push_back({"genus 2", plate_with_holes(2)});
  meshes.push_back({"genus 5", plate_with_holes(5)});
  meshes.push_back({"cube", box_mesh()});
  meshes.push_back({"tube", tube_mesh(0.5, 2.0, 32, 12)});
  meshes.push_back({"moebius", moebius_mesh(24)});
  meshes.push_back({"bow tie", of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 3, 4}})});
  meshes.push_back(
      {"fin", of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})});
  meshes.push_back({"bad triangles", with_bad_triangles()});
  meshes.push_back({"dust", dust()});
  meshes.push_back({"crumpled", crumpled_sphere()});
  meshes.push_back({"heap", heap_mesh(11, 60, 9, 400)});
  meshes.push_back({"triangle", of({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})});
  meshes.push_back({"nothing", Mesh{}});
  return meshes;
}

}  // namespace luminist::test
