#include "raster/shadow_maps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "gpu/settled_drawing.h"

namespace luminist {
namespace {

constexpr int kMostTaps = 64;  // as in shaders/raster/visibility.comp

/// Right, up and axis of a view as the rows of a rotation.
Mat3 view_along(const Vec3& axis) {
  Vec3 right;
  Vec3 up;
  tangent_frame(axis, right, up);
  return glm::transpose(Mat3(right, up, axis));
}

/// One view of a spot and of a sun; of a point six, in the order +x, -x, +y, -y, +z, -z.
std::vector<Mat3> views_of(const ShadowLight& light) {
  if (light.kind != ShadowKind::kCube) return {view_along(light.direction)};
  std::vector<Mat3> views;
  for (int i = 0; i < 6; ++i) {
    Vec3 axis(0.0F);
    axis[i / 2] = i % 2 == 0 ? 1.0F : -1.0F;
    views.push_back(view_along(axis));
  }
  return views;
}

/// Depth near / z, reversed and without a far plane: 1 at the near plane, 0 infinitely far away. Of a sun 1 to 0 over
/// twice the near plane's distance around its place.
Mat4 clip_from_world(const ShadowLight& light, const Mat3& view, float near_plane) {
  Mat4 rotation(view);
  Mat4 move(1.0F);
  move[3] = Vec4(-light.position, 1.0F);
  Mat4 projection(0.0F);
  projection[0][0] = 1.0F / light.extent;
  projection[1][1] = 1.0F / light.extent;
  if (light.parallel()) {
    projection[2][2] = -0.5F / near_plane;
    projection[3][2] = 0.5F;
    projection[3][3] = 1.0F;
    return projection * rotation * move;
  }
  projection[3][2] = near_plane;
  projection[2][3] = 1.0F;
  return projection * rotation * move;
}

/// Whether a box may be seen in a map: not if all of its corners are beyond one of the map's sides, or behind the
/// light.
bool may_show(const Mat4& clip_from_object, const Box& box) {
  constexpr float kSlack = 1.0001F;  // of the sides: corners are rounded
  std::array<int, 5> beyond{};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec4 clip = clip_from_object * Vec4(box.corner(corner), 1.0F);
    const float side = kSlack * clip.w;
    const std::array<bool, 5> out{clip.x > side, clip.x<-side, clip.y> side, clip.y < -side, clip.w < 0.0F};
    for (std::size_t i = 0; i < out.size(); ++i) beyond[i] += out[i] ? 1 : 0;
  }
  return std::ranges::find(beyond, 8) == beyond.end();
}

/// As far from the light as no triangle is nearer, along the axis of any view; but not so near that depth gets coarse.
float near_plane_of(const ShadowLight& light, const Box& bounds) {
  if (light.parallel()) {
    return 1.01F * (glm::length(bounds.center() - light.position) + bounds.radius());  // nothing lies beyond it
  }
  const Vec3 nearest = glm::clamp(light.position, bounds.lo, bounds.hi);
  const float distance = glm::length(nearest - light.position);
  const float corner = std::sqrt(1.0F + 2.0F * light.extent * light.extent);
  const float least = std::max(2e-3F * bounds.radius(), 1e-12F);
  return std::max(0.95F * distance / corner, least);
}

/// More comparisons where the disc covers many texels (maps have a least size), so that their steps stay invisible.
int taps_of(const ShadowLight& light) {
  return light.softness <= 4.5F * light.texel() ? kShadowTaps : kMostTaps;
}

}  // namespace

Result<ShadowMaps> ShadowMaps::create(Device& device, const AssetRoots& roots, const MeshBuffers& meshes) {
  ShadowMaps maps(device, meshes);
  LUM_TRY(const SourceChunk vertex, load_chunk(roots, "shaders/raster/shadow_map.vert"));
  LUM_TRY(const SourceChunk fragment, load_chunk(roots, "shaders/raster/shadow_map.frag"));
  LUM_TRY(maps.draw_program_, Program::graphics(device, {&vertex, 1}, {&fragment, 1}, "shadow map"));
  LUM_TRY(SourceChunk index, load_chunk(roots, "shaders/raster/dispatch.glsl"));
  LUM_TRY(SourceChunk main, load_chunk(roots, "shaders/raster/visibility.comp"));
  const std::array<SourceChunk, 2> chunks{std::move(index), std::move(main)};
  LUM_TRY(maps.lookup_program_, Program::compute(device, chunks, "visibility"));
  LUM_TRY(maps.visibility_, GlBuffer::create(device, BufferUse::kStorage, 0, "visibility"));
  maps.framebuffer_ = GlFramebuffer::create(device, "shadow map");
  return maps;
}

