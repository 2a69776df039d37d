#include "trace/path_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/check.h"
#include "render/metric.h"
#include "trace/denoise.h"
#include "trace/kept_fields.h"

namespace luminist {
namespace {

/// The style's parameters that the path tracer reads, by role.
struct PathSettings {
  PathOptions options;
  int samples = 64;
  int kept = 8;
  bool denoise = false;
  float most_later = 0.0F;  ///< as in PathJob
};

PathSettings settings_of(const ParamBlock& style) {
  const auto number = [&](const char* role, double fallback, double least, double most) {
    const auto param = style.schema().by_role(role);
    const double value = param ? style.get(*param) : fallback;
    return std::isfinite(value) ? std::clamp(value, least, most) : fallback;
  };
  PathSettings settings;
  settings.samples = static_cast<int>(number("samples", settings.samples, 1, 1 << 20));
  settings.kept = static_cast<int>(number("kept", settings.kept, 1, 1024));
  settings.denoise = number("denoise", 0.0, 0.0, 1.0) != 0.0;
  settings.most_later = static_cast<float>(number("clamp", 0.0, 0.0, 1e6));
  settings.options.bounces = static_cast<int>(number("bounces", settings.options.bounces, 1, 64));
  settings.options.seed = static_cast<std::uint32_t>(number("seed", 1.0, 0.0, 1e9));
  settings.options.caustics = number("caustics", 0.0, 0.0, 1.0) != 0.0;
  settings.options.specular = static_cast<float>(number("highlights", 1.0, 0.0, 100.0));
  return settings;
}

Vec3 ambient_of(const ParamState& state) {
  const auto color = state.rig.ambient.schema().by_role("color");
  return color ? state.rig.ambient.vec3(*color) : Vec3(0.0F);
}

/// All that a picture depends on besides its materials, as bytes.
std::string job_key(const PathSettings& settings, std::span<const RigLight> lights, const Vec3& ambient) {
  std::string key = fmt::format("{} {} {} {} {} {} {}|", settings.samples, settings.denoise, settings.most_later,
                                settings.options.bounces, settings.options.specular, settings.options.caustics,
                                settings.options.seed);
  const auto add = [&](const Vec3& color) { key.append(reinterpret_cast<const char*>(&color), sizeof(color)); };
  add(ambient);
  for (const RigLight& light : lights) {
    key += picture_key(light);
    add(light.color);
  }
  return key;
}

/// FNV-1a: equal lists get equal numbers, whoever made them.
std::uint64_t list_hash(std::uint64_t hash, std::span<const std::uint32_t> list) {
  for (const std::uint32_t value : list) hash = (hash ^ value) * 0x100000001B3ULL;
  return hash;
}

/// Paths that a sample is asked for: all where no rays are saved on it.
int paths_for(const Softness& softness, int kept) {
  constexpr int kAll = 8;  // shadow rays a sample
  return std::clamp(kept * softness.shadow_rays / kAll, 1, kept);
}

}  // namespace

int samples_for(double share, int most) {
  if (!(share > 0.0)) return 0;
  return std::clamp(static_cast<int>(std::ceil(most * std::sqrt(std::min(share, 1.0)))), 1, most);
}

class PathRenderer::Impl {
 public:
  Impl(PathTracer tracer, Style style, std::size_t memory_bytes)
      : tracer_(std::move(tracer)),
        style_(std::move(style)),
        frame_(tracer_.surfaces().scene().frame()),
        surface_(tracer_.surface_buffer()),
        fields_(tracer_, memory_bytes) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Result<Image> render(const ParamState& state, bool shadows, const Image* importance);
  Result<double> error(const ParamState& state, const Target& target);
  Result<void> colors_at(const ParamState& state, std::span<const int> without, std::span<const std::uint32_t> pixels,
                         std::span<Vec3> out);
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out);

  void set_watch(PathWatch watch) { watch_ = std::move(watch); }
  [[nodiscard]] const SurfaceBuffer& surface() const { return surface_; }
  [[nodiscard]] const SceneFrame& frame() const { return frame_; }
  [[nodiscard]] const Style& style() const { return style_; }
  [[nodiscard]] const WorkCount& work() const { return work_; }

