#pragma once
// render/renderer.h -- what painting and solving know of an engine. No GL here.
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/image.h"
#include "base/math.h"
#include "base/result.h"
#include "render/param_state.h"
#include "render/surface_buffer.h"
#include "render/target.h"

namespace luminist {

struct RenderOptions {
  bool shadows = true;
  /// Places in the rig of the lights that the caller turns from picture to picture; as for Renderer::error(). Without
  /// shadows nothing is kept.
  std::optional<std::span<const int>> moving = {};
};

/// A set of pixels that are evaluated again and again. Same id, same pixels: engines cache by it.
struct SampleSet {
  std::uint64_t id = 0;
  std::vector<std::uint32_t> pixels;  ///< linear indices; shaded at the pixel's centre
};

/// How far discontinuities are widened for a coarse level of the solver; zeros are the true picture.
struct Softness {
  float shadow_angle = 0.0F;  ///< least radius of the shadow filter, tangent of the angle seen from the light
  float light_edge = 0.0F;    ///< least softness of a light's own edges (barn), tangent of an angle
  float threshold = 0.0F;     ///< least half width of a style's thresholds, in their own unit
  int shadow_rays = 4;        ///< visibility queries per sample and light
};

/// One evaluation of a batch: the whole of shade(), or only what one light adds to it (styles with LightCombination::
/// kSum), or only what is left without lights.
struct Candidate {
  static constexpr int kAllLights = -1;
  static constexpr int kNoLights = -2;
  const ParamState* state = nullptr;
  int light = kAllLights;  ///< kAllLights: everything. kNoLights: emission and ambient. i >= 0: light i's term alone
};

/// Work done since the engine was made. One full picture of L lights on N pixels is N * L of each: a light that a
/// picture shades is counted with its shadow map and lookups, whether they were kept or made anew.
struct WorkCount {
  double shades = 0.0;          ///< a light shaded at a surface point
  double shadow_queries = 0.0;  ///< a visibility in a picture, or a ray
  double pictures = 0.0;        ///< full pictures
};

/// thread: the one that made the engine. Same parameters, same bits.
class Renderer {
 public:
  virtual ~Renderer() = default;
  Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  [[nodiscard]] virtual const SurfaceBuffer& surface() const = 0;
  [[nodiscard]] virtual SceneFrame frame() const = 0;
  [[nodiscard]] virtual const Style& style() const = 0;
  /// Whether pictures and samples are estimates, which differ by chance from what more of them would come to.
  [[nodiscard]] virtual bool estimates() const = 0;

  /// The picture: 3 channels, linear RGB, antialiased, not clamped. Background is black.
  /// errors kGl, kLimit; kStyle if more than 1 % of the pixels are not finite (fewer become 0).
  virtual Result<Image> render(const ParamState& state, const RenderOptions& options = {}) = 0;

  /// picture_error(render(state), target, style().metric) in one step; engines that sample may take fewer samples.
  virtual Result<double> error(const ParamState& state, const Target& target) = 0;

  /// The same up to the order of sums, for callers that turn only a few lights: `moving` are their places in the rig.
  /// Engines may keep what the others add from call to call and shade the moving lights alone; style, ambient and the
  /// other lights may still change, at the cost of a whole picture.
  virtual Result<double> error(const ParamState& state, const Target& target, std::span<const int> moving) {
    static_cast<void>(moving);
    return error(state, target);
  }

  /// The picture at some pixels, without some of the lights (places in the rig), blurred as the style's metric blurs.
  /// out [pixels.size()].
  /// Free of work right after an error() of the same state, or of the same lights that do not move. errors render()'s.
  virtual Result<void> colors_at(const ParamState& state, std::span<const int> without,
                                 std::span<const std::uint32_t> pixels, std::span<Vec3> out);

  /// Shades samples for a batch of candidates. out [candidates.size() x samples.pixels.size()], candidate-major.
  /// Light i of every candidate's rig has the same type as in the others. Where the style's metric blurs, its dots and
  /// strokes give way to their mean (pattern_fade() of shaders/lib/helpers.glsl): single samples of them are noise.
  /// cost one dispatch, one readback.
  virtual Result<void> evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                const Softness& softness, std::span<Vec3> out) = 0;

  [[nodiscard]] virtual const WorkCount& work() const = 0;
};

}  // namespace luminist
