#include "gpu/gl_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "base/check.h"
#include "gpu/settled_drawing.h"

namespace luminist {
namespace {

constexpr float kAnisotropy = 8.0F;

int levels_of(int width, int height) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(width, height))));
}

/// The image as RGBA; grey is spread over the colours, alpha is 1 where there is none.
std::vector<float> rgba_of(const Image& image) {
  std::vector<float> texels(image.pixels() * 4, 1.0F);
  const auto channels = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const float* source = image.data.data() + i * channels;
    for (std::size_t c = 0; c < 3; ++c) texels[i * 4 + c] = source[channels < 3 ? 0 : c];
    if (channels == 2 || channels >= 4) texels[i * 4 + 3] = source[channels == 2 ? 1 : 3];
  }
  return texels;
}

/// Each level of the picture from the one before. Software GL draws them: one at a time, so that it keeps none.
void fill_levels(const Device& device, GLuint name, int levels) {
  if (!device.info().software) {
    glGenerateTextureMipmap(name);
    return;
  }
  for (int level = 0; level + 1 < levels; ++level) {
    const SettledDrawing drawing(device);
    glTextureParameteri(name, GL_TEXTURE_BASE_LEVEL, level);
    glTextureParameteri(name, GL_TEXTURE_MAX_LEVEL, level + 1);
    glGenerateTextureMipmap(name);
  }
  glTextureParameteri(name, GL_TEXTURE_BASE_LEVEL, 0);
  glTextureParameteri(name, GL_TEXTURE_MAX_LEVEL, levels - 1);
}

}  // namespace

Result<GlTexture> GlTexture::create(Device& device, GLenum target, GLenum format, int levels, int width, int height,
                                    int layers, const std::string& label) {
  LUM_CHECK(width > 0 && height > 0, "a texture has texels");
  const DeviceInfo& info = device.info();
  if (std::max(width, height) > info.max_texture_size || layers > info.max_array_layers) {
    return Error{ErrorKind::kLimit,
                 fmt::format("{} would be {} x {} ({} layers), and this device's limit is {} ({})", label, width,
                             height, layers, info.max_texture_size, info.max_array_layers),
                 "", "", "make the picture smaller"};
  }
  LUM_TRY_VOID(device.check_errors("prepare " + label));
  GlTexture texture;
  GLuint name = 0;
  glCreateTextures(target, 1, &name);
  texture.name_ = GlName<remove>(name);
  texture.width_ = width;
  texture.height_ = height;
  texture.layers_ = layers;
  glObjectLabel(GL_TEXTURE, name, -1, label.c_str());
  if (layers > 0) {
    glTextureStorage3D(name, levels, format, width, height, layers);
  } else {
    glTextureStorage2D(name, levels, format, width, height);
  }
  LUM_TRY_VOID(device.check_errors("allocate " + label));
  texture.set(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  texture.set(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  texture.set(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  texture.set(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

Result<GlTexture> GlTexture::create_2d(Device& device, GLenum format, int width, int height, const std::string& label) {
  return create(device, GL_TEXTURE_2D, format, 1, width, height, 0, label);
}

Result<GlTexture> GlTexture::create_2d_array(Device& device, GLenum format, int width, int height, int layers,
                                             const std::string& label) {
  LUM_CHECK(layers > 0, "an array has layers");
  return create(device, GL_TEXTURE_2D_ARRAY, format, 1, width, height, layers, label);
}

Result<GlTexture> GlTexture::create_picture(Device& device, const Image& image, bool repeat_u, bool repeat_v,
                                            const std::string& label) {
  LUM_CHECK(!image.empty(), "a picture has pixels");
  const int limit = device.info().max_texture_size;
  if (std::max(image.width, image.height) > limit) {
    return create_picture(device, resized(image, std::min(image.width, limit), std::min(image.height, limit)), repeat_u,
                          repeat_v, label);
  }
  const int levels = levels_of(image.width, image.height);
  LUM_TRY(GlTexture texture, create(device, GL_TEXTURE_2D, GL_RGBA16F, levels, image.width, image.height, 0, label));
  const std::vector<float> texels = rgba_of(image);
  glTextureSubImage2D(texture.name(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_FLOAT, texels.data());
  fill_levels(device, texture.name(), levels);
  texture.set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  texture.set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  texture.set(GL_TEXTURE_WRAP_S, repeat_u ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  texture.set(GL_TEXTURE_WRAP_T, repeat_v ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  const float anisotropy = std::min(kAnisotropy, device.info().max_anisotropy);
  if (anisotropy > 1.0F) glTextureParameterf(texture.name(), GL_TEXTURE_MAX_ANISOTROPY, anisotropy);
  LUM_TRY_VOID(device.check_errors("fill " + label));
  return texture;
}

Result<GlTexture> GlTexture::create_numbers(Device& device, const Image& image, int levels, const std::string& label) {
  LUM_CHECK(!image.empty(), "a picture has pixels");
  int rows = 0;
  for (int level = 0; level < levels; ++level) rows += image.width >> level;
  if (levels > 0 && (image.height < rows || image.width >> (levels - 1) < 1)) {
    return Error{ErrorKind::kBadContent,
                 fmt::format("{} levels of {} texels and less need {} rows, there are {}", levels, image.width, rows,
                             image.height),
                 label, "levels", "give the number of levels that the strip has"};
  }
  const int height = levels > 0 ? image.width : image.height;
  LUM_TRY(GlTexture texture, create(device, GL_TEXTURE_2D, GL_R16, std::max(levels, 1), image.width, height, 0, label));
  int row = 0;
  for (int level = 0; level < std::max(levels, 1); ++level) {
    const int width = image.width >> level;
    const int count = levels > 0 ? width : image.height;
    std::vector<float> texels;
    for (int y = 0; y < count; ++y) {
      for (int x = 0; x < width; ++x) texels.push_back(image.at(x, row + y, 0));
    }
    glTextureSubImage2D(texture.name(), level, 0, 0, width, count, GL_RED, GL_FLOAT, texels.data());
    row += count;
  }
  texture.set(GL_TEXTURE_MIN_FILTER, levels > 0 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  texture.set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  texture.set(GL_TEXTURE_WRAP_S, levels > 0 ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  texture.set(GL_TEXTURE_WRAP_T, levels > 0 ? GL_REPEAT : GL_CLAMP_TO_EDGE);
  LUM_TRY_VOID(device.check_errors("fill " + label));
  return texture;
}

}  // namespace luminist
