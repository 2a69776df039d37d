#include <CLI/CLI.hpp>
#include <optional>

#include <fmt/format.h>

#include "cli/verb.h"
#include "params/param_text.h"
#include "rig/light_type.h"
#include "scene/material_params.h"
#include "style/style.h"

namespace luminist {
namespace {

Result<int> doc(VerbContext& context) {
  Console& console = context.console;
  LUM_TRY(const LightTypes types, LightTypes::load(context.roots));
  console.result(
      "# Lights\n\nParameters of a light NAME are lights/NAME/PARAMETER; \"free\" ones are unlocked when it is "
      "added.");
  for (const LightType& type : types.all()) {
    console.result(fmt::format("\n## {}\n\n{}\n\n{}", type.name, type.doc, doc_table(*type.schema)));
  }
  console.result(
      fmt::format("\n## ambient\n\nLight without a place: ambient/PARAMETER.\n\n{}", doc_table(*types.ambient())));
  LUM_TRY(const auto materials, load_material_schema(context.roots));
  console.result(
      fmt::format("\n# Materials\n\nParameters of a scene's material NAME are materials/NAME/PARAMETER, locked until "
                  "they are unlocked by that name; defaults of specular and roughness are the scene's own.\n\n{}",
                  doc_table(*materials)));
  console.result("\n# Styles\n\nParameters of the style in use are style/PARAMETER.");
  std::optional<Error> broken;
  for (const std::string& name : style_names(context.roots)) {
    const Result<Style> style = load_style(context.roots, name);
    if (!style) {  // the others can still be read about
      broken = style.error();
      console.result(fmt::format("\n## {}\n\n{}", name, style.error().message()));
      continue;
    }
    console.result(fmt::format("\n## {}\n\n{}\n\n{}", style->name, style->doc, doc_table(*style->schema)));
  }
  if (broken) return *broken;
  return 0;
}

}  // namespace

Verb declare_doc(CLI::App& app) {
  app.footer("Example:\n  luminist doc | less");
  return doc;
}

}  // namespace luminist
