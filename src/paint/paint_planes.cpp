#include "paint/paint_planes.h"

#include <algorithm>

#include "paint/compositing.h"
#include "paint/copy_source.h"
#include "paint/importance.h"

namespace luminist {
namespace {

template <class T>
void copy_rows(const std::vector<T>& from, std::vector<T>& to, const PixelBox& box, int width, int channels) {
  for (int y = box.y0; y < box.y1; ++y) {
    const auto start = (static_cast<std::ptrdiff_t>(y) * width + box.x0) * channels;
    const auto count = static_cast<std::ptrdiff_t>(box.width()) * channels;
    std::copy_n(from.begin() + start, count, to.begin() + start);
  }
}

/// below may be empty: nothing there, zeros.
void mix_rows(const Image& below, Image& to, float opacity, const PixelBox& box) {
  const auto channels = static_cast<std::size_t>(to.channels);
  for (int y = box.y0; y < box.y1; ++y) {
    const std::size_t first = to.index(box.x0, y) * channels;
    const std::size_t count = static_cast<std::size_t>(box.width()) * channels;
    for (std::size_t i = first; i < first + count; ++i) {
      const float under = below.empty() ? 0.0F : below.data[i];
      to.data[i] = under + opacity * (to.data[i] - under);
    }
  }
}

void paint_pixel(const LaidStroke& stroke, const Vec3& albedo, std::size_t pixel, const Dose& dose,
                 const Underlay& under, const PlaneRefs& planes) {
  const Brush& brush = *stroke.brush;
  if (brush.tool == PaintTool::kImportance) {
    put_importance(*planes.importance, pixel, brush.importance, dose.amount);
    return;
  }
  planes.color->set_rgb(pixel, composited(brush, planes.color->rgb(pixel), albedo, dose));
  float& left = planes.left->data[pixel];
  if (brush.tool == PaintTool::kErase) {
    left *= 1.0F - dose.amount;
    if (left < kPaintEdge) (*planes.stroke)[pixel] = under.stroke != nullptr ? (*under.stroke)[pixel] : 0;
    if (!planes.importance->empty()) erase_importance(*planes.importance, pixel, dose.amount, under.importance);
  } else if (dose.coverage * dose.source.w >= kPaintEdge) {
    left = 1.0F;
    (*planes.stroke)[pixel] = stroke.number;
  }
}

}  // namespace

PlaneRefs refs(PaintPlanes& planes) {
  return {&planes.color, &planes.left, &planes.stroke, &planes.importance};
}
ConstPlaneRefs refs(const PaintPlanes& planes) {
  return {&planes.color, &planes.left, &planes.stroke, &planes.importance};
}
ConstPlaneRefs refs(const PlaneRefs& planes) {
  return {planes.color, planes.left, planes.stroke, planes.importance};
}

void copy_box(const ConstPlaneRefs& from, const PlaneRefs& to, const PixelBox& box) {
  const int width = from.color->width;
  copy_rows(from.color->data, to.color->data, box, width, 3);
  copy_rows(from.left->data, to.left->data, box, width, 1);
  copy_rows(*from.stroke, *to.stroke, box, width, 1);
  if (from.importance->empty() && to.importance->empty()) return;
  if (to.importance->empty()) *to.importance = Image(width, from.color->height, 2);
  if (!from.importance->empty()) return copy_rows(from.importance->data, to.importance->data, box, width, 2);
  const Image none(width, from.color->height, 2);
  copy_rows(none.data, to.importance->data, box, width, 2);
}

void mix_box(const ConstPlaneRefs& below, const PlaneRefs& to, float opacity, const PixelBox& box) {
  mix_rows(*below.color, *to.color, opacity, box);
  if (!to.importance->empty()) mix_rows(*below.importance, *to.importance, opacity, box);
}

void raise_left(const PaintPlanes& below, const PlaneRefs& to, const PixelBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t pixel = below.left.index(x, y);
      to.left->data[pixel] = std::max(to.left->data[pixel], below.left.data[pixel]);
    }
  }
}

void lay(const SurfaceBuffer& surface, const LaidStroke& stroke, const Coverage& coverage, const Underlay& under,
         const PlaneRefs& planes) {
  const Brush& brush = *stroke.brush;
  if (brush.tool == PaintTool::kImportance && planes.importance->empty()) {
    *planes.importance = Image(surface.width, surface.height, 2);
  }
  const Image* source = brush.tool == PaintTool::kErase ? under.color : stroke.source;
  const ObjectMask& mask = *stroke.mask;
  const bool thins = fades_amount(brush);
  for (int y = coverage.box.y0; y < coverage.box.y1; ++y) {
    for (int x = coverage.box.x0; x < coverage.box.x1; ++x) {
      const std::size_t pixel = surface.index(x, y);
      const float covered = coverage.at(x, y);
      if (covered <= 0.0F || (!mask.empty() && !mask[surface.object[pixel]])) continue;
      const float fade = stroke.gradient->factor(surface, x, y);
      Dose dose;
      dose.coverage = thins ? covered * fade : covered;
      dose.amount = brush.opacity * dose.coverage;
      dose.shading = thins ? 1.0F : fade;
      if (source != nullptr) dose.source = source_pixel(*source, pixel);
      if (dose.amount > 0.0F) paint_pixel(stroke, surface.albedo[pixel], pixel, dose, under, planes);
    }
  }
}

}  // namespace luminist
