#include "paint/copy_source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {
namespace {

Error refused(const std::string& path, std::string what, std::string hint) {
  return {ErrorKind::kBadContent, std::move(what), path, "copy_from", std::move(hint)};
}

/// Scaled to one side of the picture, the other differs by at most a pixel.
bool same_aspect(const Image& image, int width, int height) {
  const double across = static_cast<double>(image.width) * height / image.height;
  const double down = static_cast<double>(image.height) * width / image.width;
  return std::abs(across - width) <= 1.0 || std::abs(down - height) <= 1.0;
}

Result<void> check_image(const Image& image, const std::string& path, int width, int height) {
  if (image.empty() || image.channels > 4) {
    return refused(path, fmt::format("{} channels are neither grey nor colour", image.channels), "save it as RGB");
  }
  const auto broken = std::find_if(image.data.begin(), image.data.end(), [](float v) { return !std::isfinite(v); });
  if (broken != image.data.end()) {
    const auto pixel = (broken - image.data.begin()) / image.channels;
    const std::string place = fmt::format("({}, {})", pixel % image.width, pixel / image.width);
    return refused(path, fmt::format("the pixel {} is not finite", place), "");
  }
  if (!same_aspect(image, width, height)) {
    return refused(path,
                   fmt::format("{} x {} pixels have another aspect than the picture's {} x {}", image.width,
                               image.height, width, height),
                   "start from a picture of this shot and do not crop it");
  }
  return {};
}

}  // namespace

Result<Image> load_copy_source(const std::string& reference, const std::string& folder, int width, int height,
                               const ImageReader& read) {
  auto path = resolve_beside(std::filesystem::path(folder) / "strokes", reference);
  if (!path) {
    Error error = std::move(path).error();
    error.where.clear();  // only the caller knows the stroke file's name
    error.field = "copy_from";
    return error;
  }
  LUM_TRY(Image image, read(path->string()));
  LUM_TRY_VOID(check_image(image, path->string(), width, height));
  if (image.width == width && image.height == height) return image;
  return resized(image, width, height);
}

Vec4 source_pixel(const Image& image, std::size_t pixel) {
  const auto channels = static_cast<std::size_t>(image.channels);
  const float* data = &image.data[pixel * channels];
  const float alpha = channels % 2 == 0 ? std::clamp(data[channels - 1], 0.0F, 1.0F) : 1.0F;
  return channels < 3 ? Vec4(data[0], data[0], data[0], alpha) : Vec4(data[0], data[1], data[2], alpha);
}

}  // namespace luminist
