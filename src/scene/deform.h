#pragma once
// scene/deform.h -- meshes whose vertices move: morph targets, and skins that hang from joints.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/math.h"

namespace luminist {

struct Scene;

/// Where the vertices of a mesh go if the target's weight is 1, relative to the mesh. normals: empty or of that size.
struct MorphTarget {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
};

/// What moves the vertices of one object's mesh, which is no other object's. First the targets are added, each by its
/// weight; then, where there are joints, every vertex goes with up to four of them.
struct Deformer {
  std::vector<MorphTarget> targets;
  std::vector<float> weights;  ///< [targets] where no track has a say
  int node = -1;               ///< of Scene::animation, whose tracks turn the weights

  std::vector<int> joints;                                  ///< nodes of Scene::animation; none: no skin
  std::vector<Mat4> joint_from_mesh;                        ///< [joints] inverse bind matrices
  std::vector<std::array<std::uint16_t, 4>> vertex_joints;  ///< [vertices] places in `joints`
  std::vector<Vec4> vertex_weights;                         ///< [vertices] sum 1

  /// The mesh as the file has it, by which vertices that the loader split find theirs; of the loaded mesh after
  /// settle().
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Vec4> tangents;
};

/// Gives the deformers of loaded objects the vertices that their meshes have now: splits repeat a vertex, faults drop
/// some. What no vertex of the file matches stays where it is. cost O(vertices).
void settle_deformers(Scene& scene);

/// Writes the meshes of deformed objects. worlds: world from node; weights_of(node): those of a track, or empty.
/// A skinned object is placed by its joints alone, as glTF has it. Normals that a target does not move turn as the
/// faces around their vertex do. cost O(vertices x (targets + 4)).
void deform(Scene& scene, std::span<const Mat4> worlds, std::span<const std::vector<float>> weights_of);

/// The same deformer for a mesh that is reflected in x.
Deformer mirrored(const Deformer& deformer);

}  // namespace luminist
