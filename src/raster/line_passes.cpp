#include "raster/line_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "raster/deep_framebuffer.h"
#include "surface/outline_hull.h"

namespace luminist {
namespace {

constexpr unsigned kSilhouette = 1;  // LINE_... of shaders/lib/surface.glsl
constexpr unsigned kCrease = 2;
constexpr float kCreasePull = 1.0F;  // widths that a crease is moved to the eye, so that it lies on the surface
constexpr float kNearest = 0.25F;    // scene radii, of the depth at which widths are measured
constexpr float kPush = 1.0F;        // widths that a hull is moved away from the eye, so that shallow folds get no line

Result<Program> load_marking(Device& device, const AssetRoots& roots) {
  std::vector<SourceChunk> chunks;
  for (const char* file : {"dispatch.glsl", "deep_samples.glsl", "lines.comp"}) {
    LUM_TRY(SourceChunk chunk, load_chunk(roots, std::string("shaders/raster/") + file));
    chunks.push_back(std::move(chunk));
  }
  return Program::compute(device, chunks, "lines");
}

}  // namespace

Result<LinePasses> LinePasses::create(Device& device, const AssetRoots& roots, const DeepLines& lines,
                                      const Scene& scene, const Camera& camera, int width, int height, int band_rows,
                                      int layers) {
  LinePasses passes;
  passes.lines_ = lines;
  passes.scene_ = &scene;
  passes.eye_ = camera.position();
  passes.height_ = height;
  passes.pixel_angle_ = 2.0F * std::tan(0.5F * camera.fov_y) / static_cast<float>(height);
  const Vec3 ahead = -glm::normalize(Vec3(camera.world_from_camera[2]));
  // A camera within the scene may look away from its centre.
  passes.reference_depth_ = std::max(glm::dot(lines.frame.center - passes.eye_, ahead), kNearest * lines.frame.radius);
  LUM_TRY(const SourceChunk hull, load_chunk(roots, "shaders/raster/outline.vert"));
  LUM_TRY(const SourceChunk edge, load_chunk(roots, "shaders/raster/crease.vert"));
  LUM_TRY(const SourceChunk fragment, load_chunk(roots, "shaders/raster/outline.frag"));
  LUM_TRY(passes.silhouette_program_, Program::graphics(device, {&hull, 1}, {&fragment, 1}, "silhouettes"));
  LUM_TRY(passes.crease_program_, Program::graphics(device, {&edge, 1}, {&fragment, 1}, "creases"));
  LUM_TRY(passes.mark_program_, load_marking(device, roots));
  LUM_TRY(passes.kinds_, GlTexture::create_2d_array(device, GL_R8UI, width, band_rows, layers, "lines"));
  return passes;
}

float LinePasses::width_at_centre() const {
  if (lines_.spec.in_scene_radii) return lines_.spec.width * lines_.frame.radius;
  return lines_.spec.width * pixel_angle_ * static_cast<float>(height_) * reference_depth_;
}

float LinePasses::reach(float depth) const {
  const float growth = (lines_.spec.in_scene_radii ? 0.0F : 1.0F) - lines_.spec.distance;
  const float widest = width_at_centre() * std::pow(std::max(1.0F, depth / reference_depth_), std::max(0.0F, growth));
  return (OutlineHull::kLongest + kPush) * widest;
}

void LinePasses::set_width(Program& program, float width) const {
  program.set("eye", eye_);
  program.set("width", width);
  program.set("reference_depth", reference_depth_);
  program.set("growth", (lines_.spec.in_scene_radii ? 0.0F : 1.0F) - lines_.spec.distance);
}

void LinePasses::set_object(Program& program, const MeshDraw& draw) const {
  program.set("world_from_object", draw.world_from_object);
  program.set("normal_from_object", normal_matrix(Mat3(draw.world_from_object)));
  glProgramUniform2ui(program.name(), glGetUniformLocation(program.name(), "ids"), draw.object + 1, draw.material + 1);
  program.set("base_color", scene_->materials[draw.material].base_color);
}

void LinePasses::draw(SettledDrawing& drawing, const Mat4& clip_from_world) {
  if (!(lines_.spec.width > 0.0F)) return;
  if (lines_.spec.silhouette) draw_silhouettes(drawing, clip_from_world);
  if (lines_.spec.crease) draw_creases(drawing, clip_from_world);
}

void LinePasses::draw_silhouettes(SettledDrawing& drawing, const Mat4& clip_from_world) {
  silhouette_program_.use();
  silhouette_program_.set("clip_from_world", clip_from_world);
  silhouette_program_.set("push", kPush);
  silhouette_program_.set("kind", kSilhouette);
  set_width(silhouette_program_, width_at_centre());
  lines_.outlines->bind_hulls();
  glEnable(GL_CULL_FACE);
  for (const MeshDraw& draw : lines_.outlines->hulls()) {
    glCullFace(glm::determinant(Mat3(draw.world_from_object)) < 0.0F ? GL_BACK : GL_FRONT);
    set_object(silhouette_program_, draw);
    draw_mesh(drawing, draw);
  }
  glDisable(GL_CULL_FACE);
}

void LinePasses::draw_creases(SettledDrawing& drawing, const Mat4& clip_from_world) {
  crease_program_.use();
  crease_program_.set("clip_from_world", clip_from_world);
  crease_program_.set("pull", kCreasePull);
  crease_program_.set("least_angle", lines_.spec.crease_angle);
  crease_program_.set("kind", kCrease);
  set_width(crease_program_, lines_.spec.inner * width_at_centre());
  lines_.outlines->bind_edges();
  for (const MeshDraw& draw : lines_.outlines->edges()) {
    set_object(crease_program_, draw);
    draw_mesh(drawing, draw);
  }
}

void LinePasses::mark(Device& device, std::size_t pixels) {
  const LineSpec& spec = lines_.spec;
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);  // of the band before
  const GLuint none = 0;
  glClearTexImage(kinds_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
  if (!spec.marked() || !(spec.width > 0.0F)) return;
  glBindImageTexture(0, kinds_.name(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_R8UI);
  set_width(mark_program_, spec.inner * width_at_centre());
  mark_program_.set("pixel_angle", pixel_angle_);
  mark_program_.set("intersections", spec.intersection ? 1 : 0);
  mark_program_.set("borders", spec.border ? 1 : 0);
  for (int k = 0; k < DeepFramebuffer::kEdgeSamples; ++k) {
    const auto& offset = DeepFramebuffer::kEdgeOffsets[k];
    const std::array<const char*, 4> names{"offsets[0]", "offsets[1]", "offsets[2]", "offsets[3]"};
    mark_program_.set(names[static_cast<std::size_t>(k)], Vec2(offset[0], offset[1]));
  }
  mark_program_.use();
  mark_program_.dispatch(device, pixels);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace luminist
