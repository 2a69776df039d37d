#pragma once
// raster/relight.h -- runs shade() over samples: one candidate for a picture, many for a solver.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/files.h"
#include "gpu/device.h"
#include "gpu/gl_buffer.h"
#include "gpu/gl_texture.h"
#include "gpu/program.h"
#include "raster/candidate_table.h"
#include "raster/deep_framebuffer.h"
#include "raster/shader_library.h"
#include "render/renderer.h"

namespace luminist {

/// What one dispatch works on. Buffers outlive the call.
struct RelightJob {
  const DeepFramebuffer* surface = nullptr;
  const CandidateTable* table = nullptr;
  std::size_t samples = 0;               ///< per candidate
  const GlBuffer* entries = nullptr;     ///< [samples] uint, which sample of the surface; null: sample i is entry i
  const GlBuffer* visibility = nullptr;  ///< float [column * samples + sample]; null: no light has a column
  const GlBuffer* colors = nullptr;      ///< out vec4 [candidate * samples + sample]
  const GlBuffer* layer = nullptr;       ///< vec4 [sample], added to every candidate; null: nothing
  Softness softness;
  bool from_afar = false;  ///< where the style's metric blurs, dots and strokes give way to their mean
  /// Asked between the parts of a picture (one candidate); false ends it. Null: it is made in one go.
  const std::function<bool()>* go_on = nullptr;
};

/// A buffer that grows when more is written than it holds, and is kept otherwise.
class GrowingBuffer {
 public:
  GrowingBuffer() = default;
  explicit GrowingBuffer(BufferUse use, std::string label) : use_(use), label_(std::move(label)) {}
  /// At least `bytes` long from now on; what was in it is lost if it grew. errors kLimit.
  Result<void> reserve(Device& device, std::size_t bytes);
  [[nodiscard]] GlBuffer& buffer() { return buffer_; }
  [[nodiscard]] const GlBuffer& buffer() const { return buffer_; }

  template <class T>
  Result<void> assign(Device& device, std::span<const T> values) {
    LUM_TRY_VOID(reserve(device, values.size_bytes()));
    if (!values.empty()) buffer_.write(0, values);
    return {};
  }

 private:
  BufferUse use_ = BufferUse::kStorage;
  std::string label_;
  GlBuffer buffer_;
};

class Relight {
 public:
  /// device and types outlive it. errors of compile_relight() and
  /// load_style_texture(), kLimit.
  static Result<Relight> create(Device& device, const LightTypes& types, const Style& style, const AssetRoots& roots);

  /// object_names as SurfaceBuffer has them.
  [[nodiscard]] CandidateTable make_table(const std::vector<std::string>& object_names) const {
    return CandidateTable(layout_, *types_, object_names);
  }

  /// Writes job.colors. errors kLimit if memory runs out, kCancelled by job.go_on. cost one dispatch.
  Result<void> run(const RelightJob& job);

 private:
  Relight(Device& device, const LightTypes& types) : device_(&device), types_(&types) {}
  Result<void> upload(const RelightJob& job);
  Result<void> run_in_parts(const RelightJob& job);
  void write_frame(const RelightJob& job, std::size_t first, std::size_t padded);

  Device* device_;
  const LightTypes* types_;
  RelightLayout layout_;
  bool blurs_ = false;  ///< the style's metric
  Program program_;
  GlBuffer frame_;
  GlBuffer ambient_;
  GlBuffer style_;
  std::vector<GlBuffer> light_types_;
  std::vector<GlTexture> textures_;  ///< of the style
  GrowingBuffer candidates_{BufferUse::kStorage, "relight candidates"};
  GrowingBuffer lights_{BufferUse::kStorage, "relight lights"};
  GrowingBuffer materials_{BufferUse::kStorage, "turned materials"};
  GrowingBuffer links_{BufferUse::kStorage, "light links"};
  GlBuffer nothing_;  ///< bound where a job has no entries or visibility
};

}  // namespace luminist
