#include <CLI/CLI.hpp>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/verb.h"
#include "gpu/device.h"
#include "project/commands.h"
#include "rig/light_type.h"
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

}  // namespace

Verb declare_info(CLI::App& app) {
  const auto json = std::make_shared<bool>(false);  // the parser and the returned function both use it
  app.add_flag("--json", *json, "Prints one object");
  app.footer("Example:\n  luminist info --json");
  return [json](VerbContext& context) -> Result<int> {
    LUM_TRY(const auto all, facts(context.roots));
    if (*json) {
      context.console.result(all.dump());
      return 0;
    }
    for (const auto& [name, value] : all.items()) {
      context.console.result(
          fmt::format("{:24} {}", name, value.is_string() ? value.get<std::string>() : value.dump()));
    }
    return 0;
  };
}

}  // namespace luminist
