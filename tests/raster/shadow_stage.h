#pragma once
// tests/raster/shadow_stage.h -- a scene, a camera and the shadow maps of lights in it.
#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "gpu/debug_device.h"
#include "raster/mesh_scenes.h"
#include "raster/shadow_maps.h"

namespace luminist {

inline ShadowLight spot(const Vec3& position, const Vec3& at, float extent = 0.5F, float softness = 0.008F,
                        int size = 512) {
  return {ShadowKind::kSpot, position, glm::normalize(at - position), extent, softness, size};
}

inline ShadowLight cube(const Vec3& position, float softness = 0.008F) {
  return {ShadowKind::kCube, position, Vec3(0, 0, -1), 1.0F + 4.0F * softness, softness, 1024};
}

/// A scene on the device with its deep framebuffer and its maps.
struct Stage {
  Stage(Device& device, const Scene& scene, const Camera& camera, int width, int height, bool strokes = false)
      : meshes(MeshBuffers::create(device, scene, strokes).value()),
        deep(DeepFramebuffer::create(device, AssetRoots::standard(), meshes, scene, camera, width, height).value()),
        maps(ShadowMaps::create(device, AssetRoots::standard(), meshes).value()) {}

  /// Visibility of every pixel centre, light by light.
  std::vector<std::vector<float>> visibility(const std::vector<ShadowLight>& lights) {
    const auto done = maps.update(deep, lights);
    EXPECT_TRUE(done) << done.error().message();
    std::vector<std::vector<float>> rows(lights.size(), std::vector<float>(deep.pixel_count()));
    for (std::size_t i = 0; i < lights.size(); ++i) {
      maps.visibility().read(i * deep.sample_count() * sizeof(float), std::span(rows[i]));
    }
    return rows;
  }
  std::vector<float> visibility(const ShadowLight& light) { return visibility(std::vector{light})[0]; }

  MeshBuffers meshes;
  DeepFramebuffer deep;
  ShadowMaps maps;
};

using ShadowMapsTest = DebugDeviceTest;

}  // namespace luminist
