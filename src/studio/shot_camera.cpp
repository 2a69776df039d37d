#include "studio/shot_camera.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {

Result<Camera> shot_camera(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) names.push_back(camera.name);
  LUM_TRY(const std::string known, known_camera(name, names));
  return *scene.find_camera(known);
}

Result<std::string> known_camera(const std::string& name, std::span<const std::string> cameras) {
  const std::string whole = camera_name(name, cameras);
  if (whole.empty() || std::ranges::find(cameras, whole) != cameras.end()) return whole;
  const std::vector<std::string> names(cameras.begin(), cameras.end());
  const std::string near = nearest_name(name, names);
  return Error{
      ErrorKind::kUsage, fmt::format("the scene has no camera \"{}\"", name), "", "camera",
      near.empty() ? fmt::format("it has: {}", fmt::join(names, ", ")) : fmt::format("did you mean \"{}\"?", near)};
}

std::string camera_name(const std::string& name, std::span<const std::string> cameras) {
  return name.empty() && !cameras.empty() ? cameras.front() : name;
}

}  // namespace luminist
