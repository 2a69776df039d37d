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
#include "paint/compositing.h"

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
  forget_shadow_pair();
  refresh_importance(everywhere());
}

void Canvas::rebase(Image picture) {
  state_.importance.previous = std::move(state_.target.importance);
  begin(std::move(picture));
}

void Canvas::restore(CanvasState state) {
  LUM_CHECK(state.target.color.same_size(state_.target.color), "a state belongs to canvases of its size");
  if (state.target.before.data != state_.target.before.data) forget_shadow_pair();
  state_ = std::move(state);
  refresh_importance(everywhere());
}

bool Canvas::painted() const {
  return std::any_of(state_.target.stroke.begin(), state_.target.stroke.end(),
                     [](std::uint32_t id) { return id != 0; });
}

void Canvas::set_importance(float nu, float delta) {
  LUM_CHECK(nu >= 0.0F && nu <= 1.0F && delta >= 0.0F && delta <= 1.0F, "nu and delta are weights");
  state_.importance.nu = nu;
  state_.importance.delta = delta;
  refresh_importance(everywhere());
}

void Canvas::refresh_importance(const PixelBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t pixel = surface_->index(x, y);
      state_.target.importance.data[pixel] = state_.importance.at(pixel, state_.target.stroke[pixel] != 0);
    }
  }
}

Result<const ShadowPair*> Canvas::shadow_pair() {
  if (!shadow_pair_) {
    LUM_CHECK(shadow_source_ != nullptr, "whoever lets shadows be painted renders the pair");
    LUM_TRY(ShadowPair pair, shadow_source_());
    LUM_CHECK(pair.free_lights_off.same_size(state_.target.color) && pair.shadows_off.same_size(state_.target.color),
              "the pair is rendered at the picture's size");
    shadow_pair_ = std::make_shared<const ShadowPair>(std::move(pair));
  }
  return shadow_pair_.get();
}

/// The image that a copying tool paints with, null for the others; copied keeps it if it was read.
Result<const Image*> Canvas::source_of(const Brush& brush, const std::string& folder, Image& copied) {
  switch (brush.tool) {
    case PaintTool::kShadow: {
      LUM_TRY(const ShadowPair* pair, shadow_pair());
      return &pair->free_lights_off;
    }
    case PaintTool::kShadowEraser: {
      LUM_TRY(const ShadowPair* pair, shadow_pair());
      return &pair->shadows_off;
    }
    case PaintTool::kErase:
      return &state_.target.before;
    case PaintTool::kCopy: {
      LUM_TRY(copied, load_copy_source(brush.copy_from, folder, surface_->width, surface_->height, images_));
      return &copied;
    }
    default:
      return nullptr;
  }
}

Result<PixelBox> Canvas::apply(const Stroke& stroke, const std::string& folder) {
  const Brush& brush = stroke.brush;
  LUM_TRY_VOID(check_stroke(stroke));
  LUM_TRY(const ObjectMask mask, clip_mask(stroke, *surface_));
  LUM_TRY(const Gradient gradient, Gradient::create(stroke, *surface_, mask, state_.peak));
  Image copied;
  LUM_TRY(const Image* source, source_of(brush, folder, copied));
  // Nothing fails from here on.
  const Coverage coverage = brush.bucket
                                ? full_coverage(surface_->width, surface_->height)
                                : stroke_coverage(stroke.points, brush.diameter, surface_->width, surface_->height);
  ++state_.strokes;
  if (gradient.peak()) state_.peak = gradient.peak();
  lay(brush, coverage, mask, gradient, source);
  refresh_importance(coverage.box);
  return coverage.box;
}

void Canvas::lay(const Brush& brush, const Coverage& coverage, const ObjectMask& mask, const Gradient& gradient,
                 const Image* source) {
  Image& importance_paint = state_.importance.paint;
  if (brush.tool == PaintTool::kImportance && importance_paint.empty()) {
    importance_paint = Image(surface_->width, surface_->height, 2);
  }
  const bool thins = fades_amount(brush);
  for (int y = coverage.box.y0; y < coverage.box.y1; ++y) {
    for (int x = coverage.box.x0; x < coverage.box.x1; ++x) {
      const std::size_t pixel = surface_->index(x, y);
      const float covered = coverage.at(x, y);
      if (covered <= 0.0F || (!mask.empty() && !mask[surface_->object[pixel]])) continue;
      const float fade = gradient.factor(*surface_, x, y);
      Dose dose;
      dose.coverage = thins ? covered * fade : covered;
      dose.amount = brush.opacity * dose.coverage;
      dose.shading = thins ? 1.0F : fade;
      if (source != nullptr) dose.source = source_pixel(*source, pixel);
      if (dose.amount > 0.0F) paint_pixel(brush, pixel, dose);
    }
  }
}

void Canvas::paint_pixel(const Brush& brush, std::size_t pixel, const Dose& dose) {
  if (brush.tool == PaintTool::kImportance) {
    state_.importance.put(pixel, brush.importance, dose.amount);
    return;
  }
  Target& target = state_.target;
  target.color.set_rgb(pixel, composited(brush, target.color.rgb(pixel), surface_->albedo[pixel], dose));
  float& left = state_.paint_left.data[pixel];
  if (brush.tool == PaintTool::kErase) {
    left *= 1.0F - dose.amount;
    if (left < kPaintEdge) target.stroke[pixel] = 0;
    if (!state_.importance.paint.empty()) state_.importance.erase(pixel, dose.amount);
  } else if (dose.coverage * dose.source.w >= kPaintEdge) {
    left = 1.0F;
    target.stroke[pixel] = state_.strokes;
  }
}

Result<void> Canvas::apply(const StrokeFile& file, const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  CanvasState before = state_;
  set_importance(file.nu, file.delta);
  for (std::size_t i = 0; i < file.strokes.size(); ++i) {
    auto applied = apply(file.strokes[i], folder);
    if (applied) continue;
    state_ = std::move(before);
    Error error = std::move(applied).error();
    if (error.where.empty()) error.where = path;
    error.field = error.field.empty() ? fmt::format("strokes[{}]", i) : fmt::format("strokes[{}].{}", i, error.field);
    return error;
  }
  return {};
}

}  // namespace luminist
