#pragma once
// studio/shot_camera.h -- the camera that a shot names.
#include <string>

#include "base/result.h"
#include "scene/scene.h"

namespace luminist {

/// The camera of that name as it stands; the first one if the name is empty. errors kUsage with the nearest name.
Result<Camera> shot_camera(const Scene& scene, const std::string& name);

}  // namespace luminist
