#pragma once
// raster/shadow_maps.h -- who is seen by each light: shadow maps, and their filtered lookup for every sample.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/files.h"
#include "gpu/device.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_framebuffer.h"
#include "gpu/gl_texture.h"
#include "gpu/program.h"
#include "raster/deep_framebuffer.h"
#include "raster/mesh_buffers.h"
#include "raster/shadow_light.h"

namespace luminist {

/// Comparisons per sample and light, each filtered over 2 x 2 texels; four times as many for very soft shadows.
inline constexpr int kShadowTaps = 16;

/// Depth maps of lights (one view of a spot or a sun, six of a point) and the visibility of samples in them. Equal
/// ShadowLights share one map. Depth is near / distance along the axis, reversed, so that it is equally exact at every
/// distance.
class ShadowMaps {
 public:
  /// The meshes outlive the maps. errors kMissing, kStyle if the shaders are damaged.
  static Result<ShadowMaps> create(Device& device, const AssetRoots& roots, const MeshBuffers& meshes);

  /// Makes visibility() [lights.size() x deep.sample_count()] right for these lights. A light that is equal to one of
  /// the last call keeps its map, and its visibility if the deep framebuffer and its place in the list are the same.
  /// errors kLimit if memory runs out or the buffer is larger than the device's storage blocks.
  /// cost per changed light one or six draws of the scene, and kShadowTaps comparisons per sample.
  Result<void> update(const DeepFramebuffer& deep, std::span<const ShadowLight> lights);

  /// float [light * deep.sample_count() + sample]: 1 lit, 0 in shadow; before the light's shadow density.
  [[nodiscard]] const GlBuffer& visibility() const { return visibility_; }

  /// What was really done since create(): maps drawn, and lookups (samples x lights).
  [[nodiscard]] std::uint64_t maps_drawn() const { return maps_drawn_; }
  [[nodiscard]] double lookups() const { return lookups_; }

 private:
  /// A depth map and the light it was drawn for.
  struct Map {
    ShadowLight light;
    GlTexture depth;  ///< an array of 1 or 6 layers
    float near_plane = 0.0F;
  };

  explicit ShadowMaps(Device& device, const MeshBuffers& meshes) : device_(&device), meshes_(&meshes) {}
  Result<Map> draw_map(const ShadowLight& light);
  Result<const Map*> map_of(const ShadowLight& light);
  /// Sizes visibility_ and slots_, keeping what is still right.
  Result<void> make_room(const DeepFramebuffer& deep, std::size_t lights);
  void look_up(const DeepFramebuffer& deep, const Map& map, std::size_t slot);

  Device* device_;
  const MeshBuffers* meshes_;
  Program draw_program_;
  Program lookup_program_;
  GlFramebuffer framebuffer_;
  std::vector<Map> maps_;
  GlBuffer visibility_;
  std::uint64_t deep_id_ = 0;
  std::vector<std::optional<ShadowLight>> slots_;  ///< the lights whose visibility the buffer holds
  std::uint64_t maps_drawn_ = 0;
  double lookups_ = 0.0;
};

}  // namespace luminist
