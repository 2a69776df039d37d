#include "scene/animation.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/framing.h"
#include "scene/scene.h"

namespace luminist {
namespace {

glm::quat as_rotation(const Vec4& v) {
  const glm::quat q(v.w, v.x, v.y, v.z);
  const float length = glm::length(q);
  return length > 0.0F ? q / length : glm::quat(1.0F, 0.0F, 0.0F, 0.0F);
}

Vec4 as_values(const glm::quat& q) {
  return {q.x, q.y, q.z, q.w};
}

/// Between two keys, t in [0,1] of `step` seconds.
Vec4 between(const Track& track, std::size_t key, float t, float step) {
  const bool cubic = track.interpolation == Track::Interpolation::kCubic;
  const std::size_t stride = cubic ? 3 : 1;
  const std::size_t at = key * stride + (cubic ? 1 : 0);
  const Vec4& from = track.values[at];
  const Vec4& to = track.values[at + stride];
  if (track.interpolation == Track::Interpolation::kStep) return from;
  if (cubic) {
    const float t2 = t * t;
    const float t3 = t2 * t;
    return (2.0F * t3 - 3.0F * t2 + 1.0F) * from + step * (t3 - 2.0F * t2 + t) * track.values[at + 1] +
           (3.0F * t2 - 2.0F * t3) * to + step * (t3 - t2) * track.values[at + stride - 1];
  }
  if (track.property != Track::Property::kRotation) return glm::mix(from, to, t);
  return as_values(glm::slerp(as_rotation(from), as_rotation(to), t));  // glm takes the shorter arc
}

Vec4 value_at(const Track& track, double seconds) {
  const bool cubic = track.interpolation == Track::Interpolation::kCubic;
  const auto value_of = [&](std::size_t key) { return track.values[cubic ? 3 * key + 1 : key]; };
  const auto time = static_cast<float>(seconds);
  const auto after = std::upper_bound(track.times.begin(), track.times.end(), time);
  if (after == track.times.begin()) return value_of(0);
  const auto key = static_cast<std::size_t>(after - track.times.begin()) - 1;
  if (after == track.times.end()) return value_of(key);
  const float step = track.times[key + 1] - track.times[key];
  return between(track, key, (time - track.times[key]) / step, step);
}

/// [nodes] of what has such a track; empty for the others.
std::vector<std::vector<float>> weights_at(const Animation& animation, double seconds) {
  std::vector<std::vector<float>> weights(animation.nodes.size());
  for (const WeightTrack& track : animation.weight_tracks) {
    weights[static_cast<std::size_t>(track.node)] = track.at(seconds);
  }
  return weights;
}

std::vector<Mat4> worlds_of(const std::vector<Node>& nodes) {
  std::vector<Mat4> worlds;
  worlds.reserve(nodes.size());
  for (const Node& node : nodes) {
    const Mat4 local = local_matrix(node);
    worlds.push_back(node.parent < 0 ? local : worlds[static_cast<std::size_t>(node.parent)] * local);
  }
  return worlds;
}

}  // namespace

Mat4 local_matrix(const Node& node) {
  if (node.matrix) return *node.matrix;
  Mat4 m = glm::mat4_cast(node.rotation);
  for (int i = 0; i < 3; ++i) m[i] *= node.scale[i];
  m[3] = Vec4(node.translation, 1.0F);
  return m;
}

std::vector<float> WeightTrack::at(double seconds) const {
  const bool cubic = interpolation == Track::Interpolation::kCubic;
  const std::size_t stride = cubic ? 3 : 1;
  const std::size_t targets = values.size() / (times.size() * stride);
  // part 0 and 2: tangents in and out of a cubic key
  const auto value = [&](std::size_t key, std::size_t part, std::size_t target) {
    return values[(key * stride + part) * targets + target];
  };
  const auto time = static_cast<float>(seconds);
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  const auto key = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - times.begin() - 1, 0));
  const bool still = after == times.begin() || after == times.end() || interpolation == Track::Interpolation::kStep;
  const float step = still ? 1.0F : times[key + 1] - times[key];
  const float t = still ? 0.0F : (time - times[key]) / step;
  const float t2 = t * t;
  const float t3 = t2 * t;
  const std::size_t middle = cubic ? 1 : 0;
  std::vector<float> weights;
  for (std::size_t k = 0; k < targets; ++k) {
    const float from = value(key, middle, k);
    if (still) {
      weights.push_back(from);
    } else if (cubic) {
      weights.push_back((2.0F * t3 - 3.0F * t2 + 1.0F) * from + step * (t3 - 2.0F * t2 + t) * value(key, 2, k) +
                        (3.0F * t2 - 2.0F * t3) * value(key + 1, 1, k) + step * (t3 - t2) * value(key + 1, 0, k));
    } else {
      weights.push_back((1.0F - t) * from + t * value(key + 1, 0, k));
    }
  }
  return weights;
}

