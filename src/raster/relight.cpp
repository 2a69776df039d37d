#include "raster/relight.h"

#include <array>
#include <utility>

#include "base/check.h"
#include "raster/style_texture.h"

namespace luminist {
namespace {

constexpr std::size_t kGroup = 64;  // local size of relight.comp

/// Candidates of one invocation: software GL gains from fetching a surface once, hardware from many invocations.
std::size_t run_length(const DeviceInfo& device) {
  return device.software ? 8 : 1;
}

/// LumFrame of shaders/lib/host.glsl.
struct FrameBlock {
  Mat4 screen_from_world{1.0F};
  std::array<float, 4> eye{};
  float light_edge = 0.0F;
  float threshold = 0.0F;
  std::uint32_t samples = 0;
  std::uint32_t padded = 0;
  std::uint32_t candidates = 0;
  std::uint32_t run = 1;
  std::uint32_t indexed = 0;
  std::uint32_t layered = 0;
  float pattern_fade = 0.0F;
  std::uint32_t strokes = 0;
  std::uint32_t link_words = 0;
  std::uint32_t first = 0;
};
static_assert(sizeof(FrameBlock) == 128, "as std140 lays it out");

std::size_t padded(std::size_t samples) {
  return (samples + kGroup - 1) / kGroup * kGroup;
}

}  // namespace

Result<void> GrowingBuffer::reserve(Device& device, std::size_t bytes) {
  if (buffer_.name() != 0 && buffer_.bytes() >= bytes) return {};
  // Half as much again, so that a slowly growing batch does not allocate each time.
  LUM_TRY(buffer_, GlBuffer::create(device, use_, bytes + bytes / 2, label_));
  return {};
}

Result<Relight> Relight::create(Device& device, const LightTypes& types, const Style& style, const AssetRoots& roots) {
  Relight relight(device, types);
  relight.blurs_ = style.metric.blur > 0.0F;
  relight.layout_ = relight_layout(device.info().max_uniform_block_bytes, types, style);
  LUM_TRY(relight.program_, compile_relight(device, relight.layout_, types, style, roots));
  const auto uniform = [&](std::size_t bytes, const std::string& label) {
    return GlBuffer::create(device, BufferUse::kUniform, bytes, label);
  };
  LUM_TRY(relight.frame_, uniform(sizeof(FrameBlock), "relight frame"));
  LUM_TRY(relight.ambient_, uniform(relight.layout_.ambient.bytes(), "ambient blocks"));
  LUM_TRY(relight.style_, uniform(relight.layout_.style.bytes(), "style blocks"));
  for (std::size_t i = 0; i < types.all().size(); ++i) {
    LUM_TRY(GlBuffer blocks, uniform(relight.layout_.light_types[i].bytes(), types.all()[i].name + " light blocks"));
    relight.light_types_.push_back(std::move(blocks));
  }
  for (const StyleTexture& texture : style.textures) {
    LUM_TRY(GlTexture loaded, load_style_texture(device, texture));
    relight.textures_.push_back(std::move(loaded));
  }
  LUM_TRY(relight.nothing_, GlBuffer::create(device, BufferUse::kStorage, 16, "nothing"));
  return relight;
}

void Relight::write_frame(const RelightJob& job, std::size_t first, std::size_t padded) {
  const CandidateTable& table = *job.table;
  const Vec3 eye = job.surface->eye();
  FrameBlock frame;
  frame.screen_from_world = job.surface->screen_from_world();
  frame.eye = {eye.x, eye.y, eye.z, 1.0F / static_cast<float>(job.surface->height())};
  frame.light_edge = job.softness.light_edge;
  frame.threshold = job.softness.threshold;
  frame.pattern_fade = job.from_afar && blurs_ ? 1.0F : 0.0F;
  frame.samples = static_cast<std::uint32_t>(job.samples);
  frame.first = static_cast<std::uint32_t>(first);
  frame.padded = static_cast<std::uint32_t>(padded);
  frame.candidates = static_cast<std::uint32_t>(table.size());
  frame.run = static_cast<std::uint32_t>(run_length(device_->info()));
  frame.indexed = job.entries != nullptr ? 1 : 0;
  frame.strokes = job.surface->stroke().name() != 0 ? 1 : 0;
  frame.link_words = static_cast<std::uint32_t>(table.links().row_words());
  frame.layered = job.layer != nullptr ? 1 : 0;
  frame_.write(0, std::span<const FrameBlock>(&frame, 1));
}

Result<void> Relight::upload(const RelightJob& job) {
  const CandidateTable& table = *job.table;
  write_frame(job, 0, padded(job.samples));
  const auto write = [](GlBuffer& buffer, std::span<const std::byte> bytes) {
    if (!bytes.empty()) buffer.write(0, bytes);
  };
  write(ambient_, table.ambient());
  write(style_, table.style());
  for (std::size_t i = 0; i < light_types_.size(); ++i) write(light_types_[i], table.light_type(i));
  LUM_TRY_VOID(links_.assign(*device_, std::span<const std::uint32_t>(table.links().words())));
  LUM_TRY_VOID(materials_.assign(*device_, std::span<const MaterialTurn>(table.materials())));
  LUM_TRY_VOID(candidates_.assign(*device_, std::span<const CandidateTable::Row>(table.candidates())));
  return lights_.assign(*device_, std::span<const CandidateTable::Row>(table.lights()));
}

/// So many samples at a time that whoever waits for something else waits some ten milliseconds on a slow machine.
Result<void> Relight::run_in_parts(const RelightJob& job) {
  constexpr std::size_t kPart = 1U << 17;  // a multiple of kGroup
  for (std::size_t first = 0; first < job.samples; first += kPart) {
    if (first > 0 && !(*job.go_on)()) {
      return Error{ErrorKind::kCancelled, "the picture was cancelled", "", "", ""};
    }
    const std::size_t part = padded(std::min(kPart, job.samples - first));
    write_frame(job, first, part);
    program_.dispatch(*device_, part, kGroup);
  }
  return {};
}

Result<void> Relight::run(const RelightJob& job) {
  namespace binding = relight_binding;
  LUM_CHECK(job.colors->bytes() >= job.table->size() * job.samples * sizeof(Vec4), "the caller makes room");
  if (job.samples == 0 || job.table->size() == 0) return {};
  LUM_TRY_VOID(upload(job));
  frame_.bind_uniform(binding::kFrame);
  ambient_.bind_uniform(binding::kAmbient);
  style_.bind_uniform(binding::kStyle);
  for (std::size_t i = 0; i < light_types_.size(); ++i) {
    light_types_[i].bind_uniform(binding::kFirstLightType + static_cast<GLuint>(i));
  }
  job.surface->position().bind_storage(binding::kPosition);
  job.surface->normal().bind_storage(binding::kNormal);
  job.surface->albedo().bind_storage(binding::kAlbedo);
  job.surface->specular().bind_storage(binding::kSpecular);
  job.surface->emissive().bind_storage(binding::kEmissive);
  (job.entries != nullptr ? *job.entries : nothing_).bind_storage(binding::kEntries);
  (job.visibility != nullptr ? *job.visibility : nothing_).bind_storage(binding::kVisibility);
  candidates_.buffer().bind_storage(binding::kCandidates);
  lights_.buffer().bind_storage(binding::kLights);
  (job.table->links().words().empty() ? nothing_ : links_.buffer()).bind_storage(binding::kLinks);
  (job.table->materials().empty() ? nothing_ : materials_.buffer()).bind_storage(binding::kMaterials);
  job.colors->bind_storage(binding::kColors);
  (job.surface->stroke().name() != 0 ? job.surface->stroke() : nothing_).bind_storage(binding::kStrokes);
  for (std::size_t i = 0; i < textures_.size(); ++i) textures_[i].bind(static_cast<GLuint>(i));
  (job.layer != nullptr ? *job.layer : nothing_).bind_storage(binding::kLayer);
  program_.use();
  if (job.go_on != nullptr && job.table->size() == 1) return run_in_parts(job);
  const std::size_t run = run_length(device_->info());
  program_.dispatch(*device_, padded(job.samples) * ((job.table->size() + run - 1) / run), kGroup);
  return {};
}

}  // namespace luminist