 private:
  [[nodiscard]] std::span<const std::string> object_names() const {
    return std::span(surface_.object_names).subspan(1);
  }
  /// From now on the materials are the state's. What is kept of others is dropped: a path is chosen by the materials it
  /// meets, and traced anew with the same random numbers it is an unbiased one of the new ones, and near the old one.
  void turn_materials(const ParamState& state);
  /// The lights that shine in a candidate.
  Result<std::vector<RigLight>> lights_of(const Candidate& candidate, const Softness& softness) const;
  /// The state's colours of a set's pixels, without some lights.
  Result<PixelField> colors_of(const ParamState& state, std::span<const int> without, const PixelSet& set);
  [[nodiscard]] PixelSet counted_pixels(const Target& target, int kept) const;
  /// id: of the list of pixels.
  [[nodiscard]] PixelSet with_paths(std::span<const std::uint32_t> pixels, std::uint64_t id, int paths) const;
  void tally(int kept);  ///< one full picture is a light along as many paths as are kept

  PathTracer tracer_;
  std::string materials_;  ///< material_bytes() of what the tracer has
  bool turned_ = false;    ///< some material is not as the scene has it
  Style style_;
  SceneFrame frame_;
  SurfaceBuffer surface_;
  KeptFields fields_;
  PathWatch watch_;
  struct Drawn {
    std::string key;
    Image picture;
  };
  std::optional<Drawn> last_;  ///< whoever paints, solves and reports asks for one picture several times
  WorkCount work_;
  double picture_queries_ = 0.0;
  double picture_shades_ = 0.0;
  double tallied_ = 0.0;
};

Result<std::vector<RigLight>> PathRenderer::Impl::lights_of(const Candidate& candidate,
                                                            const Softness& softness) const {
  const LightRig& rig = candidate.state->rig;
  std::vector<RigLight> lights;
  for (int i = 0; i < static_cast<int>(rig.lights.size()); ++i) {
    const bool wanted = candidate.light == Candidate::kAllLights || candidate.light == i;
    if (!wanted || rig.lights[static_cast<std::size_t>(i)].muted) continue;
    LUM_TRY(RigLight light, rig_light(rig, i, softness, frame_, object_names()));
    lights.push_back(light);
  }
  return lights;
}

void PathRenderer::Impl::turn_materials(const ParamState& state) {
  std::string key = material_bytes(state);
  if (key == materials_) return;
  std::vector<MaterialTurn> turns;
  for (const MaterialParams& material : state.materials) turns.push_back(turn_of(material.params));
  materials_ = std::move(key);
  const bool now = std::ranges::any_of(turns, [](const MaterialTurn& turn) { return !turn.nothing(); });
  const bool before = std::exchange(turned_, now);
  if (!before && !now) return;  // as the scene has them, however that is said
  tracer_.turn(std::move(turns));
  fields_.drop();
}

void PathRenderer::Impl::tally(int kept) {
  const double along = fields_.shades() + picture_shades_;
  work_.shades += (along - std::exchange(tallied_, along)) / kept;
  work_.shadow_queries = fields_.queries() + picture_queries_;
}

Result<Image> PathRenderer::Impl::render(const ParamState& state, bool shadows, const Image* importance) {
  const PathSettings settings = settings_of(state.style);
  turn_materials(state);
  LUM_TRY(std::vector<RigLight> lights, lights_of({&state, Candidate::kAllLights}, {}));
  for (RigLight& light : lights) light.shadows = shadows;
  const std::string key = job_key(settings, lights, ambient_of(state)) + materials_;
  if (importance == nullptr && last_ && last_->key == key) return last_->picture;
  std::vector<std::uint32_t> samples(surface_.pixels(), static_cast<std::uint32_t>(settings.samples));
  if (importance != nullptr) {
    LUM_CHECK(importance->pixels() == surface_.pixels(), "importance and picture are of one size");
    const float most = *std::ranges::max_element(importance->data);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double share = most > 0.0F ? static_cast<double>(importance->data[i] / most) : 0.0;
      samples[i] = static_cast<std::uint32_t>(samples_for(share, settings.samples));
    }
  }
  PathJob job{settings.options, lights, ambient_of(state), samples, settings.most_later};
  LUM_TRY(Image picture, trace_picture(tracer_, job, watch_, picture_queries_));
  double drawn = 0.0;
  for (const std::uint32_t count : samples) drawn += count;
  picture_shades_ += drawn * static_cast<double>(lights.size());
  work_.pictures += 1.0;
  tally(settings.kept);
  if (settings.denoise) picture = denoised(picture, turned_ ? tracer_.surface_buffer() : surface_);
  if (importance == nullptr) last_ = Drawn{key, picture};
  return picture;
}

