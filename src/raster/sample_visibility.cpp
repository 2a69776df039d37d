#include "raster/sample_visibility.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <numeric>

#include "base/check.h"

namespace luminist {

SampleVisibility::SampleVisibility(const RayScene& rays, const SurfaceBuffer& surface, std::size_t budget_values)
    : rays_(&rays), surface_(&surface), budget_(budget_values) {}

Vec2 sample_disc(std::uint32_t sample, int ray, int rays) {
  // Multiples of 1/p and 1/p^2, p^3 = p + 1, in fixed point: the wrap of the integers is the fraction.
  const std::uint32_t index = sample * static_cast<std::uint32_t>(rays) + static_cast<std::uint32_t>(ray);
  const auto fraction = [](std::uint32_t fixed) { return static_cast<float>(fixed >> 8) * 0x1p-24F; };
  const float radius = std::sqrt(fraction(index * 3242174889U + 0x80000000U));
  const float angle = 2.0F * kPiF * fraction(index * 2447445414U);
  return radius * Vec2(std::cos(angle), std::sin(angle));
}

std::size_t SampleVisibility::KeyHash::operator()(const Key& key) const {
  std::uint64_t hash = key.samples + static_cast<std::uint64_t>(key.rays);
  const auto mix = [&hash](std::uint64_t value) {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15U;
    hash ^= hash >> 29;
  };
  const ShadowLight& light = key.light;
  for (const float v : {light.position.x, light.position.y, light.position.z, light.direction.x, light.direction.y,
                        light.direction.z, light.softness, light.extent}) {
    mix(std::bit_cast<std::uint32_t>(v));
  }
  mix(static_cast<std::uint64_t>(light.size_px));
  return hash;
}

SampleVisibility::Key SampleVisibility::key_of(const ShadowLight& light, const SampleSet& samples,
                                               const Softness& softness) {
  Key key{samples.id, light, std::max(softness.shadow_rays, 1)};
  key.light.softness = std::max(light.softness, softness.shadow_angle * (light.parallel() ? light.extent : 1.0F));
  if (!light.parallel()) key.light.direction = ShadowLight{}.direction;
  return key;
}

SampleVisibility::Column& SampleVisibility::touch(const Key& key) {
  if (const auto known = index_.find(key); known != index_.end()) {
    columns_.splice(columns_.begin(), columns_, known->second);
  } else {
    columns_.push_front({key, {}});
    index_[key] = columns_.begin();
  }
  return columns_.front();
}

void SampleVisibility::prepare(std::span<const ShadowLight> lights, const SampleSet& samples,
                               const Softness& softness) {
  const std::size_t count = samples.pixels.size();
  std::vector<Column*> missing;
  for (const ShadowLight& light : lights) {
    Column& column = touch(key_of(light, samples, softness));
    if (column.lit.size() == count) continue;
    LUM_CHECK(column.lit.empty(), "a set's id stands for its pixels");
    column.lit.assign(count, 1.0F);
    missing.push_back(&column);
  }
  held_ += missing.size() * count;
  prepare_discs(count, std::max(softness.shadow_rays, 1));
  std::vector<std::size_t> traced(missing.size(), 0);
  tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) { traced[i] = trace(*missing[i], samples); });
  for (const std::size_t rays : traced) queries_ += static_cast<double>(rays);
}

std::span<const float> SampleVisibility::column(const ShadowLight& light, const SampleSet& samples,
                                                const Softness& softness) {
  const Column& column = touch(key_of(light, samples, softness));
  if (column.lit.size() != samples.pixels.size()) prepare({&light, 1}, samples, softness);
  return column.lit;
}

void SampleVisibility::trim() {
  while (held_ > budget_ && !columns_.empty()) {
    held_ -= columns_.back().lit.size();
    index_.erase(columns_.back().key);
    columns_.pop_back();
  }
}

void SampleVisibility::prepare_discs(std::size_t samples, int rays) {
  if (rays != discs_rays_) discs_.clear();
  discs_rays_ = rays;
  for (std::size_t i = discs_.size() / static_cast<std::size_t>(rays); i < samples; ++i) {
    for (int j = 0; j < rays; ++j) discs_.push_back(sample_disc(static_cast<std::uint32_t>(i), j, rays));
  }
}

std::size_t SampleVisibility::trace(Column& column, const SampleSet& samples) const {
  const ShadowLight& light = column.key.light;
  if (light.kind == ShadowKind::kNone) return 0;
  const auto rays_a_sample = static_cast<std::size_t>(column.key.rays);
  std::vector<Segment> segments;
  segments.reserve(samples.pixels.size() * rays_a_sample);
  for (std::size_t i = 0; i < samples.pixels.size(); ++i) {
    const std::size_t pixel = samples.pixels[i];
    if (surface_->object[pixel] == 0) continue;
    const Vec3& normal = surface_->normal[pixel];
    const Vec3 receiver =
        shadow_receiver(light, surface_->position[pixel], normal, rays_->shadow_slack(surface_->object[pixel] - 1));
    for (std::size_t j = 0; j < rays_a_sample; ++j) {
      const Vec2& disc = discs_[i * rays_a_sample + j];
      const Vec3 tap = shadow_tap(light, receiver, normal, disc);
      segments.push_back({ray_origin(light, tap), tap});
    }
  }
  std::vector<unsigned char> blocked(segments.size());
  rays_->occluded(segments, blocked);
  const unsigned char* answer = blocked.data();
  for (std::size_t i = 0; i < samples.pixels.size(); ++i) {
    const std::size_t pixel = samples.pixels[i];
    if (surface_->object[pixel] == 0) continue;
    const auto hits = std::accumulate(answer, answer + rays_a_sample, 0U);
    answer += rays_a_sample;
    column.lit[i] = 1.0F - static_cast<float>(hits) / static_cast<float>(rays_a_sample);
    if (rays_->shadow_slack(surface_->object[pixel] - 1) == 0.0F) continue;
    const Vec3 to_light = way_to_light(light, surface_->position[pixel]);
    column.lit[i] *= share_before_own_shadow(glm::dot(to_light, surface_->normal[pixel]));
  }
  return segments.size();
}

}  // namespace luminist
