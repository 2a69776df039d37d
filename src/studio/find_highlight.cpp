// Bright spots of a picture (studio/drag_goal.h).
#include <algorithm>
#include <cmath>

#include "studio/drag_goal.h"

namespace luminist {
namespace {

constexpr float kSearch = 0.08F;     // picture heights around the place that was grabbed
constexpr float kRing = 0.16F;       // picture heights: what lies about a highlight
constexpr float kLeastStand = 0.1F;  // of its brightness
constexpr float kLeastSize = 0.012F;
constexpr float kMostSize = 0.4F;

/// Means over a small square, so that no single pixel is a highlight; of pixels of one object only.
class Smooth {
 public:
  Smooth(const Image& picture, const SurfaceBuffer& surface, std::uint32_t object)
      : picture_(&picture), surface_(&surface), object_(object), radius_(std::max(1, surface.height / 160)) {}
  [[nodiscard]] bool on(int x, int y) const {
    return x >= 0 && y >= 0 && x < surface_->width && y < surface_->height &&
           surface_->object[surface_->index(x, y)] == object_;
  }
  /// The brightest pixel of the square.
  [[nodiscard]] Vec3 brightest(int x, int y) const {
    Vec3 most(0.0F);
    for (int v = y - radius_; v <= y + radius_; ++v) {
      for (int u = x - radius_; u <= x + radius_; ++u) {
        if (!on(u, v)) continue;
        const Vec3 color = picture_->rgb(surface_->index(u, v));
        if (brightness(color) > brightness(most)) most = color;
      }
    }
    return most;
  }
  [[nodiscard]] float at(int x, int y) const {
    float sum = 0.0F;
    int count = 0;
    for (int v = y - radius_; v <= y + radius_; ++v) {
      for (int u = x - radius_; u <= x + radius_; ++u) {
        if (!on(u, v)) continue;
        sum += brightness(picture_->rgb(surface_->index(u, v)));
        ++count;
      }
    }
    return count > 0 ? sum / static_cast<float>(count) : 0.0F;
  }

 private:
  const Image* picture_;
  const SurfaceBuffer* surface_;
  std::uint32_t object_;
  int radius_;
};

struct Pixel {
  int x = 0;
  int y = 0;
};

/// The connected pixels around the peak that are brighter than a threshold.
std::size_t count_bright(const Smooth& smooth, const SurfaceBuffer& surface, const Pixel& peak, float threshold) {
  std::vector<bool> seen(surface.pixels());
  std::vector<Pixel> open = {peak};
  std::size_t count = 0;
  while (!open.empty()) {
    const Pixel at = open.back();
    open.pop_back();
    if (!smooth.on(at.x, at.y) || seen[surface.index(at.x, at.y)] || smooth.at(at.x, at.y) < threshold) continue;
    seen[surface.index(at.x, at.y)] = true;
    ++count;
    for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) open.push_back({at.x + dx, at.y + dy});
  }
  return count;
}

/// What lies about a highlight, on its object.
struct About {
  float brightness = 0.0F;  ///< the median
  Vec3 light{0.0F};         ///< mean radiance over albedo, of the darker half
};
About about(const Image& picture, const SurfaceBuffer& surface, const Smooth& smooth, const Pixel& peak) {
  struct Seen {
    float brightness = 0.0F;
    Vec3 light{0.0F};
  };
  std::vector<Seen> ring;
  const float h = static_cast<float>(surface.height);
  for (int y = 0; y < surface.height; ++y) {
    for (int x = 0; x < surface.width; ++x) {
      const float distance = std::hypot(static_cast<float>(x - peak.x), static_cast<float>(y - peak.y)) / h;
      if (distance > kRing || distance < 0.25F * kRing || !smooth.on(x, y)) continue;
      const std::size_t pixel = surface.index(x, y);
      const Vec3 color = picture.rgb(pixel);
      ring.push_back({brightness(color), color / glm::max(surface.albedo[pixel], Vec3(0.02F))});
    }
  }
  About result;
  if (ring.empty()) return result;
  const auto middle = ring.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2);
  std::nth_element(ring.begin(), middle, ring.end(),
                   [](const Seen& a, const Seen& b) { return a.brightness < b.brightness; });
  result.brightness = middle->brightness;
  for (auto seen = ring.begin(); seen <= middle; ++seen) result.light += seen->light;
  result.light /= static_cast<float>(ring.size() / 2 + 1);
  return result;
}

Error no_highlight(const std::string& what, const std::string& hint) {
  return {ErrorKind::kNothingToDo, what, "", "from", hint};
}

}  // namespace

Result<Highlight> find_highlight(const Image& picture, const SurfaceBuffer& surface, const Vec2& near) {
  const float h = static_cast<float>(surface.height);
  const Pixel grabbed{static_cast<int>(std::floor(near.x * h)), static_cast<int>(std::floor(near.y * h))};
  const bool inside = grabbed.x >= 0 && grabbed.y >= 0 && grabbed.x < surface.width && grabbed.y < surface.height;
  const std::uint32_t object = inside ? surface.object[surface.index(grabbed.x, grabbed.y)] : 0;
  if (object == 0) return no_highlight("there is no surface here", "grab a highlight on an object");
  const Smooth smooth(picture, surface, object);
  const int reach = std::max(1, static_cast<int>(kSearch * h));
  Pixel peak = grabbed;
  float most = smooth.at(peak.x, peak.y);
  for (int y = grabbed.y - reach; y <= grabbed.y + reach; ++y) {
    for (int x = grabbed.x - reach; x <= grabbed.x + reach; ++x) {
      if (!smooth.on(x, y)) continue;
      const float value = smooth.at(x, y);
      if (value > most) most = value, peak = {x, y};
    }
  }
  const About rest = about(picture, surface, smooth, peak);
  if (!(most > 0.0F) || most - rest.brightness < kLeastStand * most) {
    return no_highlight("nothing stands out here", "grab a spot that is brighter than what lies about it");
  }
  const std::size_t bright = count_bright(smooth, surface, peak, 0.5F * (most + rest.brightness));
  const float diameter = 2.0F * std::sqrt(static_cast<float>(bright) / kPiF) / h;
  Highlight highlight;
  highlight.peak = Vec2((static_cast<float>(peak.x) + 0.5F) / h, (static_cast<float>(peak.y) + 0.5F) / h);
  highlight.diameter = std::clamp(diameter, kLeastSize, kMostSize);
  highlight.color = smooth.brightest(peak.x, peak.y);
  highlight.around = rest.light;
  return highlight;
}

}  // namespace luminist
