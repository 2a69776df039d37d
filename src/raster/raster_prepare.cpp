// The part of the raster renderer that gets ready: what the camera sees, the lines, the style.
#include <utility>

#include <fmt/format.h>

#include "raster/raster_impl.h"

namespace luminist {

Result<void> RasterRenderer::Impl::prepare(const Scene& scene, const Camera& camera, const AssetRoots& roots, int width,
                                           int height) {
  LUM_TRY_VOID(draw_deep(scene, camera, roots, width, height));
  LUM_TRY(maps_, ShadowMaps::create(*device_, roots, meshes_));
  LUM_TRY(relight_, Relight::create(*device_, *types_, style_, roots));
  table_ = relight_->make_table(surface().object_names);
  LUM_TRY(rays_, RayScene::create(scene));
  batch_.emplace(*device_, *relight_, *deep_, surface(), *types_, *rays_, meshes_.shadow_frame());
  std::vector<SourceChunk> chunks;
  for (const char* file : {"shaders/raster/dispatch.glsl", "shaders/raster/resolve.comp"}) {
    LUM_TRY(SourceChunk chunk, load_chunk(roots, file));
    chunks.push_back(std::move(chunk));
  }
  LUM_TRY(resolve_program_, Program::compute(*device_, chunks, "resolve"));
  resolve_program_.set("pixels", static_cast<unsigned>(deep_->pixel_count()));
  LUM_TRY(bad_, GlBuffer::create(*device_, BufferUse::kStorage, sizeof(std::uint32_t), "pixels that are not finite"));
  return device_->check_errors("prepare the renderer");
}

Result<void> RasterRenderer::Impl::draw_deep(const Scene& scene, const Camera& camera, const AssetRoots& roots,
                                             int width, int height) {
  const std::size_t pixels = deep_ ? deep_->pixel_count() : 0;
  LUM_TRY(deep_, DeepFramebuffer::create(*device_, roots, meshes_, scene, camera, width, height,
                                         {.strokes = style_.strokes, .radius = frame_.radius, .lines = {}}));
  if (!style_.ink_path.empty()) LUM_TRY_VOID(prepare_lines(scene, camera, roots));
  LUM_TRY_VOID(allocate_colors());
  if (deep_->pixel_count() == pixels) return {};
  LUM_TRY(metric_, MetricPass::create(*device_, roots, deep_->pixel_count()));
  LUM_TRY(picture_, GlBuffer::create(*device_, BufferUse::kStorage, deep_->pixel_count() * sizeof(Vec4), "picture"));
  return {};
}

Result<void> RasterRenderer::Impl::look_from(const Scene& scene, const Camera& camera, const AssetRoots& roots,
                                             int width, int height) {
  LUM_TRY_VOID(draw_deep(scene, camera, roots, width, height));
  resolve_program_.set("pixels", static_cast<unsigned>(deep_->pixel_count()));
  batch_.emplace(*device_, *relight_, *deep_, surface(), *types_, *rays_, meshes_.shadow_frame());
  return device_->check_errors("look from elsewhere");
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

}  // namespace luminist