Result<ShadowMaps::Map> ShadowMaps::draw_map(const ShadowLight& light) {
  const std::vector<Mat3> views = views_of(light);
  Map map;
  map.light = light;
  map.near_plane = near_plane_of(light, meshes_->shadow_bounds());
  LUM_TRY(map.depth, GlTexture::create_2d_array(*device_, GL_DEPTH_COMPONENT32F, light.size_px, light.size_px,
                                                static_cast<int>(views.size()), "shadow map"));
  map.depth.set(GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  map.depth.set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  map.depth.set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  map.depth.set(GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
  // Beyond the edge everything is infinitely far away: lit.
  map.depth.set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  map.depth.set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const std::array<float, 4> border{};
  glTextureParameterfv(map.depth.name(), GL_TEXTURE_BORDER_COLOR, border.data());

  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glFrontFace(GL_CCW);
  glDisable(GL_SCISSOR_TEST);
  meshes_->bind_positions();
  draw_program_.use();
  for (std::size_t layer = 0; layer < views.size(); ++layer) {
    SettledDrawing drawing(*device_);
    framebuffer_.attach_depth(map.depth, static_cast<int>(layer));
    LUM_TRY_VOID(framebuffer_.finish(0));
    framebuffer_.bind(light.size_px, light.size_px);
    const float infinitely_far = 0.0F;
    glClearNamedFramebufferfv(framebuffer_.name(), GL_DEPTH, 0, &infinitely_far);
    const Mat4 clip = clip_from_world(light, views[layer], map.near_plane);
    for (const MeshDraw& draw : meshes_->shadow_draws()) {
      const Mat4 clip_from_object = clip * draw.world_from_object;
      if (!may_show(clip_from_object, draw.bounds)) continue;  // vertices are what a map costs without a GPU
      draw_program_.set("clip_from_object", clip_from_object);
      (draw.leaving ? glEnable : glDisable)(GL_CULL_FACE);
      // Right, up and axis of a view are right-handed where OpenGL's are not: the backs of triangles wind as its
      // fronts.
      glCullFace(glm::determinant(Mat3(draw.world_from_object)) < 0.0F ? GL_FRONT : GL_BACK);
      draw_mesh(drawing, draw);
    }
  }
  glDisable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glDepthFunc(GL_LESS);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  ++maps_drawn_;
  return map;
}

Result<const ShadowMaps::Map*> ShadowMaps::map_of(const ShadowLight& light) {
  for (const Map& map : maps_) {
    if (map.light == light) return &map;
  }
  LUM_TRY(Map drawn, draw_map(light));
  maps_.push_back(std::move(drawn));
  return &maps_.back();
}

void ShadowMaps::look_up(const DeepFramebuffer& deep, const Map& map, std::size_t slot) {
  const ShadowLight& light = map.light;
  const std::vector<Mat3> views = views_of(light);
  for (std::size_t i = 0; i < views.size(); ++i) {
    lookup_program_.set(("views[" + std::to_string(i) + "]").c_str(), views[i]);
  }
  const int taps = taps_of(light);
  for (int i = 0; i < taps; ++i) {
    lookup_program_.set(("disc[" + std::to_string(i) + "]").c_str(), vogel_disc(i, taps));
  }
  lookup_program_.set("taps", taps);
  lookup_program_.set("sample_count", static_cast<unsigned>(deep.sample_count()));
  lookup_program_.set("first", static_cast<unsigned>(slot * deep.sample_count()));
  lookup_program_.set("light_position", light.position);
  lookup_program_.set("cube", light.kind == ShadowKind::kCube ? 1 : 0);
  lookup_program_.set("sun", light.parallel() ? 1 : 0);
  lookup_program_.set("near_plane", map.near_plane);
  lookup_program_.set("extent", light.extent);
  lookup_program_.set("softness", light.softness);
  lookup_program_.set("texel", light.texel());
  map.depth.bind(0);
  deep.position().bind_storage(0);
  deep.normal().bind_storage(1);
  visibility_.bind_storage(2);
  meshes_->shadow_slack().bind_storage(3);
  lookup_program_.dispatch(*device_, deep.sample_count());
  lookups_ += static_cast<double>(deep.sample_count());
}

Result<void> ShadowMaps::make_room(const DeepFramebuffer& deep, std::size_t lights) {
  if (deep.id() != deep_id_) slots_.clear();
  deep_id_ = deep.id();
  const std::size_t row_bytes = deep.sample_count() * sizeof(float);
  if (visibility_.bytes() != lights * row_bytes) {
    const std::size_t kept = std::min(slots_.size(), lights);
    slots_.resize(kept);
    LUM_TRY(GlBuffer room, GlBuffer::create(*device_, BufferUse::kStorage, lights * row_bytes, "visibility"));
    room.copy_from(visibility_, 0, 0, kept * row_bytes);
    visibility_ = std::move(room);
  }
  slots_.resize(lights);
  return {};
}

Result<void> ShadowMaps::update(const DeepFramebuffer& deep, std::span<const ShadowLight> lights) {
  std::erase_if(maps_, [&](const Map& map) { return std::ranges::find(lights, map.light) == lights.end(); });
  LUM_TRY_VOID(make_room(deep, lights.size()));
  const std::size_t row_bytes = deep.sample_count() * sizeof(float);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (slots_[i] == lights[i]) continue;
    slots_[i].reset();
    const auto same = std::find(lights.begin(), lights.begin() + static_cast<std::ptrdiff_t>(i), lights[i]);
    const auto earlier = static_cast<std::size_t>(same - lights.begin());
    if (lights[i].kind == ShadowKind::kNone) {
      visibility_.fill(i * row_bytes, row_bytes, 1.0F);
    } else if (earlier < i) {
      visibility_.copy_from(visibility_, earlier * row_bytes, i * row_bytes, row_bytes);
    } else {
      LUM_TRY(const Map* map, map_of(lights[i]));
      look_up(deep, *map, i);
    }
    slots_[i] = lights[i];
  }
  return device_->check_errors("look up shadows");
}

}  // namespace luminist
