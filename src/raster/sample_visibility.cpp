#include "raster/sample_visibility.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>

#include "base/check.h"

namespace luminist {

SampleVisibility::SampleVisibility(const RayScene& rays, const SurfaceBuffer& surface, std::size_t budget_values)
    : rays_(&rays), surface_(&surface), budget_(budget_values) {}

Vec2 sample_disc(std::uint32_t sample, int ray, int rays) {
  // Multiples of 1/p and 1/p^2, p^3 = p + 1, in fixed point: the wrap of the integers is the fraction.
  const std::uint32_t index = sample * static_cast<std::uint32_t>(rays) + static_cast<std::uint32_t>(ray);
  const auto fraction = [](std::uint32_t fixed) { return static_cast<float>(fixed >> 8) * 0x1p-24F; };
  const float radius = std::sqrt(fraction(index * 3242174889U + 0x80000000U));
  const float angle = 2.0F * static_cast<float>(kPi) * fraction(index * 2447445414U);
  return radius * Vec2(std::cos(angle), std::sin(angle));
}

std::size_t SampleVisibility::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = key.samples + static_cast<std::uint64_t>(key.rays);
  const auto mix = [&hash](std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29;
  };
  const ShadowLight& light = key.light;
  for (const float v : {light.position.x, light.position.y, light.position.z, light.softness, light.extent}) {
    mix(std::bit_cast<std::uint32_t>(v));
  }
  mix(static_cast<std::uint64_t>(light.size_px));
  return hash;
}

std::span<const float> SampleVisibility::column(const ShadowLight& light, const SampleSet& samples,
                                                const Softness& softness) {
  Key key{samples.id, light, std::max(softness.shadow_rays, 1)};
  key.light.softness = std::max(light.softness, softness.shadow_angle);
  key.light.direction = ShadowLight{}.direction;
  if (const auto known = index_.find(key); known != index_.end()) {
    columns_.splice(columns_.begin(), columns_, known->second);
  } else {
    columns_.push_front({key, trace(key.light, samples, key.rays)});
    index_[key] = columns_.begin();
    held_ += samples.pixels.size();
  }
  LUM_CHECK(columns_.front().lit.size() == samples.pixels.size(), "a set's id stands for its pixels");
  return columns_.front().lit;
}

void SampleVisibility::trim() {
  while (held_ > budget_ && !columns_.empty()) {
    held_ -= columns_.back().lit.size();
    index_.erase(columns_.back().key);
    columns_.pop_back();
  }
}

std::vector<float> SampleVisibility::trace(const ShadowLight& light, const SampleSet& samples, int ray_count) {
  std::vector<float> lit(samples.pixels.size(), 1.0F);
  if (light.kind == ShadowKind::kNone) return lit;
  segments_.clear();
  for (std::size_t i = 0; i < lit.size(); ++i) {
    const std::size_t pixel = samples.pixels[i];
    if (surface_->object[pixel] == 0) continue;
    const Vec3& normal = surface_->normal[pixel];
    const Vec3 receiver = shadow_receiver(light, surface_->position[pixel], normal);
    for (int j = 0; j < ray_count; ++j) {
      const Vec2 disc = sample_disc(static_cast<std::uint32_t>(i), j, ray_count);
      segments_.push_back({light.position, shadow_tap(light, receiver, normal, disc)});
    }
  }
  blocked_.resize(segments_.size());
  rays_->occluded(segments_, blocked_);
  queries_ += static_cast<double>(segments_.size());
  const unsigned char* answer = blocked_.data();
  for (std::size_t i = 0; i < lit.size(); ++i) {
    if (surface_->object[samples.pixels[i]] == 0) continue;
    int free = 0;
    for (int j = 0; j < ray_count; ++j) free += *answer++ == 0 ? 1 : 0;
    lit[i] = static_cast<float>(free) / static_cast<float>(ray_count);
  }
  return lit;
}

}  // namespace luminist
