#pragma once
// studio/shot_camera.h -- the camera that a shot names.
#include <span>
#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace luminist {

/// The camera of that name as it stands; the first one if the name is empty. errors kUsage with the nearest name.
Result<Camera> shot_camera(const Scene& scene, const std::string& name);
/// The same of names alone; "" if the scene has no camera.
Result<std::string> known_camera(const std::string& name, std::span<const std::string> cameras);
/// What a camera that the scene has is called; "" if the scene has none.
std::string camera_name(const std::string& name, std::span<const std::string> cameras);

}  // namespace luminist
