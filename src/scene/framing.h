#pragma once
// scene/framing.h -- the camera, floor and wall that a bare mesh gets.
#include "scene/scene.h"

namespace luminist {

/// A three-quarter view from the front (+Z), the right and a little above, Y up, that holds every object and leaves a
/// margin, for pictures at least as wide as high. cost O(vertices).
Camera automatic_camera(const Scene& scene);

/// Adds a floor just under the lowest point and, behind the scene as the camera sees it, a wall: large neutral planes,
/// subdivided, marked as backdrops. Makes the far planes of the cameras unknown.
void add_backdrops(Scene& scene, const SceneOptions& options);

/// Gives cameras whose near or far plane is 0 (unknown) planes that follow the bounds.
void fit_clip_planes(Scene& scene);

}  // namespace luminist
