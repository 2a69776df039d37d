#include "raster/deep_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"
#include "gpu/settled_drawing.h"
#include "raster/deep_framebuffer.h"

namespace luminist {
namespace {

struct TargetFormat {
  GLenum format;
  std::size_t bytes;
  const char* label;
};

/// In the order of the outputs of shaders/raster/deep.frag.
constexpr std::array<TargetFormat, 7> kTargets{{{GL_RGBA32F, 16, "deep position"},
                                                {GL_RGBA32F, 16, "deep normal"},
                                                {GL_RGBA32F, 16, "deep albedo"},
                                                {GL_RGBA32F, 16, "deep specular"},
                                                {GL_RGBA32F, 16, "deep emissive"},
                                                {GL_RG32UI, 8, "deep ids"},
                                                {GL_RGBA32F, 16, "deep strokes"}}};
constexpr std::size_t kIdTarget = 5;
constexpr std::size_t kStrokeTarget = 6;  // the last; only where it is asked for
constexpr GLuint kLineUnit = 6;           // of shaders/raster/deep_samples.glsl
constexpr GLuint kStrokeUnit = 7;

std::size_t bytes_per_pixel() {
  std::size_t bytes = 0;
  for (const TargetFormat& target : kTargets) bytes += target.bytes;
  return bytes * DeepPasses::kLayers;
}

/// The camera with its planes drawn in to the scene's bounds: the same picture with a finer depth.
Camera with_tight_planes(Camera camera, const Box& bounds) {
  if (bounds.empty()) return camera;
  const Vec3 eye = camera.position();
  const Vec3 ahead = -glm::normalize(Vec3(camera.world_from_camera[2]));
  float nearest = std::numeric_limits<float>::infinity();
  float farthest = -nearest;
  for (int corner = 0; corner < 8; ++corner) {
    const float depth = glm::dot(bounds.corner(corner) - eye, ahead);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const float near_plane = std::max(camera.near_plane, 0.99F * nearest);
  const float far_plane = std::min(camera.far_plane, 1.01F * farthest);
  if (!(near_plane < far_plane)) return camera;
  camera.near_plane = near_plane;
  camera.far_plane = far_plane;
  return camera;
}

/// Moves the picture so that the sample at `offset` (pixels from the centre; y down) falls on the pixel centre.
Mat4 shift(const float (&offset)[2], int width, int height) {
  Mat4 moved(1.0F);
  moved[3][0] = -2.0F * offset[0] / static_cast<float>(width);
  moved[3][1] = 2.0F * offset[1] / static_cast<float>(height);
  return moved;
}

}  // namespace

Result<DeepPasses> DeepPasses::create(Device& device, const AssetRoots& roots, const MeshBuffers& meshes,
                                      const Scene& scene, const Camera& camera, int width, int height,
                                      const DeepExtras& extras, std::size_t band_bytes) {
  LUM_CHECK(width > 0 && height > 0, "a picture has pixels");
  DeepPasses passes;
  passes.meshes_ = &meshes;
  passes.scene_ = &scene;
  passes.width_ = width;
  passes.height_ = height;
  const std::size_t row_bytes = static_cast<std::size_t>(width) * bytes_per_pixel();
  passes.band_rows_ =
      static_cast<int>(std::clamp<std::size_t>(band_bytes / row_bytes, 1, static_cast<std::size_t>(height)));
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  passes.eye_ = camera.position();
  passes.radius_ = extras.radius;

  LUM_TRY(const SourceChunk vertex, load_chunk(roots, "shaders/raster/deep.vert"));
  LUM_TRY(const SourceChunk fragment, load_chunk(roots, "shaders/raster/deep.frag"));
  LUM_TRY(passes.program_, Program::graphics(device, {&vertex, 1}, {&fragment, 1}, "deep framebuffer"));
  passes.strokes_ = extras.strokes;
  if (extras.lines) {
    const int rows = passes.band_rows_ + 2 * kLineMargin;
    LUM_TRY(passes.lines_,
            LinePasses::create(device, roots, *extras.lines, scene, camera, width, height, rows, kLayers));
  }
  Box bounds = meshes.bounds();
  if (passes.lines_ && !bounds.empty()) {
    const Vec3 reach(passes.lines_->reach(glm::distance(bounds.center(), passes.eye_) + bounds.radius()));
    bounds = {bounds.lo - reach, bounds.hi + reach};
  }
  passes.clip_from_world_ = with_tight_planes(camera, bounds).clip_from_world(aspect);
  LUM_TRY_VOID(passes.create_targets(device));
  LUM_TRY_VOID(passes.upload_textures(device));
  return passes;
}

Result<void> DeepPasses::create_targets(Device& device) {
  const int rows = band_rows_ + 2 * margin();
  for (std::size_t i = 0; i < (strokes_ ? kTargets.size() : kStrokeTarget); ++i) {
    const TargetFormat& target = kTargets[i];
    LUM_TRY(GlTexture texture, GlTexture::create_2d_array(device, target.format, width_, rows, kLayers, target.label));
    targets_.push_back(std::move(texture));
  }
  LUM_TRY(depth_, GlTexture::create_2d(device, GL_DEPTH_COMPONENT32F, width_, rows, "deep depth"));
  for (int layer = 0; layer < kLayers; ++layer) {
    GlFramebuffer framebuffer = GlFramebuffer::create(device, "deep framebuffer");
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      framebuffer.attach_color(static_cast<int>(i), targets_[i], layer);
    }
    framebuffer.attach_depth(depth_);
    LUM_TRY_VOID(framebuffer.finish(static_cast<int>(targets_.size())));
    framebuffers_.push_back(std::move(framebuffer));
  }
  return {};
}

Result<void> DeepPasses::upload_textures(Device& device) {
  for (const Texture& texture : scene_->textures) {
    if (texture.image.empty()) {
      textures_.emplace_back();
      continue;
    }
    LUM_TRY(GlTexture uploaded, GlTexture::create_picture(device, texture.image, texture.repeat_u, texture.repeat_v,
                                                          "texture " + texture.name));
    textures_.push_back(std::move(uploaded));
  }
  return {};
}

int DeepPasses::rows(int band) const {
  return std::min(band_rows_, height_ - first_row(band));
}

void DeepPasses::draw(Device& device, int band) {
  if (drawn_band_ == band) return;
  drawn_band_ = band;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glFrontFace(GL_CCW);
  program_.set("eye", eye_);
  for (int layer = 0; layer < kLayers; ++layer) {
    draw_layer(device, layer, first_row(band));
  }
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  if (!lines_) return;
  bind();
  set_band(lines_->marking(), band);
  lines_->mark(device, static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows(band)));
}

