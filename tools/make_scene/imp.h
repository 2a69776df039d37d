#pragma once
// make_scene/imp.h -- the creature: a small horned, winged imp that waves. One unit is ten centimetres; it stands on
// y = 0, 4.7 high with its horns, and looks along +Z.
#include <array>
#include <string>
#include <vector>

#include "base/image.h"
#include "make_scene/surface.h"
#include "scene/scene.h"

namespace luminist {

struct BodyPart {
  std::string name;
  Point3 joint;  ///< the mesh is relative to it
  Mesh mesh;
};

/// Head, torso, arms and legs: one smooth skin, cut where the parts meet. Texture coordinates index imp_skin().
std::vector<BodyPart> imp_body();

/// Colours by (back to belly, plain to spotted): no unwrapping needed.
Image imp_skin(int width, int height);

inline constexpr double kEyeRadius = 0.275;
/// Centre of an eye; side is -1 or 1.
Point3 eye_center(int side);
/// A sphere that looks along +Z, its pupil at v = 1.
Mesh eye_mesh();
Image eye_painting(int width, int height);

Mesh horn_mesh(int side);
Mesh tail_mesh();
/// Bones and skin of a wing.
Mesh wing_bones(int side);
Mesh wing_skin(int side);
Image wing_painting(int width, int height);
Image horn_painting(int width, int height);

/// Two seconds in which it hops and turns on its spot, beats its wings and wags its tail; at their beginning all is at
/// rest. The scene's objects are those of the creature, in the world at one tenth.
void animate_imp(Scene& scene);

}  // namespace luminist
