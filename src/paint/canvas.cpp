#include "paint/canvas.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/check.h"
#include "base/files.h"
#include "image_io/image_io.h"

namespace luminist {
namespace {

Error bad_clip(std::string what, std::string hint) {
  return {ErrorKind::kBadContent, std::move(what), "", "clip", std::move(hint)};
}

Result<ObjectMask> clip_under(const StrokePoint& point, const SurfaceBuffer& surface) {
  const auto height = static_cast<float>(surface.height);
  const auto x = static_cast<int>(std::floor(point.x * height));
  const auto y = static_cast<int>(std::floor(point.y * height));
  const bool inside = x >= 0 && y >= 0 && x < surface.width && y < surface.height;
  const std::uint32_t object = inside ? surface.object[surface.index(x, y)] : 0;
  if (object == 0) return bad_clip("there is no object under the first point", "start the stroke on an object");
  ObjectMask mask(surface.object_names.size(), false);
  mask[object] = true;
  return mask;
}

ShadowPicture which_shadows(PaintTool tool) {
  return tool == PaintTool::kShadow ? ShadowPicture::kFreeLightsOff : ShadowPicture::kShadowsOff;
}

}  // namespace

Result<ObjectMask> clip_mask(const Stroke& stroke, const SurfaceBuffer& surface) {
  const std::string& clip = stroke.brush.clip;
  if (clip.empty()) return ObjectMask{};
  if (clip == "@") return clip_under(stroke.points.front(), surface);
  const std::vector<std::string>& names = surface.object_names;
  ObjectMask mask(names.size(), false);
  for (std::size_t id = 1; id < names.size(); ++id) mask[id] = names[id] == clip;
  if (std::find(mask.begin(), mask.end(), true) != mask.end()) return mask;
  const std::string near = names.empty() ? "" : nearest_name(clip, std::span(names).subspan(1));
  return bad_clip(fmt::format("there is no object \"{}\"", clip), near.empty()
                                                                      ? "\"@\" is the object under the first point"
                                                                      : fmt::format("did you mean \"{}\"?", near));
}

float CanvasState::importance_at(std::size_t pixel) const {
  const std::uint32_t number = target.stroke[pixel];
  if (!layers.counts.empty()) {
    if (const auto counts = layers.counts.find(number); counts != layers.counts.end()) {
      return importance.over(pixel, counts->second);
    }
  }
  return importance.at(pixel, number != 0);
}

Canvas::Canvas(const SurfaceBuffer& surface, Image picture, ShadowSource shadow_source)
    : Canvas(surface, std::move(picture), std::move(shadow_source),
             [](const std::string& path) { return read_image(path); }) {}

Canvas::Canvas(const SurfaceBuffer& surface, Image picture, ShadowSource shadow_source, ImageReader images)
    : surface_(&surface), shadow_source_(std::move(shadow_source)), images_(std::move(images)) {
  begin(std::move(picture));
}

void Canvas::begin(Image picture) {
  LUM_CHECK(picture.width == surface_->width && picture.height == surface_->height && picture.channels == 3,
            "picture and surface are of one shot");
  state_.target.before = picture;
  state_.target.color = std::move(picture);
  state_.target.importance = Image(surface_->width, surface_->height, 1);
  state_.target.stroke.assign(surface_->pixels(), 0);
  state_.paint_left = Image(surface_->width, surface_->height, 1);
  state_.importance.paint = Image();
  state_.strokes = 0;
  state_.peak.reset();
  state_.layers = LayerStack();
  work_.reset();
  shadow_pictures_ = std::make_shared<ShadowPictures>();
  refresh_importance(everywhere());
}

void Canvas::rebase(Image picture) {
  state_.importance.previous = std::move(state_.target.importance);
  begin(std::move(picture));
}

void Canvas::restore(CanvasState state) {
  LUM_CHECK(state.target.color.same_size(state_.target.color), "a state belongs to canvases of its size");
  if (state.target.before.data != state_.target.before.data) shadow_pictures_ = std::make_shared<ShadowPictures>();
  state_ = std::move(state);
  work_.reset();
  refresh_importance(everywhere());
}

bool Canvas::painted() const {
  return std::any_of(state_.target.stroke.begin(), state_.target.stroke.end(),
                     [](std::uint32_t id) { return id != 0; });
}

void Canvas::set_importance(float nu, float delta) {
  LUM_CHECK(nu >= 0.0F && nu <= 1.0F && delta >= 0.0F && delta <= 1.0F, "nu and delta are weights");
  // Whoever turns them means what is not painted, whatever a remedy has said of it before.
  if (nu != state_.importance.nu || delta != state_.importance.delta) state_.layers.counts.erase(0);
  state_.importance.nu = nu;
  state_.importance.delta = delta;
  refresh_importance(everywhere());
}

void Canvas::refresh_importance(const PixelBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t pixel = surface_->index(x, y);
      state_.target.importance.data[pixel] = state_.importance_at(pixel);
    }
  }
}

