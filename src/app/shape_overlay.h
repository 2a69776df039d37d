#pragma once
// app/shape_overlay.h -- a light's barn and cutoffs, drawn over a picture of the scene, and their handles.
#include <functional>
#include <optional>
#include <span>

#include "app/light_shape.h"
#include "app/theme.h"

namespace luminist {

/// Where a place of the world is on the screen; nothing if it is not in sight.
using ToScreen = std::function<std::optional<Vec2>(const Vec3&)>;

/// A line through places of the world, where they are in sight.
void draw_path(ImDrawList& list, const ToScreen& screen, std::span<const Vec3> places, ImU32 color, float width);

/// The handle under the pointer.
std::optional<ShapeHandle> shape_handle_at(const Theme& theme, const ToScreen& screen,
                                           std::span<const ShapeHandle> handles, const Vec2& pointer);

/// The edge of the light at `reach`, the cutoffs that lie about there, and the handles; words beside the one that is
/// under the pointer or held.
void draw_shape(const Theme& theme, ImDrawList& list, const ToScreen& screen, const LightPose& pose,
                const LightShape& shape, float reach, std::optional<ShapePart> pointed);

}  // namespace luminist
