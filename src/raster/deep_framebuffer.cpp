#include "raster/deep_framebuffer.h"

#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "gpu/program.h"
#include "raster/deep_passes.h"

namespace luminist {
namespace {

constexpr std::uint32_t kMaterialBits = 0x0fffffffU;  // of the word that also holds the kind of a line

Result<Program> load_program(Device& device, const AssetRoots& roots, const std::string& name) {
  LUM_TRY(SourceChunk index, load_chunk(roots, "shaders/raster/dispatch.glsl"));
  LUM_TRY(SourceChunk samples, load_chunk(roots, "shaders/raster/deep_samples.glsl"));
  LUM_TRY(SourceChunk main, load_chunk(roots, "shaders/raster/" + name));
  const std::array<SourceChunk, 3> chunks{std::move(index), std::move(samples), std::move(main)};
  return Program::compute(device, chunks, name);
}

void run_on_band(Device& device, DeepPasses& passes, Program& program, int band, int width) {
  passes.draw(device, band);
  passes.bind();
  passes.set_band(program, band);
  program.dispatch(device, static_cast<std::size_t>(width) * static_cast<std::size_t>(passes.rows(band)));
}

/// Marks become places: 1 becomes the pixel's number among the edge pixels, 0 becomes kNoEdge. returns how many there
/// are. Counted on the CPU, so that the order is that of the rows on every device.
std::size_t number_edges(std::span<std::uint32_t> marks) {
  std::uint32_t count = 0;
  for (std::uint32_t& mark : marks) mark = mark != 0 ? count++ : DeepFramebuffer::kNoEdge;
  return count;
}

std::vector<Vec4> read_centres(const GlBuffer& buffer, std::size_t pixels) {
  std::vector<Vec4> values(pixels);
  buffer.read(0, std::span(values));
  return values;
}

Mat4 picture_from_world(const Camera& camera, int width, int height) {
  const float aspect = static_cast<float>(width) / static_cast<float>(height);
  Mat4 screen_from_clip(1.0F);
  screen_from_clip[0][0] = 0.5F * aspect;
  screen_from_clip[1][1] = -0.5F;
  screen_from_clip[3][0] = 0.5F * aspect;  // times w, which the division takes out again
  screen_from_clip[3][1] = 0.5F;
  return screen_from_clip * camera.clip_from_world(aspect);
}

}  // namespace

Result<DeepFramebuffer> DeepFramebuffer::create(Device& device, const AssetRoots& roots, const MeshBuffers& meshes,
                                                const Scene& scene, const Camera& camera, int width, int height,
                                                const DeepExtras& extras, std::size_t band_bytes) {
  DeepFramebuffer deep;
  deep.id_ = device.new_id();
  deep.surface_.width = width;
  deep.surface_.height = height;
  deep.screen_from_world_ = picture_from_world(camera, width, height);
  LUM_TRY(DeepPasses passes,
          DeepPasses::create(device, roots, meshes, scene, camera, width, height, extras, band_bytes));
  LUM_TRY(Program edges, load_program(device, roots, "edges.comp"));
  LUM_TRY(Program gather, load_program(device, roots, "gather.comp"));

  std::vector<std::uint32_t> marks(deep.pixel_count());
  LUM_TRY(deep.edge_of_pixel_,
          GlBuffer::create(device, BufferUse::kStorage, marks.size() * sizeof(std::uint32_t), "edge of pixel"));
  deep.edge_of_pixel_.bind_storage(5);
  edges.set("pixel_angle", 2.0F * std::tan(0.5F * camera.fov_y) / static_cast<float>(height));
  for (int band = 0; band < passes.band_count(); ++band) run_on_band(device, passes, edges, band, width);
  deep.edge_of_pixel_.read(0, std::span(marks));
  deep.edge_count_ = number_edges(marks);
  deep.edge_of_pixel_.write(0, std::span(std::as_const(marks)));

  const std::array<std::pair<GlBuffer*, const char*>, 5> lists{{{&deep.position_, "sample positions"},
                                                                {&deep.normal_, "sample normals"},
                                                                {&deep.albedo_, "sample albedos"},
                                                                {&deep.specular_, "sample speculars"},
                                                                {&deep.emissive_, "sample emissions"}}};
  for (std::size_t i = 0; i < lists.size(); ++i) {
    LUM_TRY(*lists[i].first,
            GlBuffer::create(device, BufferUse::kStorage, deep.sample_count() * sizeof(Vec4), lists[i].second));
    lists[i].first->bind_storage(static_cast<GLuint>(i));
  }
  if (extras.strokes) {
    LUM_TRY(deep.stroke_,
            GlBuffer::create(device, BufferUse::kStorage, deep.sample_count() * sizeof(Vec4), "sample strokes"));
    deep.stroke_.bind_storage(6);
  }
  for (int band = passes.band_count() - 1; band >= 0; --band) run_on_band(device, passes, gather, band, width);
  deep.read_surface(scene, camera.position());
  LUM_TRY_VOID(device.check_errors("draw the deep framebuffer"));
  return deep;
}

void DeepFramebuffer::read_surface(const Scene& scene, const Vec3& eye) {
  surface_.eye = eye;
  const std::size_t pixels = pixel_count();
  const std::vector<Vec4> position = read_centres(position_, pixels);
  const std::vector<Vec4> normal = read_centres(normal_, pixels);
  const std::vector<Vec4> albedo = read_centres(albedo_, pixels);
  const std::vector<Vec4> specular = read_centres(specular_, pixels);
  for (std::vector<Vec3>* list : {&surface_.position, &surface_.normal, &surface_.albedo, &surface_.specular}) {
    list->reserve(pixels);
  }
  for (std::size_t i = 0; i < pixels; ++i) {
    surface_.position.emplace_back(position[i]);
    surface_.object.push_back(std::bit_cast<std::uint32_t>(position[i].w));
    surface_.normal.emplace_back(normal[i]);
    surface_.material.push_back(std::bit_cast<std::uint32_t>(normal[i].w) & kMaterialBits);
    surface_.albedo.emplace_back(albedo[i]);
    surface_.roughness.push_back(albedo[i].w);
    surface_.specular.emplace_back(specular[i]);
  }
  surface_.object_names.emplace_back();
  for (const Object& object : scene.objects) surface_.object_names.push_back(object.name);
}

}  // namespace luminist