/// What a copying tool paints with; null for the others.
Result<std::shared_ptr<const Image>> Canvas::source_of(const Brush& brush, const std::string& folder) {
  if (brush.tool == PaintTool::kCopy) {
    LUM_TRY(Image copied, load_copy_source(brush.copy_from, folder, surface_->width, surface_->height, images_));
    return std::make_shared<const Image>(std::move(copied));
  }
  if (brush.tool != PaintTool::kShadow && brush.tool != PaintTool::kShadowEraser) return std::shared_ptr<const Image>();
  LUM_TRY_VOID(ready_shadows(brush.tool));
  return shadows_of(brush.tool);
}

std::shared_ptr<const Image>& Canvas::shadows_of(PaintTool tool) const {
  return (*shadow_pictures_)[static_cast<std::size_t>(which_shadows(tool))];
}

Result<void> Canvas::ready_shadows(PaintTool tool) {
  if (tool != PaintTool::kShadow && tool != PaintTool::kShadowEraser) return {};
  std::shared_ptr<const Image>& known = shadows_of(tool);
  if (!known) {
    LUM_CHECK(shadow_source_ != nullptr, "whoever lets shadows be painted renders what they copy from");
    LUM_TRY(Image picture, shadow_source_(which_shadows(tool)));
    LUM_CHECK(picture.same_size(state_.target.color), "it is rendered at the picture's size");
    known = std::make_shared<const Image>(std::move(picture));
  }
  return {};
}

Result<PixelBox> Canvas::apply(const Stroke& stroke, const std::string& folder) {
  LUM_TRY_VOID(check_stroke(stroke));
  LUM_TRY(const ObjectMask mask, clip_mask(stroke, *surface_));
  LUM_TRY(const Gradient gradient, Gradient::create(stroke, *surface_, mask, state_.peak));
  KeptStroke kept{stroke};
  LUM_TRY_VOID(complete(kept, folder));
  LUM_TRY_VOID(prepare_layer());
  // Nothing fails from here on.
  const Coverage coverage =
      stroke.brush.bucket ? full_coverage(everywhere())
                          : stroke_coverage(stroke.points, stroke.brush.diameter, surface_->width, surface_->height);
  ++state_.strokes;
  if (gradient.peak()) state_.peak = gradient.peak();
  lay(*surface_, {&stroke.brush, state_.strokes, &mask, &gradient, kept.source.get()}, coverage, underlay(), top());
  keep(std::move(kept));
  show(coverage.box);
  return coverage.box;
}

Result<void> Canvas::apply(const StrokeFile& file, const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  CanvasState before = state_;
  set_importance(file.nu, file.delta);
  for (std::size_t i = 0; i < file.strokes.size(); ++i) {
    auto applied = apply(file.strokes[i], folder);
    if (applied) continue;
    state_ = std::move(before);
    work_.reset();
    Error error = std::move(applied).error();
    if (error.where.empty()) error.where = path;
    error.field = error.field.empty() ? fmt::format("strokes[{}]", i) : fmt::format("strokes[{}].{}", i, error.field);
    return error;
  }
  return {};
}

}  // namespace luminist
