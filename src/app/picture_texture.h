#pragma once
// app/picture_texture.h -- a picture as the screen shows it.
#include <imgui.h>

#include <cstdint>
#include <span>

namespace luminist {

/// Made and used while the window's context is current.
class PictureTexture {
 public:
  PictureTexture() = default;
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;
  ~PictureTexture();

  /// pixels [width x height], RGBA, row 0 on top.
  void upload(std::span<const std::uint32_t> pixels, int width, int height);
  /// Below full size pixels are averaged, above twice that they are squares.
  void filter(float zoom);
  [[nodiscard]] bool empty() const { return name_ == 0; }
  [[nodiscard]] ImTextureID id() const { return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name_)); }

 private:
  unsigned name_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace luminist
