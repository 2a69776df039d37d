#include "raster/raster_impl.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/check.h"
#include "render/metric.h"
#include "rig/light_links.h"

namespace luminist {
namespace {

constexpr double kMaxBadShare = 0.01;  // of a picture's pixels; more is the style's fault

}  // namespace

Result<void> RasterRenderer::Impl::run(const ParamState& state, const Layer& layer, bool shadows, const GlBuffer* below,
                                       const GlBuffer& colors) {
  // Rows of the visibility buffer belong to the lights that are lit, in rig order.
  const std::vector<int> lit = lit_lights({&state, Candidate::kAllLights});
  const auto row_of = [&](const LightRig&, int light) {
    return shadows ? static_cast<std::uint32_t>(std::ranges::lower_bound(lit, light) - lit.begin()) : kNone;
  };
  table_->clear();
  if (!table_->add(state, layer.lights, layer.whole, row_of)) {
    return Error{ErrorKind::kLimit, "the rig has more lights of one type than this device takes at once", "", "",
                 "remove lights"};
  }
  RelightJob job;
  job.surface = &*deep_;
  job.table = &*table_;
  job.samples = deep_->sample_count();
  job.visibility = shadows && !lit.empty() ? &maps_->visibility() : nullptr;
  job.layer = below;
  job.colors = &colors;
  job.go_on = go_on_ ? &go_on_ : nullptr;
  LUM_TRY_VOID(relight_->run(job));
  const double shades = static_cast<double>(deep_->pixel_count()) * static_cast<double>(layer.lights.size());
  work_.shades += shades;
  work_.shadow_queries += shadows ? shades : 0.0;
  return {};
}

Result<void> RasterRenderer::Impl::may_go_on() const {
  if (!go_on_ || go_on_()) return {};
  return Error{ErrorKind::kCancelled, "the work was cancelled", "", "", ""};
}

Result<void> RasterRenderer::Impl::update_shadows(const ParamState& state) {
  std::vector<ShadowLight> lit = shadow_lights(state.rig, *types_, meshes_.shadow_frame());
  for (std::size_t i = lit.size(); i-- > 0;) {
    if (state.rig.lights[i].muted) lit.erase(lit.begin() + static_cast<std::ptrdiff_t>(i));
  }
  LUM_TRY_VOID(maps_->update(*deep_, lit));
  return may_go_on();
}

Result<void> RasterRenderer::Impl::shade(const ParamState& state, const RenderOptions& options) {
  if (options.shadows) LUM_TRY_VOID(update_shadows(state));
  const Layer all{lit_lights({&state, Candidate::kAllLights}), true};
  return run(state, all, options.shadows, nullptr, colors_);
}

std::vector<std::byte> RasterRenderer::Impl::key_of(const ParamState& state, const Layer& layer) const {
  static_assert(sizeof(ShadowLight) == 10 * sizeof(float), "its bytes are its values, without gaps");
  std::vector<std::byte> key;
  const auto add = [&](std::span<const std::byte> bytes) { key.insert(key.end(), bytes.begin(), bytes.end()); };
  add(state.rig.ambient.bytes());
  add(state.style.bytes());
  add(std::as_bytes(std::span(std::string_view(material_bytes(state)))));
  add(std::as_bytes(std::span(std::string_view(link_signature(state.rig)))));
  const std::vector<ShadowLight> shadows = shadow_lights(state.rig, *types_, meshes_.shadow_frame());
  for (const int i : layer.lights) {
    const Light& light = state.rig.lights[static_cast<std::size_t>(i)];
    add(std::as_bytes(std::span(&i, 1)));
    add(std::as_bytes(std::span(light.type)));
    add(light.params.bytes());
    add(std::as_bytes(std::span(&shadows[static_cast<std::size_t>(i)], 1)));  // another light's, where they are shared
  }
  return key;
}

Result<void> RasterRenderer::Impl::keep_still(const ParamState& state, const Layer& still) {
  std::vector<std::byte> key = key_of(state, still);
  if (still_.name() != 0 && key == still_key_) return {};
  if (still_.name() == 0) {
    LUM_TRY(still_, GlBuffer::create(*device_, BufferUse::kStorage, colors_.bytes(), "lights that do not move"));
  }
  still_key_.clear();
  LUM_TRY_VOID(run(state, still, true, nullptr, still_));
  still_key_ = std::move(key);
  return {};
}

Result<void> RasterRenderer::Impl::colors_at(const ParamState& state, std::span<const int> without,
                                             std::span<const std::uint32_t> pixels, std::span<Vec3> out) {
  LUM_CHECK(pixels.size() == out.size(), "one colour per pixel");
  LUM_TRY_VOID(may_go_on());
  LUM_TRY_VOID(follow_lines(state.style));
  Layer layer;
  for (const int i : lit_lights({&state, Candidate::kAllLights})) {
    if (std::ranges::find(without, i) == without.end()) layer.lights.push_back(i);
  }
  std::vector<std::byte> key = key_of(state, layer);
  if (key != picture_key_) {
    LUM_TRY_VOID(update_shadows(state));
    LUM_TRY_VOID(keep_still(state, layer));
    LUM_TRY_VOID(resolve(still_));
    picture_key_ = std::move(key);
  }
  if (style_.metric.blur > 0.0F) {
    LUM_TRY(const Image picture, read_picture());
    const Image compared = as_compared(picture, style_.metric);
    for (std::size_t i = 0; i < pixels.size(); ++i) out[i] = compared.rgb(pixels[i]);
    return {};
  }
  std::vector<Vec4> colors(deep_->pixel_count());
  picture_.read(0, std::span<Vec4>(colors));
  for (std::size_t i = 0; i < pixels.size(); ++i) out[i] = Vec3(colors[pixels[i]]);
  return {};
}

Result<void> RasterRenderer::Impl::shade_moving(const ParamState& state, std::span<const int> moving) {
  Layer still;
  Layer turned{{}, false};
  for (const int i : lit_lights({&state, Candidate::kAllLights})) {
    (std::ranges::find(moving, i) == moving.end() ? still : turned).lights.push_back(i);
  }
  if (still.lights.empty()) return shade(state, {});
  LUM_TRY_VOID(update_shadows(state));
  LUM_TRY_VOID(keep_still(state, still));
  return run(state, turned, true, &still_, colors_);
}

Result<void> RasterRenderer::Impl::resolve(const GlBuffer& colors) {
  picture_key_.clear();
  bad_.fill(0, sizeof(std::uint32_t), 0.0F);
  colors.bind_storage(0);
  deep_->edge_of_pixel().bind_storage(1);
  picture_.bind_storage(2);
  bad_.bind_storage(3);
  resolve_program_.use();
  resolve_program_.dispatch(*device_, deep_->pixel_count());
  std::uint32_t bad = 0;
  bad_.read(0, std::span<std::uint32_t>(&bad, 1));
  if (bad <= kMaxBadShare * static_cast<double>(deep_->pixel_count())) return {};
  return Error{ErrorKind::kStyle,
               fmt::format("the style '{}' gives values that are not finite in {} of {} pixels", style_.name, bad,
                           deep_->pixel_count()),
               style_.ink_path.empty() ? style_.glsl_path : fmt::format("{} or {}", style_.glsl_path, style_.ink_path),
               "", "guard divisions, square roots and powers; see shaders/lib/helpers.glsl"};
}

Result<void> RasterRenderer::Impl::draw(const ParamState& state, const RenderOptions& options) {
  LUM_TRY_VOID(may_go_on());
  LUM_TRY_VOID(follow_lines(state.style));
  if (options.moving && options.shadows && style_.combination(state.style) == LightCombination::kSum) {
    LUM_TRY_VOID(shade_moving(state, *options.moving));
  } else {
    LUM_TRY_VOID(shade(state, options));
  }
  return finish(state, options.shadows);
}

Result<void> RasterRenderer::Impl::finish(const ParamState& state, bool shadows) {
  work_.pictures += 1.0;
  LUM_TRY_VOID(resolve(colors_));
  if (shadows) picture_key_ = key_of(state, {lit_lights({&state, Candidate::kAllLights}), true});
  return device_->check_errors("render the picture");
}

Result<Image> RasterRenderer::Impl::read_picture() const {
  std::vector<Vec4> pixels(deep_->pixel_count());
  picture_.read(0, std::span<Vec4>(pixels));
  Image image(deep_->width(), deep_->height(), 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) image.set_rgb(i, Vec3(pixels[i]));
  return image;
}

Result<double> RasterRenderer::Impl::error(const ParamState& state, const Target& target,
                                           std::optional<std::span<const int>> moving) {
  LUM_TRY_VOID(draw(state, {.moving = moving}));
  if (style_.metric.blur <= 0.0F) return metric_->error(picture_, target);
  LUM_TRY(const Image picture, read_picture());
  return picture_error(picture, target, style_.metric);
}

Result<void> RasterRenderer::Impl::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                            const Softness& softness, std::span<Vec3> out) {
  LUM_TRY_VOID(may_go_on());
  const double shades = batch_->shades();
  const double queries = batch_->queries();
  if (!candidates.empty()) LUM_TRY_VOID(follow_lines(candidates.front().state->style));
  LUM_TRY_VOID(batch_->evaluate(candidates, samples, softness, out));
  work_.shades += batch_->shades() - shades;
  work_.shadow_queries += batch_->queries() - queries;
  return device_->check_errors("evaluate samples");
}

