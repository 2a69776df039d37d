#include "trace/progressive.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

#include "base/check.h"
#include "trace/light_gathering.h"

namespace luminist {
namespace {

constexpr std::size_t kTile = 32;  // pixels that one task draws
constexpr std::uint32_t kLargestPass = 8;

using Sum = glm::dvec3;

/// What a task uses again and again.
struct Scratch {
  LightPaths paths;
  std::vector<Vec3> light;
  std::vector<Vec3> light_later;
  std::vector<Vec3> color;
  std::vector<Vec3> later;  ///< the part of color that arrives by way of a second surface
};

/// What a path brings, with no more than `most` in any channel by way of a second surface.
Vec3 held(const Vec3& color, const Vec3& later, float most) {
  const float brightest = largest(later);
  return most > 0.0F && brightest > most ? color - (1.0F - most / brightest) * later : color;
}

/// Samples from .. to of a pixel. returns the number of shadow rays.
std::size_t draw_pixel(const PathTracer& tracer, const PathJob& job, std::uint32_t pixel, std::uint32_t from,
                       std::uint32_t to, Scratch& scratch, Sum& sum) {
  scratch.paths.clear();
  for (std::uint32_t sample = from; sample < to; ++sample) tracer.trace(pixel, sample, job.options, scratch.paths);
  const std::size_t count = scratch.paths.size();
  scratch.color.assign(count, Vec3(0.0F));
  for (std::size_t i = 0; i < count; ++i) {
    scratch.color[i] = scratch.paths.emitted[i] + job.ambient * scratch.paths.escaped[i];
  }
  scratch.later = scratch.paths.emitted_later;
  std::size_t rays = 0;
  for (const RigLight& light : job.lights) {
    scratch.light.assign(count, Vec3(0.0F));
    scratch.light_later.assign(count, Vec3(0.0F));
    rays += gather_light(tracer.rays(), scratch.paths, 0, count, light, scratch.light, scratch.light_later);
    for (std::size_t i = 0; i < count; ++i) {
      scratch.color[i] += light.color * scratch.light[i];
      scratch.later[i] += light.color * scratch.light_later[i];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 color = held(scratch.color[i], scratch.later[i], job.most_later);
    if (is_finite(color)) sum += Sum(color);
  }
  return rays;
}

Image mean(const PathTracer& tracer, const PathJob& job, std::span<const Sum> sums, std::uint32_t done) {
  Image image(tracer.width(), tracer.height(), 3);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const std::uint32_t count = std::min(job.samples[i], done);
    if (count > 0) image.set_rgb(i, Vec3(sums[i] / static_cast<double>(count)));
  }
  return image;
}

}  // namespace

Result<Image> trace_picture(const PathTracer& tracer, const PathJob& job, const PathWatch& watch, double& queries) {
  const std::size_t pixels = job.samples.size();
  LUM_CHECK(pixels == static_cast<std::size_t>(tracer.width()) * static_cast<std::size_t>(tracer.height()),
            "a number of samples per pixel");
  const std::uint32_t most = pixels == 0 ? 0 : *std::ranges::max_element(job.samples);
  const std::size_t tiles = (pixels + kTile - 1) / kTile;
  std::vector<Sum> sums(pixels, Sum(0.0));
  std::vector<std::size_t> rays(tiles, 0);
  tbb::enumerable_thread_specific<Scratch> scratch;
  std::uint32_t done = 0;
  while (done < most) {
    const std::uint32_t end = std::min(most, done + std::clamp(done, 1U, kLargestPass));
    tbb::parallel_for(std::size_t{0}, tiles, [&](std::size_t tile) {
      for (std::size_t i = tile * kTile; i < std::min(pixels, (tile + 1) * kTile); ++i) {
        const std::uint32_t to = std::min(end, job.samples[i]);
        if (to <= done) continue;
        rays[tile] += draw_pixel(tracer, job, static_cast<std::uint32_t>(i), done, to, scratch.local(), sums[i]);
      }
    });
    done = end;
    if (!watch) continue;
    const Image so_far = mean(tracer, job, sums, done);
    if (!watch({static_cast<int>(done), static_cast<int>(most), &so_far})) {
      return Error{ErrorKind::kCancelled, "the picture was cancelled", "", "", ""};
    }
  }
  for (const std::size_t each : rays) queries += static_cast<double>(each);
  return mean(tracer, job, sums, most);
}

}  // namespace luminist