void DeepPasses::draw_layer(const Device& device, int layer, int first_row) {
  SettledDrawing drawing(device);
  const GlFramebuffer& framebuffer = framebuffers_[static_cast<std::size_t>(layer)];
  framebuffer.bind(width_, height_);
  // The viewport is that of the whole picture, so that a band is exactly a part of it.
  glViewport(0, margin() - first_row, width_, height_);
  const std::array<float, 4> zero{};
  const std::array<GLuint, 4> nothing{};
  const float far_depth = 1.0F;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (i != kIdTarget) glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, static_cast<GLint>(i), zero.data());
  }
  glClearNamedFramebufferuiv(framebuffer.name(), GL_COLOR, static_cast<GLint>(kIdTarget), nothing.data());
  glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &far_depth);

  const Mat4 moved = layer == 0 ? Mat4(1.0F) : shift(DeepFramebuffer::kEdgeOffsets[layer - 1], width_, height_);
  draw_models(drawing, moved * clip_from_world_);
  if (lines_) lines_->draw(drawing, moved * clip_from_world_);
}

void DeepPasses::draw_models(SettledDrawing& drawing, const Mat4& clip_from_world) {
  meshes_->bind_full();
  program_.use();
  program_.set("clip_from_world", clip_from_world);
  program_.set("heights_per_pixel", 1.0F / static_cast<float>(height_));
  for (const MeshDraw& draw : meshes_->draws()) {
    const Mat3 linear(draw.world_from_object);
    program_.set("world_from_object", draw.world_from_object);
    program_.set("normal_from_object", normal_matrix(linear));
    program_.set("radii_per_unit", std::cbrt(std::abs(glm::determinant(linear))) / radius_);
    program_.set("side", glm::determinant(linear) < 0.0F ? -1.0F : 1.0F);
    glProgramUniform2ui(program_.name(), glGetUniformLocation(program_.name(), "ids"), draw.object + 1,
                        draw.material + 1);
    set_material(scene_->materials[draw.material]);
    draw_mesh(drawing, draw);
  }
}

void DeepPasses::set_material(const Material& material) {
  program_.set("base_color", material.base_color);
  program_.set("metallic", material.metallic);
  program_.set("roughness", material.roughness);
  program_.set("specular", material.specular);
  program_.set("emissive", material.emissive);
  program_.set("normal_scale", material.normal_scale);
  const auto bind = [this](GLuint unit, const char* flag, int index) {
    const bool has = index >= 0 && textures_[static_cast<std::size_t>(index)].name() != 0;
    program_.set(flag, has ? 1 : 0);
    if (has) textures_[static_cast<std::size_t>(index)].bind(unit);
  };
  bind(0, "has_base_color_texture", material.base_color_texture);
  bind(1, "has_metallic_roughness_texture", material.metallic_roughness_texture);
  bind(2, "has_normal_texture", material.normal_texture);
  bind(3, "has_emissive_texture", material.emissive_texture);
}

void DeepPasses::bind() const {
  for (std::size_t i = 0; i < kStrokeTarget; ++i) targets_[i].bind(static_cast<GLuint>(i));
  if (lines_) lines_->bind(kLineUnit);
  if (strokes_) targets_[kStrokeTarget].bind(kStrokeUnit);
}

void DeepPasses::set_band(Program& program, int band) const {
  glProgramUniform2ui(program.name(), glGetUniformLocation(program.name(), "size"), static_cast<GLuint>(width_),
                      static_cast<GLuint>(height_));
  program.set("band_row", static_cast<unsigned>(first_row(band)));
  program.set("band_rows", static_cast<unsigned>(rows(band)));
  program.set("margin", static_cast<unsigned>(margin()));
  program.set("has_lines", lines_ ? 1 : 0);
  program.set("has_strokes", strokes_ ? 1 : 0);
}

}  // namespace luminist
