#include "studio/drag_goal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "studio/paint_layers.h"

namespace luminist {
namespace {

constexpr float kShadowBrush = 0.09F;  // picture heights
constexpr float kInShadow = 0.6F;      // of what the lights would do without shadows

/// The pixel of a place. errors kNothingToDo if nothing is seen there.
Result<std::size_t> pixel_at(const SurfaceBuffer& surface, const Vec2& place, const char* field) {
  const float h = static_cast<float>(surface.height);
  const int x = static_cast<int>(std::floor(place.x * h));
  const int y = static_cast<int>(std::floor(place.y * h));
  if (x >= 0 && y >= 0 && x < surface.width && y < surface.height && surface.object[surface.index(x, y)] != 0) {
    return surface.index(x, y);
  }
  return Error{ErrorKind::kNothingToDo, fmt::format("there is no surface at {:.3f},{:.3f}", place.x, place.y), "",
               field, "drag over what is seen of the objects"};
}

/// No strokes, what is not painted counts as it does.
StrokeFile as_before(const Document& document) {
  StrokeFile file;
  const auto read = [&](std::string_view path, float& number) {
    const std::string_view text = document.get(path);
    std::from_chars(text.data(), text.data() + text.size(), number);
  };
  read("paint/nu", file.nu);
  read("paint/delta", file.delta);
  return file;
}

/// Where shadows lie: the picture with and without them.
class Shadows {
 public:
  static Result<Shadows> see(Session& session) {
    Shadows shadows;
    shadows.surface_ = &session.stage().renderer->surface();
    Renderer& renderer = *session.stage().renderer;
    LUM_TRY(shadows.lit_, renderer.render(session.shown()));
    LUM_TRY(shadows.bare_, renderer.render(session.shown(), RenderOptions{.shadows = false}));
    return shadows;
  }
  [[nodiscard]] bool at(const Vec2& place) const {
    const auto pixel = pixel_at(*surface_, place, "");
    return pixel && brightness(lit_.rgb(*pixel)) < kInShadow * brightness(bare_.rgb(*pixel));
  }
  /// So far around it, too.
  [[nodiscard]] bool all_around(const Vec2& place, float radius) const {
    for (int i = 0; i < 8; ++i) {
      const float angle = 0.785398F * static_cast<float>(i);
      if (!at(place + radius * Vec2(std::cos(angle), std::sin(angle)))) return false;
    }
    return at(place);
  }

