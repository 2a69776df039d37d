#include "render/renderer.h"

#include "base/check.h"
#include "render/metric.h"

namespace luminist {

Result<void> Renderer::colors_at(const ParamState& state, std::span<const int> without,
                                 std::span<const std::uint32_t> pixels, std::span<Vec3> out) {
  LUM_CHECK(pixels.size() == out.size(), "one colour per pixel");
  ParamState rest = state;
  for (const int light : without) rest.rig.lights[static_cast<std::size_t>(light)].muted = true;
  LUM_TRY(Image picture, render(rest));
  if (style().metric.blur > 0.0F) picture = as_compared(picture, style().metric);
  for (std::size_t i = 0; i < pixels.size(); ++i) out[i] = picture.rgb(pixels[i]);
  return {};
}

}  // namespace luminist
