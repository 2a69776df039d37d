#pragma once
// make_scene/glade.h -- where the creature stands: mossy ground in a rocky hollow, toadstools, grass. One unit is ten
// centimetres.
#include <cstdint>

#include "base/image.h"
#include "make_scene/surface.h"

namespace luminist {

/// Height of the ground at (x, z); flat where the creature stands.
double ground_height(double x, double z);
Mesh ground_mesh();
Image ground_painting(int size);
Image ground_relief(int size);

/// A curved wall of rock behind, from the left around to the right.
Mesh hollow_mesh();
Image rock_painting(int size);
Image rock_relief(int size);

/// A toadstool on the origin: stalk with ring, cap with warts. Two meshes.
Mesh toadstool_stalk(double height, double lean);
Mesh toadstool_cap(double height, double lean, double radius);
Image cap_painting(int width, int height);

/// Blades of grass around some spots; thin, two-sided.
Mesh grass_mesh(int blades, std::uint64_t seed);
/// Ferns that unroll in spirals, thin shadows.
Mesh fern_mesh(const Point3& foot, double height, double way);

/// A gnarled staff with a curled head, held at (1.18, 2, 0.83).
Mesh staff_mesh();

}  // namespace luminist
