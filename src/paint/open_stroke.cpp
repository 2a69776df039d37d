// The part of a canvas that paints while the points of a stroke arrive.
#include "paint/open_stroke.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "paint/canvas.h"

namespace luminist {
namespace {

/// The part of a coverage inside a box that it contains.
Coverage part_of(const Coverage& coverage, const PixelBox& box) {
  Coverage part{box, {}};
  part.values.reserve(static_cast<std::size_t>(box.width()) * static_cast<std::size_t>(box.height()));
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) part.values.push_back(coverage.at(x, y));
  }
  return part;
}

/// Raises a coverage of the whole picture to the maximum of both.
void raise(Coverage& whole, const Coverage& part) {
  const auto row = static_cast<std::size_t>(whole.box.width());
  for (int y = part.box.y0; y < part.box.y1; ++y) {
    for (int x = part.box.x0; x < part.box.x1; ++x) {
      float& value = whole.values[static_cast<std::size_t>(y) * row + static_cast<std::size_t>(x)];
      value = std::max(value, part.at(x, y));
    }
  }
}

}  // namespace

Result<PixelBox> Canvas::begin_stroke(const Stroke& stroke, const std::string& folder) {
  LUM_CHECK(!open_, "one stroke at a time");
  LUM_CHECK(!stroke.brush.bucket, "a bucket is applied at once");
  LUM_TRY_VOID(check_stroke(stroke));
  LUM_TRY(ObjectMask mask, clip_mask(stroke, *surface_));
  LUM_TRY(std::shared_ptr<const Image> source, source_of(stroke.brush, folder));
  LUM_TRY_VOID(prepare_layer());
  const PlaneRefs planes = top();
  open_ = OpenStroke{stroke,
                     std::move(mask),
                     std::move(source),
                     {},
                     full_coverage(everywhere()),
                     {},
                     {*planes.color, *planes.left, *planes.stroke, *planes.importance},
                     state_.peak};
  std::fill(open_->coverage.values.begin(), open_->coverage.values.end(), 0.0F);
  ++state_.strokes;
  return lay_open(stroke.points);
}

Result<PixelBox> Canvas::extend_stroke(std::span<const StrokePoint> points) {
  LUM_CHECK(open_.has_value(), "a stroke has begun");
  if (points.empty()) return PixelBox{};
  Stroke more{open_->stroke.brush, {points.begin(), points.end()}};
  LUM_TRY_VOID(check_stroke(more));
  std::vector<StrokePoint>& all = open_->stroke.points;
  const bool click = all.size() == 1;  // its dab becomes the end of a segment
  more.points.insert(more.points.begin(), all.back());
  all.insert(all.end(), points.begin(), points.end());
  if (click) std::fill(open_->coverage.values.begin(), open_->coverage.values.end(), 0.0F);
  return lay_open(more.points);
}

/// Lays what these points, the last of the stroke, add to it.
Result<PixelBox> Canvas::lay_open(std::span<const StrokePoint> points) {
  OpenStroke& open = *open_;
  const Brush& brush = open.stroke.brush;
  const Coverage added = stroke_coverage(points, brush.diameter, surface_->width, surface_->height);
  raise(open.coverage, added);
  const bool all_anew = !open.gradient || brush.screen_gradient || open.stroke.points.size() <= points.size();
  open.reached = joined(open.reached, added.box);
  if (!open.gradient || brush.screen_gradient) {
    auto gradient = Gradient::create(open.stroke, *surface_, open.mask, open.peak);
    if (!gradient) return PixelBox{};  // it may still meet a surface
    open.gradient = std::move(*gradient);
    if (open.gradient->peak()) state_.peak = open.gradient->peak();
  }
  const PixelBox box = all_anew ? open.reached : added.box;
  const PlaneRefs planes = top();
  copy_box(refs(std::as_const(open.saved)), planes, box);
  const LaidStroke laid{&brush, state_.strokes, &open.mask, &*open.gradient, open.source.get()};
  lay(*surface_, laid, part_of(open.coverage, box), underlay(), planes);
  show(box);
  return box;
}

Result<void> Canvas::end_stroke() {
  LUM_CHECK(open_.has_value(), "a stroke has begun");
  OpenStroke open = std::move(*open_);
  open_.reset();
  if (open.gradient) {
    KeptStroke kept{std::move(open.stroke), {}, std::move(open.source)};
    if (repeats_peak(kept.stroke.brush)) kept.peak = open.peak;
    keep(std::move(kept));
    return {};
  }
  --state_.strokes;
  auto gradient = Gradient::create(open.stroke, *surface_, open.mask, open.peak);
  LUM_CHECK(!gradient.has_value(), "a gradient that can be made was made when its points came");
  return std::move(gradient).error();
}

}  // namespace luminist
