#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "make_scene/imp.h"

namespace luminist {
namespace {

constexpr int kKeys = 17;
constexpr float kSeconds = 2.0F;

/// Left wing and tail, in the world; sums of powers of two, so that what hangs from a joint is at rest to the bit.
const Vec3 kWingJoint{0.01953125F, 0.224609375F, -0.029296875F};
const Vec3 kTailJoint{0.0F, 0.109375F, -0.0390625F};

enum Joint { kBody, kWingRight, kWingLeft, kTail };

float phase(int key) {
  return static_cast<float>(key) / static_cast<float>(kKeys - 1);
}

/// A rotation about an axis, as keys.
Track turn(int node, const Vec3& axis, float (*angle_at)(float phase)) {
  Track track;
  track.node = node;
  track.property = Track::Property::kRotation;
  for (int key = 0; key < kKeys; ++key) {
    const float half = 0.5F * angle_at(phase(key));
    track.times.push_back(kSeconds * phase(key));
    track.values.emplace_back(std::sin(half) * axis, std::cos(half));
  }
  return track;
}

float wave(float turns) {
  return std::sin(2.0F * static_cast<float>(kPi) * turns);
}

/// Two hops, each a parabola with a rest between.
float height_at(float t) {
  const float in_hop = std::fmod(2.0F * t, 1.0F);
  const float flight = std::clamp((in_hop - 0.2F) / 0.6F, 0.0F, 1.0F);
  return 0.04F * 4.0F * flight * (1.0F - flight);
}

Track hops() {
  Track track;
  track.node = kBody;
  for (int key = 0; key < kKeys; ++key) {
    track.times.push_back(kSeconds * phase(key));
    track.values.emplace_back(0.0F, height_at(phase(key)), 0.0F, 0.0F);
  }
  return track;
}

Node joint(const char* name, int parent, const Vec3& at) {
  Node node;
  node.name = name;
  node.parent = parent;
  node.translation = at;
  return node;
}

/// What an object of the creature hangs from; -1: the ground, the plants, the rock.
int joint_of(const std::string& object) {
  static const std::array<std::pair<const char*, int>, 5> kParts{{{"wing_bones_right", kWingRight},
                                                                  {"wing_skin_right", kWingRight},
                                                                  {"wing_bones_left", kWingLeft},
                                                                  {"wing_skin_left", kWingLeft},
                                                                  {"tail", kTail}}};
  for (const auto& [name, node] : kParts) {
    if (object == name) return node;
  }
  for (const char* rooted : {"toadstool", "fern", "grass", "ground", "hollow"}) {
    if (object.rfind(rooted, 0) == 0) return -1;
  }
  return kBody;
}

}  // namespace

void animate_imp(Scene& scene) {
  const Vec3 right = kWingJoint * Vec3(-1.0F, 1.0F, 1.0F);
  scene.animation.nodes = {joint("imp", -1, Vec3(0.0F)), joint("wing_right", kBody, right),
                           joint("wing_left", kBody, kWingJoint), joint("tail", kBody, kTailJoint)};
  const Vec3 up(0.0F, 1.0F, 0.0F);
  const Vec3 ahead(0.0F, 0.0F, 1.0F);
  scene.animation.tracks = {
      hops(),
      turn(kBody, up, [](float t) { return 0.55F * wave(t); }),
      turn(kWingRight, ahead, [](float t) { return -0.45F * wave(2.0F * t); }),
      turn(kWingLeft, ahead, [](float t) { return 0.45F * wave(2.0F * t); }),
      turn(kTail, up, [](float t) { return 0.4F * wave(2.0F * t); }),
  };
  for (Object& object : scene.objects) object.mount.node = joint_of(object.name);
  hang(scene);
}

}  // namespace luminist