PixelSet PathRenderer::Impl::with_paths(std::span<const std::uint32_t> pixels, std::uint64_t id, int paths) const {
  PixelSet set;
  const auto each = static_cast<std::uint32_t>(paths);
  set.id = list_hash(id, {&each, 1});
  for (const std::uint32_t pixel : pixels) set.pixels.push_back({pixel, each});
  return set;
}

PixelSet PathRenderer::Impl::counted_pixels(const Target& target, int kept) const {
  LUM_CHECK(target.importance.pixels() == surface_.pixels(), "a target has the size of the picture");
  const bool blurs = style_.metric.blur > 0.0F;  // then pixels count for their neighbours
  const float most = *std::ranges::max_element(target.importance.data);
  const int most_paths = fields_.picture_paths(kept);
  PixelSet set;
  set.id = 0xCBF29CE484222325ULL;
  for (std::size_t i = 0; i < surface_.pixels(); ++i) {
    const double share = most > 0.0F ? static_cast<double>(target.importance.data[i] / most) : 0.0;
    const int paths = samples_for(blurs ? 1.0 : share, most_paths);
    if (paths == 0) continue;
    const std::array<std::uint32_t, 2> asked{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(paths)};
    set.pixels.push_back({asked[0], asked[1]});
    set.id = list_hash(set.id, asked);
  }
  return set;
}

Result<PixelField> PathRenderer::Impl::colors_of(const ParamState& state, std::span<const int> without,
                                                 const PixelSet& set) {
  std::vector<RigLight> lights;
  for (int i = 0; i < static_cast<int>(state.rig.lights.size()); ++i) {
    if (std::ranges::find(without, i) != without.end()) continue;
    LUM_TRY(const std::vector<RigLight> one, lights_of({&state, i}, {}));
    lights.insert(lights.end(), one.begin(), one.end());
  }
  const auto base = fields_.base(set);
  const std::vector<SharedField> fields = fields_.of_lights(set, lights);
  const Vec3 ambient = ambient_of(state);
  PixelField colors(set.pixels.size());
  for (std::size_t i = 0; i < colors.size(); ++i) {
    colors[i] = base->emitted[i] + ambient * base->escaped[i];
    for (std::size_t light = 0; light < lights.size(); ++light) {
      colors[i] += lights[light].color * (*fields[light])[i];
    }
  }
  return colors;
}

Result<double> PathRenderer::Impl::error(const ParamState& state, const Target& target) {
  const PathSettings settings = settings_of(state.style);
  fields_.use(settings.options);
  turn_materials(state);
  const PixelSet set = counted_pixels(target, settings.kept);
  LUM_TRY(const PixelField colors, colors_of(state, {}, set));
  Image picture(surface_.width, surface_.height, 3);
  for (std::size_t i = 0; i < colors.size(); ++i) picture.set_rgb(set.pixels[i].pixel, colors[i]);
  work_.pictures += 1.0;
  tally(settings.kept);
  return picture_error(picture, target, style_.metric);
}

Result<void> PathRenderer::Impl::colors_at(const ParamState& state, std::span<const int> without,
                                           std::span<const std::uint32_t> pixels, std::span<Vec3> out) {
  LUM_CHECK(pixels.size() == out.size(), "one colour per pixel");
  const PathSettings settings = settings_of(state.style);
  fields_.use(settings.options);
  turn_materials(state);
  const std::uint64_t id = list_hash(0x9E3779B97F4A7C15ULL, pixels);
  LUM_TRY(const PixelField colors, colors_of(state, without, with_paths(pixels, id, settings.kept)));
  std::ranges::copy(colors, out.begin());
  tally(settings.kept);
  return {};
}

