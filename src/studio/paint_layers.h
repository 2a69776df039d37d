#pragma once
// studio/paint_layers.h -- the layers of a session's paint, and the strokes in them.
#include <cstdint>
#include <string>

#include "studio/session.h"

namespace luminist {

/// What Session::layers() gives: each call is a gesture like those of a session, recorded as one command; the target is
/// composited anew. Strokes are named by their numbers, which are those of verdicts; layers by their names.
/// errors kUsage for a layer (nearest name) or a stroke that is not there; those of Canvas::relayer(). cost every
/// stroke.
class PaintLayers {
 public:
  explicit PaintLayers(Session& session) : session_(&session) {}

  /// Without pixels (read_stack()); `active` is the layer that is painted on. errors kBadContent.
  [[nodiscard]] Result<LayerStack> stack() const;
  /// What is painted next goes there; nothing is recorded.
  Result<void> choose(const std::string& layer);

  /// A layer above the one that is painted on, which is painted on from now on. name: "" for one that is free.
  /// returns its name. errors kUsage for a name that is taken.
  Result<std::string> add(const std::string& name = "");
  /// With its strokes. errors kUsage for the only one.
  Result<void> remove(const std::string& layer);
  Result<void> rename(const std::string& layer, const std::string& name);
  Result<void> set_visible(const std::string& layer, bool visible);
  Result<void> set_opacity(const std::string& layer, float opacity);
  /// To that place counted from the lowest; the last for one that is too high.
  Result<void> place(const std::string& layer, std::size_t place);
  /// Its strokes go over those of the layer below, which stays. Opacities become those of the strokes: where they
  /// overlap that is only nearly the same. errors kUsage for the lowest, hidden layers, and one whose eraser would
  /// reach further.
  Result<void> merge_down(const std::string& layer);

  /// path: of the file that copies are looked for beside.
  Result<void> set_brush(std::uint32_t stroke, const Brush& brush, const std::string& path);
  /// by: picture heights.
  Result<void> move(std::uint32_t stroke, const Vec2& by);
  /// place: in that layer, counted from the lowest; the last for one that is too high.
  Result<void> place_stroke(std::uint32_t stroke, const std::string& layer, std::size_t place);
  Result<void> remove_stroke(std::uint32_t stroke);

 private:
  friend class Session;
  Result<LayerStack> layers();
  Result<void> commit(const std::string& label, const std::string& action, LayerStack next,
                      const std::string& path = "");
  Session* session_;
};

}  // namespace luminist
