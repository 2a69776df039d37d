#pragma once
// raster/shader_library.h -- a style, the light types and the host's own GLSL, put together into one compute program.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/files.h"
#include "gpu/device.h"
#include "gpu/program.h"
#include "rig/light_type.h"
#include "style/style.h"

namespace luminist {

/// Where the relight program finds its buffers; the shaders read the numbers as LUM_FRAME, LUM_POSITION...
namespace relight_binding {
inline constexpr GLuint kFrame = 0;  // uniform blocks; the parameter blocks follow
inline constexpr GLuint kAmbient = 1;
inline constexpr GLuint kStyle = 2;
inline constexpr GLuint kFirstLightType = 3;

inline constexpr GLuint kPosition = 0;  // storage blocks
inline constexpr GLuint kNormal = 1;
inline constexpr GLuint kAlbedo = 2;
inline constexpr GLuint kSpecular = 3;
inline constexpr GLuint kEmissive = 4;
inline constexpr GLuint kEntries = 5;
inline constexpr GLuint kVisibility = 6;
inline constexpr GLuint kCandidates = 7;
inline constexpr GLuint kLights = 8;
inline constexpr GLuint kColors = 9;
inline constexpr GLuint kLayer = 10;
inline constexpr GLuint kStrokes = 11;
inline constexpr GLuint kLinks = 12;
inline constexpr GLuint kMaterials = 13;
}  // namespace relight_binding

/// Marks "no ambient" of a candidate and "no shadows" of a light; LUM_NONE of the shaders.
inline constexpr std::uint32_t kNone = 0xFFFFFFFFU;

/// An array of parameter blocks in a uniform block: as many as fit into what the device allows. Uniform blocks, because
/// every sample of a work group reads the same one, which software GL does much faster than from storage blocks.
struct BlockArray {
  std::size_t stride = 16;   ///< bytes of one block, a multiple of 16
  std::size_t capacity = 0;  ///< blocks; the buffer must have stride * capacity bytes
  [[nodiscard]] std::size_t bytes() const { return stride * capacity; }
};

struct RelightLayout {
  BlockArray ambient;
  BlockArray style;
  std::vector<BlockArray> light_types;  ///< in the order of LightTypes::all()
};

/// The layout of the parameter blocks on a device with this largest uniform block.
RelightLayout relight_layout(std::int64_t max_uniform_block_bytes, const LightTypes& types, const Style& style);

/// The chunks of the relight program: structs generated from the schemas, shaders/lib, one file per light type, the
/// dispatch over them, the style's textures and its files, the kernel. Texture i of the style is unit i. errors
/// kMissing for a file that is not there.
Result<std::vector<SourceChunk>> relight_source(const RelightLayout& layout, const LightTypes& types,
                                                const Style& style, const AssetRoots& roots);

/// Compiles it. errors kStyle at the author's file and line; a mistake that only shows behind the end of the style's
/// file (a missing brace, no shade()) is reported at that file. cost up to a second.
Result<Program> compile_relight(Device& device, const RelightLayout& layout, const LightTypes& types,
                                const Style& style, const AssetRoots& roots);

}  // namespace luminist