Result<void> PathRenderer::Impl::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                          const Softness& softness, std::span<Vec3> out) {
  const std::size_t count = samples.pixels.size();
  LUM_CHECK(out.size() == candidates.size() * count, "one colour per candidate and sample");
  // Only parameters of a style and of materials change paths: candidates of one choice of these stand together.
  std::size_t begin = 0;
  while (begin < candidates.size()) {
    const PathSettings settings = settings_of(candidates[begin].state->style);
    fields_.use(settings.options);
    turn_materials(*candidates[begin].state);
    const PixelSet set = with_paths(samples.pixels, samples.id, paths_for(softness, settings.kept));
    std::vector<RigLight> lights;
    std::vector<std::size_t> first;  // [candidates of this run + 1], of each one's lights
    std::size_t end = begin;
    for (; end < candidates.size(); ++end) {
      const PathSettings other = settings_of(candidates[end].state->style);
      if (!(other.options == settings.options) || other.kept != settings.kept) break;
      if (material_bytes(*candidates[end].state) != materials_) break;
      first.push_back(lights.size());
      LUM_TRY(const std::vector<RigLight> own, lights_of(candidates[end], softness));
      lights.insert(lights.end(), own.begin(), own.end());
    }
    first.push_back(lights.size());
    const std::vector<SharedField> fields = fields_.of_lights(set, lights);
    for (std::size_t k = begin; k < end; ++k) {
      const std::span<Vec3> colors = out.subspan(k * count, count);
      std::ranges::fill(colors, Vec3(0.0F));
      if (candidates[k].light < 0) {
        const auto base = fields_.base(set);
        const Vec3 ambient = ambient_of(*candidates[k].state);
        for (std::size_t i = 0; i < count; ++i) colors[i] = base->emitted[i] + ambient * base->escaped[i];
      }
      for (std::size_t light = first[k - begin]; light < first[k - begin + 1]; ++light) {
        for (std::size_t i = 0; i < count; ++i) colors[i] += lights[light].color * (*fields[light])[i];
      }
    }
    tally(settings.kept);
    begin = end;
  }
  return {};
}

PathRenderer::PathRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PathRenderer::~PathRenderer() = default;

Result<std::unique_ptr<PathRenderer>> PathRenderer::create(Scene scene, const Camera& camera, const Style& style,
                                                           int width, int height, std::size_t memory_bytes) {
  if (width <= 0 || height <= 0) {
    return Error{ErrorKind::kUsage, fmt::format("a picture of {} x {} pixels is empty", width, height), "", "size", ""};
  }
  LUM_TRY(PathTracer tracer, PathTracer::create(std::move(scene), camera, width, height));
  auto impl = std::make_unique<Impl>(std::move(tracer), style, memory_bytes);
  return std::unique_ptr<PathRenderer>(new PathRenderer(std::move(impl)));
}

// clang-format off
const SurfaceBuffer& PathRenderer::surface() const { return impl_->surface(); }
SceneFrame PathRenderer::frame() const { return impl_->frame(); }
const Style& PathRenderer::style() const { return impl_->style(); }
const WorkCount& PathRenderer::work() const { return impl_->work(); }
void PathRenderer::set_watch(PathWatch watch) { impl_->set_watch(std::move(watch)); }
// clang-format on

Result<Image> PathRenderer::render(const ParamState& state, const RenderOptions& options) {
  return impl_->render(state, options.shadows, nullptr);
}

Result<Image> PathRenderer::render_where(const ParamState& state, const Image& importance) {
  return impl_->render(state, true, &importance);
}

Result<double> PathRenderer::error(const ParamState& state, const Target& target) {
  return impl_->error(state, target);
}

Result<void> PathRenderer::colors_at(const ParamState& state, std::span<const int> without,
                                     std::span<const std::uint32_t> pixels, std::span<Vec3> out) {
  return impl_->colors_at(state, without, pixels, out);
}

Result<void> PathRenderer::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                    const Softness& softness, std::span<Vec3> out) {
  return impl_->evaluate(candidates, samples, softness, out);
}

}  // namespace luminist