 private:
  const SurfaceBuffer* surface_ = nullptr;
  Image lit_;
  Image bare_;
};

Stroke shadow_stroke(PaintTool tool, const Vec2& from, const Vec2& to) {
  Stroke stroke;
  stroke.brush.tool = tool;
  stroke.brush.diameter = kShadowBrush;
  stroke.points = {{from.x, from.y}, {to.x, to.y}};
  return stroke;
}

Result<std::vector<Stroke>> shadow_strokes(Session& session, const Drag& drag) {
  LUM_TRY(const Shadows shadows, Shadows::see(session));
  if (shadows.all_around(drag.from, 0.5F * kShadowBrush)) {
    return std::vector{shadow_stroke(PaintTool::kShadowEraser, drag.from, drag.from),
                       shadow_stroke(PaintTool::kShadow, drag.to, drag.to)};
  }
  const bool shrinks = shadows.at(drag.to);
  return std::vector{shadow_stroke(shrinks ? PaintTool::kShadowEraser : PaintTool::kShadow, drag.from, drag.to)};
}

std::vector<Stroke> highlight_strokes(const Highlight& highlight, const Vec2& to) {
  constexpr float kWider = 1.7F;  // a dab fades out towards its rim
  Stroke gone;
  gone.brush.color = glm::min(highlight.around, Vec3(kBrightest));
  gone.brush.diameter = kWider * highlight.diameter;
  gone.brush.clip = "@";
  gone.points = {{highlight.peak.x, highlight.peak.y}};
  Stroke there;
  there.brush.color = glm::min(highlight.color, Vec3(kBrightest));
  there.brush.texture = 0.0F;  // what is mirrored has not the colour of the surface
  there.brush.gradient = 1.0F;
  there.brush.peak = PeakKind::kSpecular;
  there.brush.add_light = true;
  there.brush.diameter = kWider * highlight.diameter;
  there.brush.clip = "@";
  there.points = {{to.x, to.y}};
  return {gone, there};
}

/// The lights as they are, of which only this one's place and direction are free.
ParamState freed(const ParamState& state, const std::string& name) {
  ParamState next = state;
  for (ParamBlock* block : next.blocks()) block->set_param_locked(-1, true);
  ParamBlock& light = next.rig.find(name)->params;
  for (const char* role : {"position", "direction"}) {
    if (const auto param = light.schema().by_role(role)) light.set_param_locked(*param, false);
  }
  return next;
}

/// The light moved to where it would be seen mirrored, or straight above, at the place that was asked for.
ParamState placed(const ParamState& state, const std::string& name, const SurfaceBuffer& surface, std::size_t from,
                  std::size_t to, bool mirrored) {
  ParamState next = state;
  ParamBlock& light = next.rig.find(name)->params;
  const auto position = light.schema().by_role("position");
  const auto direction = light.schema().by_role("direction");
  const Vec3 point = surface.position[to];
  const Vec3 normal = surface.normal[to];
  const Vec3 eye = unit_direction(surface.eye - point).value_or(normal);
  const Vec3 way = mirrored ? 2.0F * glm::dot(eye, normal) * normal - eye : normal;
  if (position) {
    const float distance = glm::length(light.vec3(*position) - surface.position[from]);
    light.set_vec3(*position, point + distance * way);
  }
  if (direction) light.set_vec3(*direction, -way);
  keep_constraints(next.rig);
  return next;
}

/// A light that moves changes the whole picture, which was not asked to stay: little counts but the last strokes.
Target goal_alone(const Target& painted, std::size_t strokes) {
  constexpr float kRest = 0.005F;
  Target goal = painted;
  const std::uint32_t last = *std::max_element(goal.stroke.begin(), goal.stroke.end());
  for (std::size_t i = 0; i < goal.stroke.size(); ++i) {
    if (goal.stroke[i] + strokes <= last || goal.stroke[i] == 0) goal.importance.data[i] *= kRest;
  }
  return goal;
}

Result<ParamState> nearest_start(Session& session, const ParamState& lights, const Drag& drag, const std::string& name,
                                 std::size_t strokes) {
  Renderer& renderer = *session.stage().renderer;
  LUM_TRY(const Target* painted, session.target());
  const Target goal = goal_alone(*painted, strokes);
  LUM_TRY(const std::size_t from, pixel_at(renderer.surface(), drag.from, "from"));
  LUM_TRY(const std::size_t to, pixel_at(renderer.surface(), drag.to, "to"));
  ParamState best = lights;
  LUM_TRY(double least, renderer.error(lights, goal));
  for (const bool mirrored : {true, false}) {
    ParamState moved = placed(lights, name, renderer.surface(), from, to, mirrored);
    LUM_TRY(const double error, renderer.error(moved, goal));
    if (error < least) least = error, best = std::move(moved);
  }
  return best;
}

/// A place that is brighter than what lies about it.
struct Spot {
  Vec2 place{0.0F};  ///< picture heights
  float brightness = 0.0F;
};

/// The peaks of a picture on one object, each a mean of a small square, so that no single pixel is one.
std::vector<Spot> peaks_of(const Image& picture, const SurfaceBuffer& surface, std::uint32_t object) {
  const int reach = std::max(1, surface.height / 160);
  const int apart = 3 * reach;
  Image mean(surface.width, surface.height, 1);
  for (int y = reach; y < surface.height - reach; ++y) {
    for (int x = reach; x < surface.width - reach; ++x) {
      if (surface.object[surface.index(x, y)] != object) continue;
      float& sum = mean.data[surface.index(x, y)];
      for (int v = y - reach; v <= y + reach; ++v) {
        for (int u = x - reach; u <= x + reach; ++u) {
          const std::size_t pixel = surface.index(u, v);
          if (surface.object[pixel] == object) sum += brightness(picture.rgb(pixel));
        }
      }
    }
  }
  std::vector<Spot> peaks;
  for (int y = apart; y < surface.height - apart; ++y) {
    for (int x = apart; x < surface.width - apart; ++x) {
      const float value = mean.data[surface.index(x, y)];
      bool highest = value > 0.0F;
      for (int v = y - apart; v <= y + apart && highest; ++v) {
        for (int u = x - apart; u <= x + apart && highest; ++u) highest = mean.data[surface.index(u, v)] <= value;
      }
      if (highest) {
        peaks.push_back(
            {Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) / static_cast<float>(surface.height),
             value});
      }
    }
  }
  return peaks;
}

}  // namespace

Result<StrokeFile> drag_strokes(Session& session, const Drag& drag) {
  const SurfaceBuffer& surface = session.stage().renderer->surface();
  LUM_TRY_VOID(pixel_at(surface, drag.from, "from"));
  LUM_TRY_VOID(pixel_at(surface, drag.to, "to"));
  StrokeFile file = as_before(session.project().document());
  if (drag.what == Drag::What::kShadow) {
    LUM_TRY(file.strokes, shadow_strokes(session, drag));
    return file;
  }
  LUM_TRY(const Image* picture, session.picture());
  LUM_TRY(const Highlight highlight, find_highlight(*picture, surface, drag.from));
  file.strokes = highlight_strokes(highlight, drag.to);
  return file;
}

