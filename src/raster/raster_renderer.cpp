#include "raster/raster_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"
#include "raster/batch_evaluator.h"
#include "raster/deep_framebuffer.h"
#include "raster/mesh_buffers.h"
#include "raster/metric_pass.h"
#include "raster/outline_buffers.h"
#include "raster/relight.h"
#include "raster/shadow_maps.h"
#include "rays/ray_scene.h"
#include "render/metric.h"
#include "rig/light_links.h"

namespace luminist {
namespace {

constexpr double kMaxBadShare = 0.01;  // of a picture's pixels; more is the style's fault

}  // namespace

class RasterRenderer::Impl {
 public:
  Impl(Device& device, const LightTypes& types, const Style& style, SceneFrame frame, MeshBuffers meshes)
      : device_(&device), types_(&types), style_(style), frame_(frame), meshes_(std::move(meshes)) {}

  Result<void> prepare(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width, int height);
  Result<void> change_style(const Style& style, const AssetRoots& roots);
  /// The picture of the state in picture_. errors as render().
  Result<void> draw(const ParamState& state, const RenderOptions& options);
  Result<Image> read_picture() const;
  Result<double> error(const ParamState& state, const Target& target, std::optional<std::span<const int>> moving);
  Result<void> colors_at(const ParamState& state, std::span<const int> without, std::span<const std::uint32_t> pixels,
                         std::span<Vec3> out);
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out);

  [[nodiscard]] const SurfaceBuffer& surface() const { return ruled_ ? ruled_->surface : deep_->surface(); }
  [[nodiscard]] const SceneFrame& frame() const { return frame_; }
  [[nodiscard]] const Style& style() const { return style_; }
  [[nodiscard]] const WorkCount& work() const { return work_; }

 private:
  /// What one dispatch shades: lights (places in the rig, lit ones), with emission and ambient or without.
  struct Layer {
    std::vector<int> lights;
    bool whole = true;
  };
  /// What a style with lines needs, to draw them again with another width.
  struct Ruled {
    SurfaceBuffer surface;  ///< without lines: brushes and rays do not see them
    Scene scene;            ///< without meshes
    Camera camera;
    AssetRoots roots;
    OutlineBuffers outlines;
    std::optional<LineSpec> drawn;  ///< empty: none yet
  };
  Result<void> prepare_lines(const Scene& scene, const Camera& camera, const AssetRoots& roots);
  /// The deep framebuffer gets the lines that these values of the style ask for.
  Result<void> follow_lines(const ParamBlock& style);
  Result<void> allocate_colors();
  Result<void> update_shadows(const ParamState& state);
  Result<void> shade(const ParamState& state, const RenderOptions& options);
  /// The moving lights over the kept sum of the others.
  Result<void> shade_moving(const ParamState& state, std::span<const int> moving);
  Result<void> keep_still(const ParamState& state, const Layer& still);
  /// All that a layer's colours depend on.
  [[nodiscard]] std::vector<std::byte> key_of(const ParamState& state, const Layer& layer) const;
  Result<void> run(const ParamState& state, const Layer& layer, bool shadows, const GlBuffer* below,
                   const GlBuffer& colors);
  Result<void> finish(const ParamState& state, bool shadows);
  Result<void> resolve(const GlBuffer& colors);

  Device* device_;
  const LightTypes* types_;
  Style style_;
  SceneFrame frame_;
  MeshBuffers meshes_;
  std::optional<DeepFramebuffer> deep_;
  std::optional<Ruled> ruled_;  ///< of a style with lines
  std::optional<ShadowMaps> maps_;
  std::optional<Relight> relight_;
  std::optional<CandidateTable> table_;
  std::optional<RayScene> rays_;
  std::optional<BatchEvaluator> batch_;
  std::optional<MetricPass> metric_;
  Program resolve_program_;
  GlBuffer colors_;   ///< vec4 [samples]
  GlBuffer picture_;  ///< vec4 [pixels]
  GlBuffer still_;    ///< vec4 [samples], what the lights add that do not move; empty until it is needed
  std::vector<std::byte> still_key_;
  std::vector<std::byte> picture_key_;  ///< of what picture_ shows, with shadows; empty if that is unknown
  GlBuffer bad_;                        ///< uint, pixels that were not finite
  WorkCount work_;
};

