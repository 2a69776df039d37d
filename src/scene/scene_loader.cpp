#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene/framing.h"
#include "scene/mesh_repair.h"
#include "scene/readers.h"
#include "scene/scene.h"

namespace luminist {
namespace {

constexpr std::size_t kMostTriangles = 20'000'000;

Result<Scene> read_by_extension(const std::string& path, Diagnostics& diagnostics) {
  const std::string extension = lower_extension(path);
  if (extension == ".gltf" || extension == ".glb") return read_gltf(path, diagnostics);
  if (extension == ".obj") return read_obj(path, diagnostics);
  if (extension == ".ply" || extension == ".stl" || extension == ".off") return read_polygons(path, diagnostics);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return Error{ErrorKind::kMissing, "there is no such file", path, "", ""};
  }
  return Error{ErrorKind::kBadContent, fmt::format("unknown kind of scene \"{}\"", extension), path, "",
               "use .glb, .gltf, .obj, .ply, .stl or .off"};
}

/// Every object gets a name of its own: "name", "name-2", "name-3"...
void make_names_unique(Scene& scene) {
  std::set<std::string> taken;
  std::map<std::string, int> last;
  for (Object& object : scene.objects) {
    const std::string wanted = object.name.empty() ? "object" : object.name;
    object.name = wanted;
    for (int& n = last.try_emplace(wanted, 1).first->second; !taken.insert(object.name).second;) {
      object.name = fmt::format("{}-{}", wanted, ++n);
    }
  }
}

/// What messages call a mesh: the object that shows it.
std::vector<std::string> mesh_labels(const Scene& scene) {
  std::vector<std::string> labels(scene.meshes.size(), "mesh");
  for (const Object& object : scene.objects) {
    if (object.shadow_mesh < 0) continue;
    labels[static_cast<std::size_t>(object.shadow_mesh)] = fmt::format("the shadow mesh of \"{}\"", object.name);
  }
  for (const Object& object : scene.objects) {
    labels[static_cast<std::size_t>(object.mesh)] = fmt::format("\"{}\"", object.name);
  }
  return labels;
}

/// A shadow mesh without a face is no wish to have no shadow: it came to that by faults.
void replace_empty_shadow_meshes(Scene& scene, const std::string& path, Diagnostics& diagnostics) {
  for (Object& object : scene.objects) {
    if (object.shadow_mesh < 0 || !scene.meshes[static_cast<std::size_t>(object.shadow_mesh)].triangles.empty())
      continue;
    object.shadow_mesh = -1;
    diagnostics.warn(
        path, fmt::format("\"{}\": no face of its shadow mesh is left; its own mesh casts its shadow", object.name));
  }
}

/// Drops the objects that lost all their faces, and the meshes that nothing needs any more.
void drop_empty(Scene& scene) {
  std::erase_if(scene.objects, [&](const Object& object) {
    return scene.meshes[static_cast<std::size_t>(object.mesh)].triangles.empty();
  });
  std::vector<int> renamed(scene.meshes.size(), -1);
  std::vector<Mesh> kept;
  const auto keep = [&](int mesh) {
    int& index = renamed[static_cast<std::size_t>(mesh)];
    if (index < 0) {
      index = static_cast<int>(kept.size());
      kept.push_back(std::move(scene.meshes[static_cast<std::size_t>(mesh)]));
    }
    return index;
  };
  for (Object& object : scene.objects) object.mesh = keep(object.mesh);
  for (Object& object : scene.objects) {
    if (object.shadow_mesh >= 0) object.shadow_mesh = keep(object.shadow_mesh);
  }
  scene.meshes = std::move(kept);
}

/// Takes reflections out of the objects' matrices, so that front faces wind counter-clockwise in the world too.
void take_out_reflections(Scene& scene) {
  const Mat4 reflection(Vec4(-1, 0, 0, 0), Vec4(0, 1, 0, 0), Vec4(0, 0, 1, 0), Vec4(0, 0, 0, 1));
  std::map<int, int> reflected;
  const auto reflect = [&](int mesh) {
    const auto [entry, is_new] = reflected.try_emplace(mesh, static_cast<int>(scene.meshes.size()));
    if (is_new) scene.meshes.push_back(mirrored(scene.meshes[static_cast<std::size_t>(mesh)]));
    return entry->second;
  };
  for (Object& object : scene.objects) {
    if (glm::determinant(Mat3(object.world_from_object)) >= 0.0F) continue;
    object.mesh = reflect(object.mesh);
    if (object.deformer >= 0) {
      Deformer& deformer = scene.deformers[static_cast<std::size_t>(object.deformer)];
      deformer = mirrored(deformer);
    }
    if (object.shadow_mesh >= 0) object.shadow_mesh = reflect(object.shadow_mesh);
    object.world_from_object = object.world_from_object * reflection;
  }
}

/// Meshes under a material with a normal map need tangents.
void add_tangents(Scene& scene) {
  for (const Object& object : scene.objects) {
    Mesh& mesh = scene.meshes[static_cast<std::size_t>(object.mesh)];
    const bool wanted = scene.materials[static_cast<std::size_t>(object.material)].normal_texture >= 0;
    if (wanted && mesh.tangents.size() != mesh.positions.size()) compute_tangents(mesh);
  }
}

/// What morph targets add to the normals of a mesh turns as those do.
void turn_target_normals(Scene& scene, int mesh) {
  for (const Object& object : scene.objects) {
    if (object.mesh != mesh || object.deformer < 0) continue;
    for (MorphTarget& target : scene.deformers[static_cast<std::size_t>(object.deformer)].targets) {
      for (Vec3& normal : target.normals) normal = -normal;
    }
  }
}

Result<void> repair(Scene& scene, const std::string& path, bool bare, Diagnostics& diagnostics) {
  const std::vector<std::string> labels = mesh_labels(scene);
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    Mesh& mesh = scene.meshes[i];
    drop_faulty_faces(mesh, path, labels[i], diagnostics);
    if (mesh.triangles.empty()) continue;
    const bool had_normals = mesh.normals.size() == mesh.positions.size();
    if (repair_normals(mesh, path, labels[i], diagnostics)) turn_target_normals(scene, static_cast<int>(i));
    // A glTF may mean it (a closed room); a bare mesh without normals that is inside out was written by mistake.
    if (bare && !had_normals && turn_outside(mesh)) {
      diagnostics.warn(path, fmt::format("{}: the surface was inside out and was turned", labels[i]));
    }
  }
  replace_empty_shadow_meshes(scene, path, diagnostics);
  drop_empty(scene);
  if (scene.objects.empty()) {
    return Error{ErrorKind::kBadContent, "nothing to show: no face is left", path, "",
                 "export the mesh with its faces"};
  }
  take_out_reflections(scene);
  if (scene.materials.empty()) scene.materials.push_back({.name = "default"});
  add_tangents(scene);
  return {};
}

}  // namespace

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
  return extension;
}

Result<Scene> load_scene(const std::string& path, const SceneOptions& options, Diagnostics& diagnostics) {
  LUM_TRY(Scene scene, read_by_extension(path, diagnostics));
  if (scene.triangle_count() > kMostTriangles) {
    return Error{ErrorKind::kLimit,
                 fmt::format("{} triangles are more than {}", scene.triangle_count(), kMostTriangles), path, "",
                 "decimate the mesh"};
  }
  const std::string extension = lower_extension(path);
  make_names_unique(scene);
  LUM_TRY_VOID(repair(scene, path, extension != ".gltf" && extension != ".glb", diagnostics));
  hang(scene);  // cameras and backdrops are fitted to skins where their joints hold them
  if (scene.cameras.empty()) scene.cameras.push_back(automatic_camera(scene));
  add_backdrops(scene, options);
  make_names_unique(scene);
  fit_clip_planes(scene);
  return scene;
}

}  // namespace luminist
