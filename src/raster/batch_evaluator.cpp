#include "raster/batch_evaluator.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace luminist {
namespace {

// Candidates x lights x samples of one dispatch. Its largest buffer has 16 bytes a value and may be made half as large
// again: 48 MiB, where every device takes a storage block of 128.
constexpr std::size_t kMaxValues = std::size_t{1} << 21;

Vec3 finite_or_black(const Vec4& color) {
  const Vec3 rgb(color);
  return is_finite(rgb) ? rgb : Vec3(0.0F);
}

}  // namespace

BatchEvaluator::BatchEvaluator(Device& device, Relight& relight, const DeepFramebuffer& surface,
                               const SurfaceBuffer& seen, const LightTypes& types, const RayScene& rays,
                               const SceneFrame& scene)
    : device_(&device),
      relight_(&relight),
      surface_(&surface),
      types_(&types),
      scene_(scene),
      visibility_(rays, seen),
      table_(relight.make_table(seen.object_names)) {}

Result<void> BatchEvaluator::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                      const Softness& softness, std::span<Vec3> out) {
  const std::size_t count = samples.pixels.size();
  LUM_CHECK(out.size() == candidates.size() * count, "one colour per candidate and sample");
  if (count == 0) return {};
  LUM_TRY_VOID(entry_buffer_.assign(*device_, std::span<const std::uint32_t>(samples.pixels)));
  std::size_t done = 0;
  while (done < candidates.size()) {
    LUM_TRY(const std::size_t filled, fill_table(candidates.subspan(done), samples, softness));
    LUM_TRY_VOID(shade(samples, softness, out.subspan(done * count, filled * count)));
    visibility_.trim();
    done += filled;
  }
  return {};
}

Result<std::size_t> BatchEvaluator::fill_table(std::span<const Candidate> candidates, const SampleSet& samples,
                                               const Softness& softness) {
  const std::size_t count = samples.pixels.size();
  const std::size_t lights = std::max<std::size_t>(1, candidates.front().state->rig.lights.size());
  const std::size_t most = std::max<std::size_t>(1, kMaxValues / (count * lights));
  candidates = candidates.first(std::min(candidates.size(), most));
  prepare_visibility(candidates, samples, softness);
  table_.clear();
  columns_.clear();
  const auto column_of = [&](const LightRig& rig, int light) { return column(rig, light, samples, softness); };
  std::size_t filled = 0;
  while (filled < candidates.size() && table_.add(candidates[filled], column_of)) ++filled;
  if (filled == 0) {
    return Error{ErrorKind::kLimit, "the rig has more lights of one type than this device takes at once", "", "",
                 "remove lights"};
  }
  shades_ += static_cast<double>(table_.lights().size() * count);
  return filled;
}

ShadowLight BatchEvaluator::caster(const LightRig& rig, int light) const {
  const Light* shared = rig.shadow_light.empty() ? nullptr : rig.find(rig.shadow_light);
  return shadow_light(shared != nullptr ? *shared : rig.lights[static_cast<std::size_t>(light)], *types_, scene_);
}

void BatchEvaluator::prepare_visibility(std::span<const Candidate> candidates, const SampleSet& samples,
                                        const Softness& softness) {
  casters_.clear();
  for (const Candidate& candidate : candidates) {
    const LightRig& rig = candidate.state->rig;
    for (const int light : lit_lights(candidate)) casters_.push_back(caster(rig, light));
  }
  std::erase_if(casters_, [](const ShadowLight& light) { return light.kind == ShadowKind::kNone; });
  visibility_.prepare(casters_, samples, softness);
}

std::uint32_t BatchEvaluator::column(const LightRig& rig, int light, const SampleSet& samples,
                                     const Softness& softness) {
  const ShadowLight shadow = caster(rig, light);
  if (shadow.kind == ShadowKind::kNone) return kNone;
  const float* values = visibility_.column(shadow, samples, softness).data();
  // A column's address names it: candidates that share a light's place share its column.
  const auto known = std::find(columns_.rbegin(), columns_.rend(), values);
  if (known != columns_.rend()) return static_cast<std::uint32_t>(columns_.rend() - known - 1);
  columns_.push_back(values);
  return static_cast<std::uint32_t>(columns_.size() - 1);
}

Result<void> BatchEvaluator::shade(const SampleSet& samples, const Softness& softness, std::span<Vec3> out) {
  const std::size_t count = samples.pixels.size();
  LUM_TRY_VOID(visibility_buffer_.reserve(*device_, columns_.size() * count * sizeof(float)));
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    visibility_buffer_.buffer().write(i * count * sizeof(float), std::span(columns_[i], count));
  }
  LUM_TRY_VOID(color_buffer_.reserve(*device_, out.size() * sizeof(Vec4)));
  RelightJob job;
  job.surface = surface_;
  job.table = &table_;
  job.samples = count;
  job.entries = &entry_buffer_.buffer();
  job.visibility = &visibility_buffer_.buffer();
  job.colors = &color_buffer_.buffer();
  job.softness = softness;
  job.from_afar = true;
  LUM_TRY_VOID(relight_->run(job));
  colors_.resize(out.size());
  color_buffer_.buffer().read(0, std::span<Vec4>(colors_));
  std::transform(colors_.begin(), colors_.end(), out.begin(), finite_or_black);
  return {};
}

}  // namespace luminist