Result<void> RasterRenderer::Impl::prepare(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width,
                                           int height) {
  LUM_TRY(deep_, DeepFramebuffer::create(*device_, roots, meshes_, scene, camera, width, height,
                                         {.strokes = style_.strokes, .radius = frame_.radius, .lines = {}}));
  if (!style_.ink_path.empty()) LUM_TRY_VOID(prepare_lines(scene, camera, roots));
  LUM_TRY(maps_, ShadowMaps::create(*device_, roots, meshes_));
  LUM_TRY(relight_, Relight::create(*device_, *types_, style_, roots));
  table_ = relight_->make_table(surface().object_names);
  LUM_TRY(rays_, RayScene::create(scene));
  batch_.emplace(*device_, *relight_, *deep_, surface(), *types_, *rays_, meshes_.shadow_frame());
  LUM_TRY(metric_, MetricPass::create(*device_, roots, deep_->pixel_count()));
  std::vector<SourceChunk> chunks;
  for (const char* file : {"shaders/raster/dispatch.glsl", "shaders/raster/resolve.comp"}) {
    LUM_TRY(SourceChunk chunk, load_chunk(roots, file));
    chunks.push_back(std::move(chunk));
  }
  LUM_TRY(resolve_program_, Program::compute(*device_, chunks, "resolve"));
  resolve_program_.set("pixels", static_cast<unsigned>(deep_->pixel_count()));
  const auto storage = [&](std::size_t bytes, const char* label) {
    return GlBuffer::create(*device_, BufferUse::kStorage, bytes, label);
  };
  LUM_TRY_VOID(allocate_colors());
  LUM_TRY(picture_, storage(deep_->pixel_count() * sizeof(Vec4), "picture"));
  LUM_TRY(bad_, storage(sizeof(std::uint32_t), "pixels that are not finite"));
  return device_->check_errors("prepare the renderer");
}

Result<void> RasterRenderer::Impl::change_style(const Style& style, const AssetRoots& roots) {
  if (style.strokes != style_.strokes || style.ink_path.empty() != style_.ink_path.empty()) {
    return Error{ErrorKind::kUsage, fmt::format("the style \"{}\" now needs the scene prepared otherwise", style.name),
                 style.folder, "strokes, ink", "open the shot again"};
  }
  LUM_TRY(Relight relight, Relight::create(*device_, *types_, style, roots));
  relight_ = std::move(relight);
  style_ = style;
  table_ = relight_->make_table(surface().object_names);
  batch_.emplace(*device_, *relight_, *deep_, surface(), *types_, *rays_, meshes_.shadow_frame());
  still_key_.clear();
  picture_key_.clear();
  return {};
}

Result<void> RasterRenderer::Impl::allocate_colors() {
  LUM_TRY(colors_,
          GlBuffer::create(*device_, BufferUse::kStorage, deep_->sample_count() * sizeof(Vec4), "sample colours"));
  still_ = {};
  still_key_.clear();
  picture_key_.clear();
  return {};
}

Result<void> RasterRenderer::Impl::prepare_lines(const Scene& scene, const Camera& camera, const AssetRoots& roots) {
  LUM_TRY(OutlineBuffers outlines, OutlineBuffers::create(*device_, scene));
  Scene without_meshes;
  without_meshes.materials = scene.materials;
  without_meshes.textures = scene.textures;
  without_meshes.objects = scene.objects;
  ruled_.emplace(Ruled{deep_->surface(), std::move(without_meshes), camera, roots, std::move(outlines), {}});
  return {};
}

Result<void> RasterRenderer::Impl::follow_lines(const ParamBlock& style) {
  if (!ruled_) return {};
  const LineSpec spec = line_spec(style);
  if (ruled_->drawn == spec) return {};
  DeepExtras extras{.strokes = style_.strokes, .radius = frame_.radius, .lines = {}};
  if (spec.any()) extras.lines = DeepLines{&ruled_->outlines, spec, frame_};
  ruled_->drawn.reset();
  LUM_TRY(deep_, DeepFramebuffer::create(*device_, ruled_->roots, meshes_, ruled_->scene, ruled_->camera,
                                         deep_->width(), deep_->height(), extras));
  LUM_TRY_VOID(allocate_colors());
  ruled_->drawn = spec;
  return {};
}

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
  LUM_TRY_VOID(relight_->run(job));
  const double shades = static_cast<double>(deep_->pixel_count()) * static_cast<double>(layer.lights.size());
  work_.shades += shades;
  work_.shadow_queries += shadows ? shades : 0.0;
  return {};
}

Result<void> RasterRenderer::Impl::update_shadows(const ParamState& state) {
  std::vector<ShadowLight> lit = shadow_lights(state.rig, *types_, meshes_.shadow_frame());
  for (std::size_t i = lit.size(); i-- > 0;) {
    if (state.rig.lights[i].muted) lit.erase(lit.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return maps_->update(*deep_, lit);
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

Result<void> RasterRenderer::change_style(const Style& style, const AssetRoots& roots) {
  return impl_->change_style(style, roots);
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
