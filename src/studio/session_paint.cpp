// The part of a session that paints.
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "project/paint_document.h"
#include "studio/session.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

std::string count_of(std::size_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// Three channels: grey is spread, alpha is left out.
Result<Image> as_color(const Image& image) {
  if (image.channels < 1 || image.channels > 4) {
    return Error{ErrorKind::kBadContent, fmt::format("a picture has 1 to 4 channels, not {}", image.channels), "",
                 "target", ""};
  }
  const bool grey = image.channels < 3;
  Image color(image.width, image.height, 3);
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    const float* from = &image.data[pixel * static_cast<std::size_t>(image.channels)];
    color.set_rgb(pixel, grey ? Vec3(from[0]) : Vec3(from[0], from[1], from[2]));
  }
  return color;
}

Image first_channel(const Image& image) {
  Image result(image.width, image.height, 1);
  for (std::size_t pixel = 0; pixel < image.pixels(); ++pixel) {
    result.data[pixel] = image.data[pixel * static_cast<std::size_t>(image.channels)];
  }
  return result;
}

Image fitted(Image image, const Shot& shot, const char* field, Diagnostics& diagnostics) {
  if (image.width == shot.width && image.height == shot.height) return image;
  diagnostics.warn(field, fmt::format("{} x {} pixels are scaled to the picture's {} x {}", image.width, image.height,
                                      shot.width, shot.height));
  return resized(image, shot.width, shot.height);
}

}  // namespace

Result<Canvas*> Session::canvas() {
  if (canvas_) return &*canvas_;
  LUM_TRY(Image picture, stage_->renderer->render(state_));
  Canvas canvas(stage_->renderer->surface(), std::move(picture),
                [this](ShadowPicture which) { return render_shadow_picture(*stage_->renderer, state_, which); });
  LUM_TRY(CanvasState painted, read_paint(project_.document(), project_.tiles(), canvas.state()));
  canvas.restore(std::move(painted));
  const LayerStack& layers = canvas.state().layers;
  canvas.choose_layer(layers.find_layer(layer_).value_or(layers.layers.size() - 1));
  canvas_ = std::move(canvas);
  return &*canvas_;
}

Result<Canvas> Session::canvas_copy() {
  LUM_TRY(const Canvas* canvas, this->canvas());
  Canvas copy(stage_->renderer->surface(), canvas->target().before, [this, lights = state_](ShadowPicture which) {
    return render_shadow_picture(*stage_->renderer, lights, which);
  });
  copy.restore(canvas->state());
  copy.share_shadows(*canvas);
  return copy;
}

Result<const Target*> Session::target() {
  LUM_TRY(const Canvas* canvas, this->canvas());
  return &canvas->target();
}

/// Records a canvas that was changed in place; after an error it is made again from the document.
Result<void> Session::commit_canvas(const std::string& label, const std::string& action, const CanvasState& next) {
  Document document = project_.document();
  auto committed = write_paint(next, document, project_.tiles());
  if (committed) committed = commit(label, action, document);
  if (!committed || next.strokes == 0) canvas_.reset();  // unpainted, it shows the picture as it is now
  return committed;
}

Result<void> Session::paint(const StrokeFile& strokes, const std::string& path) {
  if (strokes.strokes.empty()) {
    return Error{ErrorKind::kNothingToDo, "there are no strokes", path, "strokes", "paint the light that you want"};
  }
  LUM_TRY(Canvas * canvas, this->canvas());
  LUM_TRY_VOID(canvas->apply(strokes, path));
  const LayerStack& layers = canvas->state().layers;
  Json action = {{"do", "paint"}, {"strokes", Json::parse(strokes_to_json(strokes))}, {"path", path}};
  if (layers.layers.size() > 1) action["layer"] = layers.layers[layers.active].name;
  return commit_canvas("Paint " + count_of(strokes.strokes.size(), "stroke"), action.dump(), canvas->state());
}

Result<void> Session::set_importance(float nu, float delta) {
  if (!(nu >= 0.0F && nu <= 1.0F && delta >= 0.0F && delta <= 1.0F)) {
    return Error{ErrorKind::kUsage, "nu and delta lie between 0 and 1", "", nu >= 0.0F && nu <= 1.0F ? "delta" : "nu",
                 ""};
  }
  LUM_TRY(Canvas * canvas, this->canvas());
  canvas->set_importance(nu, delta);
  return commit_canvas(fmt::format("Importance nu {:g}, delta {:g}", nu, delta),
                       Json{{"do", "importance"}, {"nu", nu}, {"delta", delta}}.dump(), canvas->state());
}

Result<void> Session::set_target(const Image& color, const std::optional<Image>& importance) {
  LUM_TRY(Canvas * canvas, this->canvas());
  CanvasState next = canvas->state();
  LUM_TRY(Image rgb, as_color(color));
  next.target.color = fitted(std::move(rgb), shot_, "target", *diagnostics_);
  next.target.importance = importance ? fitted(first_channel(*importance), shot_, "importance", *diagnostics_)
                                      : Image(shot_.width, shot_.height, 1, 1.0F);
  const SanitizeReport report = sanitize(next.target);
  if (report.masked > 0) {
    diagnostics_->warn("target",
                       fmt::format("{} not finite or of negative importance and count nothing; the first is "
                                   "({}, {})",
                                   report.masked == 1 ? "1 pixel is" : fmt::format("{} pixels are", report.masked),
                                   report.first_x, report.first_y));
  }
  // All of it counts as painted, its importance as painted over everything.
  next.strokes = 1;
  next.peak.reset();
  std::fill(next.target.stroke.begin(), next.target.stroke.end(), 1U);
  std::fill(next.paint_left.data.begin(), next.paint_left.data.end(), 1.0F);
  next.importance.paint = Image(shot_.width, shot_.height, 2, 1.0F);
  for (std::size_t pixel = 0; pixel < next.target.importance.pixels(); ++pixel) {
    next.importance.paint.data[2 * pixel] = next.target.importance.data[pixel];
  }
  next.layers = LayerStack();
  next.layers.ground = std::make_shared<const PaintPlanes>(
      PaintPlanes{next.target.color, next.paint_left, next.target.stroke, next.importance.paint});
  const Json action = {{"do", "target"}};
  canvas->restore(next);
  return commit_canvas("Take a picture as target", action.dump(), next);
}

Result<void> Session::clear_paint() {
  if (!painted()) return Error{ErrorKind::kNothingToDo, "nothing is painted", "", "", ""};
  LUM_TRY(const Canvas* canvas, this->canvas());
  CanvasState next = canvas->state();
  next.strokes = 0;
  next.peak.reset();
  next.layers = LayerStack();
  return commit_canvas("Clear the paint", Json{{"do", "clear_paint"}}.dump(), next);
}

}  // namespace luminist