double Animation::seconds() const {
  float last = 0.0F;
  for (const Track& track : tracks) last = std::max(last, track.times.back());
  for (const WeightTrack& track : weight_tracks) last = std::max(last, track.times.back());
  return last;
}

std::vector<Mat4> Animation::worlds_at(double seconds) const {
  std::vector<Node> moved = nodes;
  for (const Track& track : tracks) {
    Node& node = moved[static_cast<std::size_t>(track.node)];
    const Vec4 value = value_at(track, seconds);
    switch (track.property) {
      case Track::Property::kTranslation:
        node.translation = Vec3(value);
        break;
      case Track::Property::kRotation:
        node.rotation = as_rotation(value);
        break;
      case Track::Property::kScale:
        node.scale = Vec3(value);
        break;
    }
  }
  return worlds_of(moved);
}

std::vector<Mat4> Animation::worlds_at_rest() const {
  return worlds_of(nodes);
}

Mat4 without_scale(const Mat4& m) {
  constexpr float kRounding = 1e-5F;
  const Mat3 defect = glm::transpose(Mat3(m)) * Mat3(m) - Mat3(1.0F);
  float largest = 0.0F;
  for (int i = 0; i < 9; ++i) largest = std::max(largest, std::abs(defect[i / 3][i % 3]));
  if (largest < kRounding && glm::determinant(Mat3(m)) > 0.0F) return m;
  const Vec3 back = glm::normalize(Vec3(m[2]));
  const Vec3 right = glm::normalize(glm::cross(Vec3(m[1]), back));
  return {Vec4(right, 0.0F), Vec4(glm::cross(back, right), 0.0F), Vec4(back, 0.0F), m[3]};
}

void hang(Scene& scene) {
  Animation& animation = scene.animation;
  settle_deformers(scene);
  deform(scene, animation.worlds_at_rest(), {});
  if (animation.empty()) {
    animation.nodes.clear();
    scene.deformers.clear();
    for (Object& object : scene.objects) object.deformer = -1;
  }
  std::vector<char> moves(animation.nodes.size(), 0);
  for (const Track& track : animation.tracks) moves[static_cast<std::size_t>(track.node)] = 1;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const int parent = animation.nodes[i].parent;
    if (parent >= 0 && moves[static_cast<std::size_t>(parent)] != 0) moves[i] = 1;
  }
  const std::vector<Mat4> worlds = animation.worlds_at_rest();
  const auto hang_from = [&](Mount& mount, const Mat4& world_from_thing) {
    const auto node = static_cast<std::size_t>(mount.node);
    if (mount.node < 0 || node >= moves.size() || moves[node] == 0) {
      mount = {};
    } else {
      mount.node_from_thing = Mat4(glm::inverse(glm::dmat4(worlds[node])) * glm::dmat4(world_from_thing));
    }
  };
  for (Object& object : scene.objects) hang_from(object.mount, object.world_from_object);
  for (Camera& camera : scene.cameras) hang_from(camera.mount, camera.world_from_camera);
  for (PunctualLight& light : scene.lights) hang_from(light.mount, light.world_from_light());
}

void pose(Scene& scene, double seconds) {
  if (scene.animation.empty()) return;
  if (!scene.rest_frame) scene.rest_frame = scene.frame();
  const std::vector<Mat4> worlds = scene.animation.worlds_at(seconds);
  const auto world_of = [&](const Mount& mount) {
    return worlds[static_cast<std::size_t>(mount.node)] * mount.node_from_thing;
  };
  for (Object& object : scene.objects) {
    if (object.mount.node >= 0) object.world_from_object = world_of(object.mount);
  }
  if (!scene.deformers.empty()) deform(scene, worlds, weights_at(scene.animation, seconds));
  for (Camera& camera : scene.cameras) {
    if (camera.mount.node >= 0) camera.world_from_camera = without_scale(world_of(camera.mount));
    if (camera.fitted_near) camera.near_plane = 0.0F;
    if (camera.fitted_far) camera.far_plane = 0.0F;
  }
  for (PunctualLight& light : scene.lights) {
    if (light.mount.node < 0) continue;
    const Mat4 frame = without_scale(world_of(light.mount));
    light.position = Vec3(frame[3]);
    light.direction = -Vec3(frame[2]);
  }
  fit_clip_planes(scene);
}

}  // namespace luminist
