#pragma once
// scene/readers.h -- the file formats behind load_scene(). A reader returns what the file says, with every index inside
// its array; normals are empty where the file has none, and load_scene() repairs and completes the rest.
#include <string>

#include "base/diagnostics.h"
#include "base/result.h"
#include "scene/scene.h"

namespace luminist {

/// ".obj" of "Jug.OBJ"; only the letters A to Z are made small.
std::string lower_extension(const std::string& path);

/// .obj and its .mtl (tinyobjloader). Every group or object becomes one Object for each of its materials.
Result<Scene> read_obj(const std::string& path, Diagnostics& diagnostics);

/// .gltf and .glb (tinygltf), with KHR_lights_punctual; Object::backdrop is read from the node's extras.
Result<Scene> read_gltf(const std::string& path, Diagnostics& diagnostics);

/// .ply, .stl and .off: one Object. Read by hand: a guard that makes CGAL's readers of these formats safe has to walk
/// over every count and number of the file, and so is already a reader; ours also says where a file is broken.
Result<Scene> read_polygons(const std::string& path, Diagnostics& diagnostics);

}  // namespace luminist
