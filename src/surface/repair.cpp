#include "surface/repair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <glm/ext/vector_double3.hpp>

#include "base/disjoint_sets.h"

namespace luminist {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A triangle on its way: corners as places and as the mesh's vertices, wound alike.
struct Face {
  Triangle places;
  Triangle vertices;

  void turn() { std::swap(places[1], places[2]), std::swap(vertices[1], vertices[2]); }
};

/// Side `side` of a face runs from its corner of that number to the next.
struct Side {
  std::uint32_t lo = 0;
  std::uint32_t hi = 0;
  std::uint32_t face = 0;
  std::uint8_t side = 0;
  bool upward = false;  ///< from lo to hi
};

std::vector<Side> sorted_sides(const std::vector<Face>& faces) {
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint8_t k = 0; k < 3; ++k) {
      const std::uint32_t a = faces[f].places[k];
      const std::uint32_t b = faces[f].places[(k + 1U) % 3U];
      sides.push_back({std::min(a, b), std::max(a, b), f, k, a < b});
    }
  }
  std::ranges::stable_sort(sides,
                           [](const Side& a, const Side& b) { return std::tie(a.lo, a.hi) < std::tie(b.lo, b.hi); });
  return sides;
}

/// Calls visit(first, last) for each run of sides between the same two places.
template <class Visit>
void for_edges(const std::vector<Side>& sides, Visit&& visit) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].lo == sides[first].lo && sides[last].hi == sides[first].hi) ++last;
    visit(first, last);
    first = last;
  }
}

bool has_area(const Mesh& mesh, const Triangle& t) {
  constexpr double kThinnest = 1e-7;  // below, the normal is made of rounding errors
  const glm::dvec3 a(mesh.positions[t[0]]);
  const glm::dvec3 b(mesh.positions[t[1]]);
  const glm::dvec3 c(mesh.positions[t[2]]);
  const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
  return glm::length(glm::cross(b - a, c - a)) > kThinnest * longest;
}

std::vector<Face> usable_faces(const Mesh& mesh, const std::vector<std::uint32_t>& place, RepairReport& report) {
  std::vector<Face> faces;
  std::set<Triangle> known;
  for (const Triangle& t : mesh.triangles) {
    const Face face{{place[t[0]], place[t[1]], place[t[2]]}, t};
    const auto& [a, b, c] = face.places;
    if (a == b || b == c || c == a || !has_area(mesh, t)) {
      ++report.degenerate;
      continue;
    }
    Triangle key = face.places;
    std::ranges::sort(key);
    if (known.insert(key).second) {
      faces.push_back(face);
    } else {
      ++report.duplicate;
    }
  }
  return faces;
}

/// Faces that share a side with one other face, [3 * face + side]: the other's number, or none.
class Neighbours {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  Neighbours(const std::vector<Side>& sides, std::size_t faces) : face_(3 * faces, kNone) {
    for_edges(sides, [&](std::size_t first, std::size_t last) {
      if (last - first != 2) return;
      join(sides[first], sides[first + 1]);
      join(sides[first + 1], sides[first]);
    });
  }
  [[nodiscard]] std::uint32_t across(std::uint32_t face, std::uint32_t side) const { return face_[3 * face + side]; }

 private:
  void join(const Side& side, const Side& other) { face_[3 * side.face + side.side] = other.face; }
  std::vector<std::uint32_t> face_;
};

/// Whether two neighbours are wound alike over the side: then they run along it in opposite directions.
bool wound_alike(const Face& a, std::uint32_t side, const Face& b) {
  const std::uint32_t from = a.places[side];
  const std::uint32_t to = a.places[(side + 1) % 3];
  for (std::size_t k = 0; k < 3; ++k) {
    if (b.places[k] == to && b.places[(k + 1) % 3] == from) return true;
  }
  return false;
}

double volume(const Mesh& mesh, const std::vector<Face>& faces, const std::vector<std::uint32_t>& piece) {
  double sum = 0.0;
  const glm::dvec3 origin(mesh.positions[faces[piece.front()].vertices[0]]);
  for (const std::uint32_t f : piece) {
    const auto& [a, b, c] = faces[f].vertices;
    const auto at = [&](std::uint32_t v) { return glm::dvec3(mesh.positions[v]) - origin; };
    sum += glm::dot(at(a), glm::cross(at(b), at(c)));
  }
  return sum / 6.0;
}

/// Pieces connected over sides of two faces, turned alike in each as most of its faces were.
class Orientation {
 public:
  Orientation(const Mesh& mesh, std::vector<Face>& faces, const std::vector<Side>& sides)
      : mesh_(&mesh), faces_(&faces), neighbours_(sides, faces.size()), turned_(faces.size(), 2) {}

