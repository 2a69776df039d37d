#include "raster/raster_renderer.h"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "base/check.h"
#include "raster/batch_evaluator.h"
#include "raster/deep_framebuffer.h"
#include "raster/mesh_buffers.h"
#include "raster/metric_pass.h"
#include "raster/relight.h"
#include "raster/shadow_maps.h"
#include "rays/ray_scene.h"
#include "render/metric.h"

namespace luminist {
namespace {

constexpr double kMaxBadShare = 0.01;  // of a picture's pixels; more is the style's fault

}  // namespace

class RasterRenderer::Impl {
 public:
  Impl(Device& device, const LightTypes& types, const Style& style, SceneFrame frame, MeshBuffers meshes)
      : device_(&device), types_(&types), style_(style), frame_(frame), meshes_(std::move(meshes)) {}

  Result<void> prepare(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width, int height);
  /// The picture of the state in picture_. errors as render().
  Result<void> draw(const ParamState& state, const RenderOptions& options);
  Result<Image> read_picture() const;
  Result<double> error(const ParamState& state, const Target& target);
  Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples, const Softness& softness,
                        std::span<Vec3> out);

  [[nodiscard]] const SurfaceBuffer& surface() const { return deep_->surface(); }
  [[nodiscard]] const SceneFrame& frame() const { return frame_; }
  [[nodiscard]] const Style& style() const { return style_; }
  [[nodiscard]] const WorkCount& work() const { return work_; }

 private:
  Result<void> shade(const ParamState& state, const RenderOptions& options);
  Result<void> resolve();

  Device* device_;
  const LightTypes* types_;
  Style style_;
  SceneFrame frame_;
  MeshBuffers meshes_;
  std::optional<DeepFramebuffer> deep_;
  std::optional<ShadowMaps> maps_;
  std::optional<Relight> relight_;
  std::optional<CandidateTable> table_;
  std::optional<RayScene> rays_;
  std::optional<BatchEvaluator> batch_;
  std::optional<MetricPass> metric_;
  Program resolve_program_;
  GlBuffer colors_;   ///< vec4 [samples]
  GlBuffer picture_;  ///< vec4 [pixels]
  GlBuffer bad_;      ///< uint, pixels that were not finite
  WorkCount work_;
};

Result<void> RasterRenderer::Impl::prepare(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width,
                                           int height) {
  LUM_TRY(deep_, DeepFramebuffer::create(*device_, roots, meshes_, scene, camera, width, height));
  LUM_TRY(maps_, ShadowMaps::create(*device_, roots, meshes_));
  LUM_TRY(relight_, Relight::create(*device_, *types_, style_, roots));
  table_ = relight_->make_table();
  LUM_TRY(rays_, RayScene::create(scene));
  batch_.emplace(*device_, *relight_, *deep_, *types_, *rays_);
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
  LUM_TRY(colors_, storage(deep_->sample_count() * sizeof(Vec4), "sample colours"));
  LUM_TRY(picture_, storage(deep_->pixel_count() * sizeof(Vec4), "picture"));
  LUM_TRY(bad_, storage(sizeof(std::uint32_t), "pixels that are not finite"));
  return device_->check_errors("prepare the renderer");
}

Result<void> RasterRenderer::Impl::shade(const ParamState& state, const RenderOptions& options) {
  // Rows of the visibility buffer belong to the lights that are lit, in rig order.
  const std::vector<ShadowLight> all = shadow_lights(state.rig, *types_);
  std::vector<ShadowLight> lit;
  std::vector<std::uint32_t> row(all.size(), kNone);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (state.rig.lights[i].muted) continue;
    row[i] = static_cast<std::uint32_t>(lit.size());
    lit.push_back(all[i]);
  }
  if (options.shadows) LUM_TRY_VOID(maps_->update(*deep_, lit));

  table_->clear();
  const auto column_of = [&](const LightRig&, int light) {
    return options.shadows ? row[static_cast<std::size_t>(light)] : kNone;
  };
  if (!table_->add({&state, Candidate::kAllLights}, column_of)) {
    return Error{ErrorKind::kLimit, "the rig has more lights of one type than this device takes at once", "", "",
                 "remove lights"};
  }
  RelightJob job;
  job.surface = &*deep_;
  job.table = &*table_;
  job.samples = deep_->sample_count();
  job.visibility = options.shadows && !lit.empty() ? &maps_->visibility() : nullptr;
  job.colors = &colors_;
  LUM_TRY_VOID(relight_->run(job));
  const double lookups = static_cast<double>(deep_->pixel_count()) * static_cast<double>(lit.size());
  work_.shades += lookups;
  work_.shadow_queries += options.shadows ? lookups : 0.0;
  work_.pictures += 1.0;
  return {};
}

Result<void> RasterRenderer::Impl::resolve() {
  bad_.fill(0, sizeof(std::uint32_t), 0.0F);
  colors_.bind_storage(0);
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
               style_.glsl_path, "", "guard divisions, square roots and powers; see shaders/lib/helpers.glsl"};
}

Result<void> RasterRenderer::Impl::draw(const ParamState& state, const RenderOptions& options) {
  LUM_TRY_VOID(shade(state, options));
  LUM_TRY_VOID(resolve());
  return device_->check_errors("render the picture");
}

Result<Image> RasterRenderer::Impl::read_picture() const {
  std::vector<Vec4> pixels(deep_->pixel_count());
  picture_.read(0, std::span<Vec4>(pixels));
  Image image(deep_->width(), deep_->height(), 3);
  for (std::size_t i = 0; i < pixels.size(); ++i) image.set_rgb(i, Vec3(pixels[i]));
  return image;
}

Result<double> RasterRenderer::Impl::error(const ParamState& state, const Target& target) {
  LUM_TRY_VOID(draw(state, {}));
  if (style_.metric.blur <= 0.0F) return metric_->error(picture_, target);
  LUM_TRY(const Image picture, read_picture());
  return picture_error(picture, target, style_.metric);
}

Result<void> RasterRenderer::Impl::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                            const Softness& softness, std::span<Vec3> out) {
  const double shades = batch_->shades();
  const double queries = batch_->queries();
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
  LUM_TRY(MeshBuffers meshes, MeshBuffers::create(device, scene));
  auto impl = std::make_unique<Impl>(device, types, style, scene.frame(), std::move(meshes));
  LUM_TRY_VOID(impl->prepare(scene, camera, roots, width, height));
  return std::unique_ptr<RasterRenderer>(new RasterRenderer(std::move(impl)));
}

const SurfaceBuffer& RasterRenderer::surface() const {
  return impl_->surface();
}
SceneFrame RasterRenderer::frame() const {
  return impl_->frame();
}
const Style& RasterRenderer::style() const {
  return impl_->style();
}
const WorkCount& RasterRenderer::work() const {
  return impl_->work();
}

Result<Image> RasterRenderer::render(const ParamState& state, const RenderOptions& options) {
  LUM_TRY_VOID(impl_->draw(state, options));
  return impl_->read_picture();
}

Result<double> RasterRenderer::error(const ParamState& state, const Target& target) {
  return impl_->error(state, target);
}

Result<void> RasterRenderer::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                      const Softness& softness, std::span<Vec3> out) {
  return impl_->evaluate(candidates, samples, softness, out);
}

}  // namespace luminist
