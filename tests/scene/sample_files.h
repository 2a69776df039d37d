#pragma once
// tests/scene/sample_files.h -- a tetrahedron in every format.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "base/math.h"

namespace luminist {

inline const std::vector<Vec3>& tetrahedron_points() {
  static const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return points;
}

/// Counter-clockwise seen from outside.
inline const std::vector<std::array<std::uint32_t, 3>>& tetrahedron_faces() {
  static const std::vector<std::array<std::uint32_t, 3>> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return faces;
}

inline const char* tetrahedron_obj() {
  return "# four faces\no tetra\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
}

inline const char* tetrahedron_ply() {
  return "ply\nformat ascii 1.0\ncomment four faces\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

inline const char* tetrahedron_off() {
  return "OFF # four faces\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

template <class T>
void append_raw(std::string& to, T value, bool big_endian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (big_endian) std::reverse(raw, raw + sizeof(T));
  to.append(raw, sizeof(T));
}

inline std::string binary_ply(bool big_endian) {
  std::string file = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                     "_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                     "property uchar red\nelement face 4\nproperty list uchar ushort vertex_index\nend_header\n";
  for (const Vec3& p : tetrahedron_points()) {
    for (int i = 0; i < 3; ++i) append_raw(file, static_cast<double>(p[i]), big_endian);
    append_raw(file, std::uint8_t{200});
  }
  for (const auto& face : tetrahedron_faces()) {
    append_raw(file, std::uint8_t{3});
    for (const std::uint32_t index : face) append_raw(file, static_cast<std::uint16_t>(index), big_endian);
  }
  return file;
}

inline std::string binary_stl() {
  std::string file(80, ' ');
  append_raw(file, std::uint32_t{4});
  for (const auto& face : tetrahedron_faces()) {
    for (int i = 0; i < 3; ++i) append_raw(file, 0.0F);  // a normal that says nothing
    for (const std::uint32_t index : face) {
      for (int i = 0; i < 3; ++i) append_raw(file, tetrahedron_points()[index][i]);
    }
    append_raw(file, std::uint16_t{0});
  }
  return file;
}

inline std::string text_stl() {
  std::string file = "solid a vertex in a name\n";
  for (const auto& face : tetrahedron_faces()) {
    file += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t index : face) {
      const Vec3 p = tetrahedron_points()[index];
      file += "vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
    file += "endloop\nendfacet\n";
  }
  return file + "endsolid a vertex in a name\n";
}

/// The tetrahedron as one buffer (positions, then 16-bit indices), 48 + 24 bytes.
inline std::string tetrahedron_buffer() {
  std::string buffer;
  for (const Vec3& p : tetrahedron_points()) {
    for (int i = 0; i < 3; ++i) append_raw(buffer, p[i]);
  }
  for (const auto& face : tetrahedron_faces()) {
    for (const std::uint32_t index : face) append_raw(buffer, static_cast<std::uint16_t>(index));
  }
  return buffer;
}

/// A glTF that names tetrahedron_buffer() as buffer_uri; more is put in front of the other members
/// ("\"materials\":...,").
inline std::string tetrahedron_gltf(const std::string& buffer_uri, const std::string& more = "",
                                    const std::string& nodes = R"([{"mesh":0,"name":"tetra"}])",
                                    const std::string& primitive_more = "") {
  return R"({"asset":{"version":"2.0"},)" + more + R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
         R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1)" + primitive_more +
         R"(}]}],"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},)"
         R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],)"
         R"("buffers":[{"byteLength":72,"uri":")" +
         buffer_uri + R"("}]})";
}

inline std::string base64(const std::string& bytes) {
  static const char* const kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63U];
  }
  return text;
}

inline std::string embedded_buffer() {
  return "data:application/octet-stream;base64," + base64(tetrahedron_buffer());
}

}  // namespace luminist