Result<std::string> dragged_light(Session& session, const Drag& drag, const std::function<bool()>& go_on) {
  const ParamState& state = session.shown();
  if (!drag.light.empty()) {
    if (state.rig.find(drag.light) != nullptr) return drag.light;
    return Error{ErrorKind::kUsage, fmt::format("there is no light \"{}\"", drag.light), "", "light", ""};
  }
  Renderer& renderer = *session.stage().renderer;
  LUM_TRY(const std::size_t pixel, pixel_at(renderer.surface(), drag.from, "from"));
  const RenderOptions options{.shadows = drag.what == Drag::What::kHighlight};
  LUM_TRY(const Image all, renderer.render(state, options));
  std::string name;
  float most = 1e-5F;
  for (std::size_t i = 0; i < state.rig.lights.size(); ++i) {
    if (state.rig.lights[i].muted) continue;
    if (go_on && !go_on()) return Error{ErrorKind::kCancelled, "the drag was cancelled", "", "", ""};
    ParamState without = state;
    without.rig.lights[i].muted = true;
    LUM_TRY(const Image rest, renderer.render(without, options));
    const float adds = brightness(all.rgb(pixel) - rest.rgb(pixel));
    if (adds > most) most = adds, name = state.rig.lights[i].name;
  }
  if (!name.empty()) return name;
  return Error{ErrorKind::kNothingToDo, "no light shines here", "", "from", "add a light, or name one"};
}

Result<std::string> start_drag(Session& session, const Drag& drag, const SolveOptions& options,
                               const std::function<bool()>& go_on) {
  LUM_TRY(const std::string name, dragged_light(session, drag, go_on));
  LUM_TRY(const StrokeFile strokes, drag_strokes(session, drag));
  LUM_TRY(const LayerStack layers, session.layers().stack());
  LUM_TRY_VOID(check_paintable(layers));
  if (session.has_proposal()) LUM_TRY_VOID(session.adopt());
  LUM_TRY_VOID(session.paint(strokes, "strokes"));
  ParamState start = freed(session.state(), name);
  if (drag.what == Drag::What::kHighlight) {
    LUM_TRY(start, nearest_start(session, start, drag, name, strokes.strokes.size()));
  }
  LUM_TRY(const Target* painted, session.target());
  LUM_TRY_VOID(session.start_solve(
      std::move(start), goal_alone(*painted, strokes.strokes.size()), options,
      drag.what == Drag::What::kHighlight ? "Drag the highlight of " + name : "Drag the shadow of " + name));
  return name;
}

Result<DragOutcome> highlight_outcome(Session& session, const Drag& drag, const std::string& light) {
  Renderer& renderer = *session.stage().renderer;
  const SurfaceBuffer& surface = renderer.surface();
  LUM_TRY(const std::size_t to, pixel_at(surface, drag.to, "to"));
  ParamState without = session.shown();
  for (Light& each : without.rig.lights) each.muted = each.muted || each.name == light;
  LUM_TRY(Image added, renderer.render(session.shown()));
  LUM_TRY(const Image rest, renderer.render(without));
  for (std::size_t i = 0; i < added.data.size(); ++i) added.data[i] = std::max(0.0F, added.data[i] - rest.data[i]);
  const std::vector<Spot> peaks = peaks_of(added, surface, surface.object[to]);
  float most = 0.0F;
  for (const Spot& peak : peaks) most = std::max(most, peak.brightness);
  DragOutcome outcome;
  outcome.distance = std::numeric_limits<float>::infinity();
  for (const Spot& peak : peaks) {
    const float distance = glm::length(peak.place - drag.to);
    if (peak.brightness >= 0.5F * most && distance < outcome.distance) outcome = {peak.place, distance};
  }
  float brightest = 0.0F;
  for (std::size_t i = 0; i < surface.pixels(); ++i) {
    if (surface.object[i] == surface.object[to]) brightest = std::max(brightest, brightness(added.rgb(i)));
  }
  outcome.reaches = brightest > 0.0F ? brightness(added.rgb(to)) / brightest : 0.0F;
  if (!(most > 0.0F)) {
    return Error{ErrorKind::kNothingToDo, fmt::format("\"{}\" adds nothing there", light), "", "light", ""};
  }
  return outcome;
}

}  // namespace luminist
