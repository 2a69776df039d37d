#pragma once
// make_scene/surface.h -- surfaces as functions of two parameters, and the triangles that draw them.
#include <functional>

#include "base/math.h"
#include "scene/mesh.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace luminist {

// Shapes are computed in double precision; meshes store floats.
using Point2 = glm::dvec2;
using Point3 = glm::dvec3;
using Point4 = glm::dvec4;

/// A point for (u, v) in [0,1]^2; its front faces cross(dS/du, dS/dv).
using Surface = std::function<Point3(double u, double v)>;

/// A grid of columns x rows quads, two triangles each; zero-area triangles at poles are left out. Texture coordinates
/// are (u, v). Normals are those of the surface itself, so they agree where u = 0 meets u = 1.
Mesh tessellate(const Surface& surface, int columns, int rows);

/// Unit normal of a surface by central differences; at a pole, that of a nearby point.
Point3 surface_normal(const Surface& surface, double u, double v);

/// Appends the triangles of another mesh; both have texture coordinates or neither has.
void append(Mesh& mesh, const Mesh& other);

/// Moves positions and normals; the transform has no mirror.
void transform(Mesh& mesh, const Mat4& matrix);

/// Texture coordinates times a factor per axis.
void scale_uvs(Mesh& mesh, const Vec2& factor);

/// translate * rotate about Y, then X, then Z (radians) * scale.
struct Placement {
  Vec3 position{0.0F};
  Vec3 angles{0.0F};  ///< about x, y, z
  Vec3 scale{1.0F};

  [[nodiscard]] Mat4 matrix() const;
};

}  // namespace luminist