RasterRenderer::RasterRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RasterRenderer::~RasterRenderer() = default;

Result<std::unique_ptr<RasterRenderer>> RasterRenderer::create(Device& device, const Scene& scene, const Camera& camera,
                                                               const LightTypes& types, const Style& style,
                                                               const AssetRoots& roots, int width, int height) {
  if (width <= 0 || height <= 0) {
    return Error{ErrorKind::kUsage, fmt::format("a picture of {} x {} pixels is empty", width, height), "", "size", ""};
  }
  LUM_TRY(MeshBuffers meshes, MeshBuffers::create(device, scene, style.strokes));
  auto impl = std::make_unique<Impl>(device, types, style, scene.frame(), std::move(meshes));
  LUM_TRY_VOID(impl->prepare(scene, camera, roots, width, height));
  return std::unique_ptr<RasterRenderer>(new RasterRenderer(std::move(impl)));
}

Result<void> RasterRenderer::look_from(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width,
                                       int height) {
  return impl_->look_from(scene, camera, roots, width, height);
}

Result<void> RasterRenderer::change_style(const Style& style, const AssetRoots& roots) {
  return impl_->change_style(style, roots);
}

void RasterRenderer::ask(std::function<bool()> go_on) {
  impl_->ask(std::move(go_on));
}

// clang-format off
const SurfaceBuffer& RasterRenderer::surface() const { return impl_->surface(); }
SceneFrame RasterRenderer::frame() const { return impl_->frame(); }
const Style& RasterRenderer::style() const { return impl_->style(); }
const WorkCount& RasterRenderer::work() const { return impl_->work(); }
// clang-format on

Result<Image> RasterRenderer::render(const ParamState& state, const RenderOptions& options) {
  LUM_TRY_VOID(impl_->draw(state, options));
  return impl_->read_picture();
}

Result<double> RasterRenderer::error(const ParamState& state, const Target& target) {
  return impl_->error(state, target, std::nullopt);
}

Result<double> RasterRenderer::error(const ParamState& state, const Target& target, std::span<const int> moving) {
  return impl_->error(state, target, moving);
}

Result<void> RasterRenderer::colors_at(const ParamState& state, std::span<const int> without,
                                       std::span<const std::uint32_t> pixels, std::span<Vec3> out) {
  return impl_->colors_at(state, without, pixels, out);
}

Result<void> RasterRenderer::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                      const Softness& softness, std::span<Vec3> out) {
  return impl_->evaluate(candidates, samples, softness, out);
}

}  // namespace luminist
