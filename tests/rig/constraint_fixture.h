#pragma once
// tests/rig/constraint_fixture.h -- a rig to be constrained.
#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <span>
#include <vector>

#include "rig/light_rig.h"
#include "support/fixtures.h"

namespace luminist {

/// Four lights: key, fill and rim are cinematic, bulb is a point.
class ConstraintTest : public ::testing::Test {
 protected:
  ConstraintTest() {
    for (const char* name : {"key", "fill", "rim"})
      rig_.lights.push_back(*make_light(types_, "cinematic", name, frame_));
    rig_.lights.push_back(*make_light(types_, "point", "bulb", frame_));
  }
  static LightTypes load_types() {
    auto types = LightTypes::load(AssetRoots::standard());
    EXPECT_TRUE(types) << (types ? "" : types.error().message());
    return *types;
  }
  static int param(const Light& light, const char* role) { return *light.params.schema().by_role(role); }
  static Vec3 value(const Light& light, const char* role) { return light.params.vec3(param(light, role)); }
  static void put(Light& light, const char* role, const Vec3& value) {
    light.params.set_vec3(param(light, role), value);
  }
  Light& light(const char* name) { return *rig_.find(name); }
  /// Every position, direction, colour and other number at random.
  void shuffle(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> number(-3.0F, 3.0F);
    for (Light& each : rig_.lights) {
      for (int p = 0; p < each.params.schema().size(); ++p) {
        const ParamSpec& spec = each.params.schema()[p];
        for (int c = 0; c < spec.components(); ++c) each.params.set(p, c, static_cast<double>(number(random)));
        if (spec.type == ParamType::kDirection) each.params.set_vec3(p, glm::normalize(each.params.vec3(p)));
      }
    }
  }
  /// The bytes of all lights.
  std::vector<std::byte> bits() const {
    std::vector<std::byte> all;
    for (const Light& each : rig_.lights) {
      const std::span<const std::byte> bytes = each.params.bytes();
      all.insert(all.end(), bytes.begin(), bytes.end());
    }
    return all;
  }
  static int free_dofs(const Light& light) {
    int count = 0;
    for (int dof = 0; dof < light.params.schema().dofs(); ++dof) count += light.params.locked(dof) ? 0 : 1;
    return count;
  }

  SceneFrame frame_{Vec3(1.0F, 2.0F, 3.0F), 2.0F};
  LightTypes types_ = load_types();
  LightRig rig_ = empty_rig(types_, frame_);
};

}  // namespace luminist
