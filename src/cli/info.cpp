#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/verb.h"
#include "gpu/device.h"
#include "params/param_text.h"
#include "project/commands.h"
#include "rig/light_type.h"
#include "scene/material_params.h"
#include "studio/shot.h"
#include "style/style.h"

namespace luminist {
namespace {

/// Every fact as a flat object: what scripts read, and what is printed a line each.
Result<nlohmann::ordered_json> facts(const AssetRoots& roots) {
  LUM_TRY(const Device device, Device::create_headless());
  const DeviceInfo& gl = device.info();
  LUM_TRY(const LightTypes types, LightTypes::load(roots));
  return nlohmann::ordered_json{{"version", LUMINIST_VERSION},
                                {"project_format", kProjectFormat},
                                {"gl_vendor", gl.vendor},
                                {"gl_renderer", gl.renderer},
                                {"gl_version", gl.version},
                                {"glsl_version", gl.shading_language},
                                {"gl_platform", gl.platform},
                                {"gl_software", gl.software},
                                {"max_texture_size", gl.max_texture_size},
                                {"max_array_layers", gl.max_array_layers},
                                {"max_anisotropy", gl.max_anisotropy},
                                {"max_storage_block_bytes", gl.max_storage_block_bytes},
                                {"max_uniform_block_bytes", gl.max_uniform_block_bytes},
                                {"light_types", types.names()},
                                {"styles", style_names(roots)}};
}

/// What is in a scene, by the names that other words use: cameras, objects, lights, materials with their parameters.
Result<nlohmann::ordered_json> scene_facts(const std::string& wanted, VerbContext& context) {
  using Json = nlohmann::ordered_json;
  LUM_TRY(const std::string path, find_input(wanted, ".", context.roots));
  Diagnostics diagnostics;
  auto scene = load_scene(path, {}, diagnostics);
  context.console.warn(diagnostics);
  if (!scene) return std::move(scene).error();
  LUM_TRY(const auto schema, load_material_schema(context.roots));
  Json all{{"scene", path}, {"triangles", scene->triangle_count()}};
  for (const char* list : {"cameras", "objects", "lights"}) all[list] = Json::array();
  for (const Camera& camera : scene->cameras) all["cameras"].push_back(camera.name);
  for (const Object& object : scene->objects) all["objects"].push_back(object.name);
  for (const PunctualLight& light : scene->lights) all["lights"].push_back(light.name);
  const std::vector<MaterialParams> materials = material_params(scene->materials, *schema);
  for (std::size_t i = 0; i < materials.size(); ++i) {
    Json material = block_to_json(materials[i].params);
    material["objects"] = Json::array();
    for (const Object& object : scene->objects) {
      if (static_cast<std::size_t>(object.material) == i) material["objects"].push_back(object.name);
    }
    all["materials/" + materials[i].name] = std::move(material);
  }
  return all;
}

struct InfoWords {
  std::string scene;
  bool json = false;
};

/// Names of objects are bytes of a file; what is no UTF-8 is replaced.
std::string text_of(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

Verb declare_info(CLI::App& app) {
  const auto words = std::make_shared<InfoWords>();  // the parser and the returned function both use it
  app.add_option("SCENE", words->scene, "Tells what is in a scene, in place of what this machine has");
  app.add_flag("--json", words->json, "Prints one object");
  app.footer("Examples:\n  luminist info --json\n  luminist info meshes/still_life/still_life.glb");
  return [words](VerbContext& context) -> Result<int> {
    LUM_TRY(const auto all, words->scene.empty() ? facts(context.roots) : scene_facts(words->scene, context));
    if (words->json) {
      context.console.result(text_of(all));
      return 0;
    }
    for (const auto& [name, value] : all.items()) {
      context.console.result(
          fmt::format("{:24} {}", name, value.is_string() ? value.get<std::string>() : text_of(value)));
    }
    return 0;
  };
}

}  // namespace luminist
