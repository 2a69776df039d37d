#include "studio/shot_camera.h"

#include <vector>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {

Result<Camera> shot_camera(const Scene& scene, const std::string& name) {
  if (name.empty()) return scene.cameras.front();
  if (const Camera* camera = scene.find_camera(name)) return *camera;
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) names.push_back(camera.name);
  const std::string near = nearest_name(name, names);
  return Error{
      ErrorKind::kUsage, fmt::format("the scene has no camera \"{}\"", name), "", "camera",
      near.empty() ? fmt::format("it has: {}", fmt::join(names, ", ")) : fmt::format("did you mean \"{}\"?", near)};
}

}  // namespace luminist
