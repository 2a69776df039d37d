#pragma once
// scene/animation.h -- how the nodes of a scene move, and the scene at one moment.
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "base/math.h"

namespace luminist {

struct Scene;

/// A frame of reference that hangs from another one. World from node is the parent's times T R S.
struct Node {
  std::string name;
  int parent = -1;  ///< a node before this one; -1: the world
  Vec3 translation{0.0F};
  glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};  ///< unit; w first
  Vec3 scale{1.0F};
  std::optional<Mat4> matrix = std::nullopt;  ///< in place of the three, which then cannot move
};

/// One property of one node over time. Before the first and after the last time it stands still.
struct Track {
  enum class Property { kTranslation, kRotation, kScale };
  enum class Interpolation {
    kStep,
    kLinear,  ///< rotations along the shorter arc
    kCubic,   ///< Hermite splines; three values a time: tangent in, value, tangent out, tangents a second
  };
  int node = 0;
  Property property = Property::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<float> times;  ///< seconds, ascending, at least one
  std::vector<Vec4> values;  ///< rotations as x, y, z, w
};

/// The weights of a node's morph targets over time.
struct WeightTrack {
  int node = 0;
  Track::Interpolation interpolation = Track::Interpolation::kLinear;
  std::vector<float> times;   ///< seconds, ascending, at least one
  std::vector<float> values;  ///< [times x targets]; cubic ones [times x 3 x targets], as Track::values

  /// [targets]
  [[nodiscard]] std::vector<float> at(double seconds) const;
};

/// All that moves in a scene. Nothing does without tracks.
struct Animation {
  std::vector<Node> nodes;  ///< parents first
  std::vector<Track> tracks;
  std::vector<WeightTrack> weight_tracks = {};

  [[nodiscard]] bool empty() const { return tracks.empty() && weight_tracks.empty(); }
  [[nodiscard]] double seconds() const;  ///< the last time of all tracks
  /// World from node of every node. cost O(nodes + keys).
  [[nodiscard]] std::vector<Mat4> worlds_at(double seconds) const;
  /// The same where no track has a say.
  [[nodiscard]] std::vector<Mat4> worlds_at_rest() const;
};

/// What a thing hangs from.
struct Mount {
  int node = -1;  ///< of Scene::animation; -1: it does not move
  Mat4 node_from_thing{1.0F};
};

/// Parent from node.
Mat4 local_matrix(const Node& node);

/// A camera or light frame: the columns made unit and square, because such a thing cannot be scaled. One that already
/// is so is kept to the bit.
Mat4 without_scale(const Mat4& m);

/// Hangs the things of a scene, which name their nodes, from where these are at rest. What no track moves is taken off
/// its node; without tracks the nodes go too. Meshes that deform are as at rest. Call it once when all is in place.
/// cost O(nodes + things), O(vertices) of what deforms.
void hang(Scene& scene);

/// Moves the objects, cameras and lights of a scene to where they are at a time, and the vertices of skins and morph
/// targets; what hangs from no node stays. The
/// frame of the scene stays that at rest, because parameters are measured in it; clip planes that the file does not
/// give follow. cost O(vertices) for the bounds. source the glTF 2.0 specification, section 3.11 and appendix C.
void pose(Scene& scene, double seconds);

}  // namespace luminist
