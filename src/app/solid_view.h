#pragma once
// app/solid_view.h -- a scene's triangles, drawn plainly on the window's own context.
#include <imgui.h>

#include <memory>
#include <string>

#include "base/files.h"
#include "studio/solid_scene.h"

namespace luminist {

/// Made and used while the window's context is current. It draws into a picture of its own.
class SolidView {
 public:
  SolidView() = default;
  SolidView(const SolidView&) = delete;
  SolidView& operator=(const SolidView&) = delete;
  ~SolidView();

  /// Takes over the triangles. errors kMissing, kStyle if the shaders are damaged, kGl.
  Result<void> load(const AssetRoots& roots, std::shared_ptr<const SolidScene> solid);
  /// cost a pass over the triangles. width, height in pixels; where it is shown twice as large they are few.
  void draw(const Camera& camera, int width, int height);
  [[nodiscard]] bool empty() const { return solid_ == nullptr; }
  [[nodiscard]] const std::shared_ptr<const SolidScene>& solid() const { return solid_; }
  /// Row 0 below, as GL has it.
  [[nodiscard]] ImTextureID id() const { return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(color_)); }

 private:
  Result<void> compile(const AssetRoots& roots);
  void resize(int width, int height);

  std::shared_ptr<const SolidScene> solid_;
  unsigned program_ = 0;
  unsigned vertices_ = 0;  ///< vertex array
  unsigned buffers_[3] = {0, 0, 0};
  unsigned frame_ = 0;
  unsigned color_ = 0;
  unsigned depth_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace luminist