  void run(RepairReport& report) {
    std::vector<std::vector<std::uint32_t>> pieces;
    for (std::uint32_t f = 0; f < faces_->size(); ++f) {
      if (turned_[f] == kUnseen) pieces.push_back(grow(f));
    }
    std::vector<Box> closed;
    for (const auto& piece : pieces) closed.push_back(is_closed(piece) ? box_of(piece) : Box{});
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      if (closed[p].empty() || is_within_another(p, closed)) continue;
      if (volume(*mesh_, *faces_, pieces[p]) < 0.0) turn(pieces[p]);
    }
    report.flipped = static_cast<std::size_t>(std::ranges::count(turned_, 1));
  }

 private:
  static constexpr std::uint8_t kUnseen = 2;

  /// The piece of a face; all of it then winds as the face does or, if most did not, the other way.
  std::vector<std::uint32_t> grow(std::uint32_t seed) {
    std::vector<std::uint32_t> piece{seed};
    turned_[seed] = 0;
    std::size_t turns = 0;
    for (std::size_t next = 0; next < piece.size(); ++next) {
      const std::uint32_t f = piece[next];
      for (std::uint32_t side = 0; side < 3; ++side) {
        const std::uint32_t other = neighbours_.across(f, original_side(f, side));
        if (other == Neighbours::kNone || turned_[other] != kUnseen) continue;
        const bool alike = wound_alike((*faces_)[f], side, (*faces_)[other]);
        turned_[other] = alike ? 0 : 1;
        if (!alike) (*faces_)[other].turn(), ++turns;
        piece.push_back(other);
      }
    }
    if (2 * turns > piece.size()) turn(piece);
    return piece;
  }
  /// Turning a face exchanges its corners 1 and 2: side 0 and side 2 have changed places.
  [[nodiscard]] std::uint32_t original_side(std::uint32_t face, std::uint32_t side) const {
    return turned_[face] == 1 && side != 1 ? 2 - side : side;
  }
  void turn(const std::vector<std::uint32_t>& piece) {
    for (const std::uint32_t f : piece) {
      (*faces_)[f].turn();
      turned_[f] = turned_[f] == 1 ? 0 : 1;
    }
  }
  [[nodiscard]] bool is_closed(const std::vector<std::uint32_t>& piece) const {
    return std::ranges::all_of(piece, [&](std::uint32_t f) {
      for (std::uint32_t side = 0; side < 3; ++side) {
        const std::uint32_t other = neighbours_.across(f, original_side(f, side));
        if (other == Neighbours::kNone || !wound_alike((*faces_)[f], side, (*faces_)[other])) return false;
      }
      return true;
    });
  }
  [[nodiscard]] Box box_of(const std::vector<std::uint32_t>& piece) const {
    Box box;
    for (const std::uint32_t f : piece) {
      for (const std::uint32_t v : (*faces_)[f].vertices) box.extend(mesh_->positions[v]);
    }
    return box;
  }
  /// Something hollow in something else is rightly turned inwards.
  static bool is_within_another(std::size_t piece, const std::vector<Box>& boxes) {
    const Box& box = boxes[piece];
    for (std::size_t p = 0; p < boxes.size(); ++p) {
      if (p == piece || boxes[p].empty()) continue;
      if (glm::all(glm::lessThanEqual(boxes[p].lo, box.lo)) && glm::all(glm::lessThanEqual(box.hi, boxes[p].hi))) {
        return true;
      }
    }
    return false;
  }

  const Mesh* mesh_;
  std::vector<Face>* faces_;
  Neighbours neighbours_;
  std::vector<std::uint8_t> turned_;  ///< [faces] 0, 1 or kUnseen
};

/// Corners become one position where their faces meet over sides that are theirs alone: a position for each fan.
WeldedMesh fans_of(const Mesh& mesh, const std::vector<Face>& faces, std::size_t places, RepairReport& report) {
  const std::vector<Side> sides = sorted_sides(faces);
  DisjointSets corners(3 * faces.size());
  DisjointSets pieces(faces.size());
  for_edges(sides, [&](std::size_t first, std::size_t last) {
    const Side& a = sides[first];
    const std::size_t count = last - first;
    const bool joined = count == 2 && a.upward != sides[first + 1].upward;
    if (!joined) {
      report.open_edges += count;
      report.split_edges += count > 2 ? 1 : 0;
      report.torn_edges += count == 2 ? 1 : 0;
      return;
    }
    const Side& b = sides[first + 1];
    corners.join(3 * a.face + a.side, 3 * b.face + (b.side + 1U) % 3U);
    corners.join(3 * a.face + (a.side + 1U) % 3U, 3 * b.face + b.side);
    pieces.join(a.face, b.face);
  });
  WeldedMesh surface;
  std::vector<std::uint32_t> position(3 * faces.size());
  std::vector<bool> used(places, false);
  std::size_t used_places = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    Triangle triangle{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = 3 * f + k;
      const std::uint32_t root = corners.find(corner);
      if (root == corner) {
        position[corner] = static_cast<std::uint32_t>(surface.positions.size());
        surface.positions.push_back(mesh.positions[faces[f].vertices[k]]);
        used_places += used[faces[f].places[k]] ? 0 : 1;
        used[faces[f].places[k]] = true;
      }
      triangle[k] = position[root];
    }
    surface.triangles.push_back(triangle);
    surface.corners.push_back(faces[f].vertices);
    report.components += pieces.find(f) == f ? 1 : 0;
  }
  report.split_positions = surface.positions.size() - used_places;
  return surface;
}

}  // namespace

Repaired repair(const Mesh& mesh) {
  Repaired result;
  const std::vector<std::uint32_t> place = places_of(mesh.positions);
  const std::size_t places = place.empty() ? 0 : std::size_t{*std::ranges::max_element(place)} + 1;
  result.report.welded = mesh.positions.size() - places;
  std::vector<Face> faces = usable_faces(mesh, place, result.report);
  Orientation(mesh, faces, sorted_sides(faces)).run(result.report);
  result.surface = fans_of(mesh, faces, places, result.report);
  return result;
}

Mesh with_surface(const Mesh& mesh, const WeldedMesh& surface) {
  Mesh result;
  std::vector<std::optional<std::uint32_t>> index(mesh.positions.size());
  for (const Triangle& corners : surface.corners) {
    for (const std::uint32_t v : corners) index[v] = 0;
  }
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (!index[v]) continue;
    index[v] = static_cast<std::uint32_t>(result.positions.size());
    result.append_vertex(mesh, v);
  }
  for (const Triangle& corners : surface.corners) {
    result.triangles.push_back({*index[corners[0]], *index[corners[1]], *index[corners[2]]});
  }
  return result;
}

}  // namespace luminist
