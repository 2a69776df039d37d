#pragma once
// app/lit_view.h -- the free view as the style lights it: asked of the studio's thread, shown when it comes.
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/desk.h"
#include "app/picture_texture.h"
#include "studio/solid_scene.h"

namespace luminist {

/// One picture at a time is on its way; what was wanted meanwhile is asked for next. Made and used while the window's
/// context is current.
class LitView {
 public:
  struct Wish {
    Camera camera;
    int width = 0;  ///< pixels
    int height = 0;
    std::shared_ptr<const ParamState> lights;
    std::string signature;  ///< of the lights; ask() sets it
  };
  /// Asks for the triangles of the shot that is looked at; they are there when solid() is another.
  void ask_solid(Desk& desk);
  /// Asks for a picture unless it is there, on its way, or went wrong before.
  void ask(Desk& desk, Wish wish);
  /// Gives back what pictures need, which is much; the one that is shown stays.
  static void put_away(Desk& desk);
  /// Takes what has come.
  void take(const Desk& desk);
  [[nodiscard]] bool waits() const { return waiting_; }
  [[nodiscard]] const std::shared_ptr<const SolidScene>& solid() const { return solid_; }
  /// Whether the picture is of this camera, whatever the lights.
  [[nodiscard]] bool shows(const Camera& camera) const;
  [[nodiscard]] ImTextureID id() const { return texture_.id(); }
  void forget();  ///< another shot

 private:
  struct Answer {
    std::mutex mutex;
    bool done = false;
    bool unreadable = false;  ///< there are no triangles, which was told
    std::shared_ptr<const SolidScene> solid;
    std::shared_ptr<const Image> picture;  ///< null: it went wrong, which was told
  };
  void show(const Desk& desk);

  std::shared_ptr<Answer> answer_;  ///< of what is on its way
  bool waiting_ = false;
  bool unreadable_ = false;  ///< the scene is not asked for again
  int overdue_ = 0;          ///< frames in which nobody works on what is on its way
  Wish asked_;
  std::optional<Wish> shown_;  ///< what picture_ is of; none: nothing
  std::shared_ptr<const Image> picture_;
  std::shared_ptr<const SolidScene> solid_;
  DisplayOptions display_;
  std::vector<std::uint32_t> codes_;
  PictureTexture texture_;
};

}  // namespace luminist
