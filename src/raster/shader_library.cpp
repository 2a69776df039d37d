#include "raster/shader_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace luminist {
namespace {

constexpr const char* kKernelFile = "shaders/raster/relight.comp";

/// One parameter block array: its struct's name and the shader's name of the array.
struct Block {
  const ParamSchema* schema;
  std::string struct_name;
  std::string array_name;
  GLuint binding;
  BlockArray array;
};

std::vector<Block> blocks_of(const RelightLayout& layout, const LightTypes& types, const Style& style) {
  std::vector<Block> blocks;
  blocks.push_back({types.ambient().get(), "Ambient", "lum_ambients", relight_binding::kAmbient, layout.ambient});
  blocks.push_back({style.schema.get(), "Style", "lum_styles", relight_binding::kStyle, layout.style});
  for (std::size_t i = 0; i < types.all().size(); ++i) {
    const LightType& type = types.all()[i];
    blocks.push_back({type.schema.get(), type.struct_name(), "lum_" + type.name,
                      relight_binding::kFirstLightType + static_cast<GLuint>(i), layout.light_types[i]});
  }
  return blocks;
}

SourceChunk bindings_chunk() {
  namespace binding = relight_binding;
  const std::pair<const char*, GLuint> names[] = {
      {"FRAME", binding::kFrame},     {"POSITION", binding::kPosition},     {"NORMAL", binding::kNormal},
      {"ALBEDO", binding::kAlbedo},   {"SPECULAR", binding::kSpecular},     {"EMISSIVE", binding::kEmissive},
      {"ENTRIES", binding::kEntries}, {"VISIBILITY", binding::kVisibility}, {"CANDIDATES", binding::kCandidates},
      {"LIGHTS", binding::kLights},   {"COLORS", binding::kColors},         {"LAYER", binding::kLayer},
      {"STROKES", binding::kStrokes}, {"LINKS", binding::kLinks},           {"MATERIALS", binding::kMaterials},
  };
  std::string text;
  for (const auto& [name, number] : names) text += fmt::format("#define LUM_{} {}\n", name, number);
  return {"<generated bindings>", text};
}

SourceChunk blocks_chunk(const std::vector<Block>& blocks, const LightTypes& types) {
  std::string text;
  for (const Block& block : blocks) {
    text += block.schema->glsl_struct(block.struct_name);
    text += fmt::format("layout(std140, binding = {}) uniform Lum{}Blocks {{ {} {}[{}]; }};\n", block.binding,
                        block.struct_name, block.struct_name, block.array_name, block.array.capacity);
  }
  text +=
      "Style style;\n"
      "void lum_load_candidate(uint candidate) {\n"
      "  lum_candidate = lum_candidates[2u * candidate];\n"
      "  lum_candidate_materials = lum_candidates[2u * candidate + 1u].xy;\n"
      "  style = lum_styles[lum_candidate.w];\n"
      "}\n";
  const auto color = types.ambient()->by_role("color");
  const std::string value = color ? "lum_ambients[lum_candidate.z]." + (*types.ambient())[*color].name : "vec3(0.0)";
  text += fmt::format("vec3 ambient() {{ return lum_candidate.z == LUM_NONE ? vec3(0.0) : {}; }}\n", value);
  return {"<generated parameters>", text};
}

/// light(i, s): nothing where the light is not linked to the object, else what the sample function of its type says, to
/// which the shadow with its density is applied.
SourceChunk lights_chunk(const std::vector<Block>& blocks, const LightTypes& types) {
  std::string text =
      "LightSample light(int i, Surface s) {\n"
      "  LightSample l = LightSample(s.normal, vec3(0.0), 0.0, 1.0, 1.0, false);\n"
      "  if (i < 0 || i >= light_count()) return l;\n"
      "  uvec4 ref = lum_lights[lum_candidate.x + uint(i)];\n"
      "  if (ref.w < LUM_KEY_OF_ALL && !lum_link(ref.w, s.object)) return l;\n"
      "  float density = 1.0;\n";
  for (std::size_t i = 0; i < types.all().size(); ++i) {
    const LightType& type = types.all()[i];
    const std::string block = blocks[i + 2].array_name + "[ref.y]";
    const auto density = type.schema->by_role("shadow");
    text += fmt::format("  {}if (ref.x == {}u) {{\n", i == 0 ? "" : "else ", i);
    text += fmt::format("    l = sample_{}({}, s);\n", type.name, block);
    if (density) text += fmt::format("    density = {}.{};\n", block, (*type.schema)[*density].name);
    text += "  }\n";
  }
  text +=
      "  l.lit = ref.z == LUM_NONE ? 1.0 : lum_visibility[ref.z * lum_frame.samples + lum_sample];\n"
      "  l.key = ref.w == LUM_KEY_OF_ALL ||\n"
      "          (ref.w < LUM_KEY_OF_ALL && lum_link(ref.w + lum_frame.link_words, s.object));\n"
      "  l.visibility = 1.0 - density * (1.0 - l.lit);\n"
      "  return l;\n"
      "}\n";
  return {"<generated lights>", text};
}

SourceChunk textures_chunk(const Style& style) {
  std::string text;
  for (std::size_t i = 0; i < style.textures.size(); ++i) {
    text += fmt::format("layout(binding = {}) uniform sampler2D {};\n", i, style.textures[i].name);
  }
  return {"<generated textures>", text};
}

/// lum_background(), where nothing is: the style's parameter of that role. lum_shade(s): the style, with lines over it
/// where it has them. A line's colour is part of what is left without lights, or multiplies what the lights do there,
/// as far as its author says.
SourceChunk shading_chunk(const Style& style) {
  const auto background = style.schema->by_role("background");
  const std::string color = background ? "style." + (*style.schema)[*background].name : "vec3(0.0)";
  const std::string empty =
      fmt::format("vec3 lum_background() {{ return lum_candidate.z == LUM_NONE ? vec3(0.0) : {}; }}\n", color);
  if (style.ink_path.empty()) {
    return {"<generated shading>", empty + "vec3 lum_shade(Surface s) { return shade(s); }\n"};
  }
  return {"<generated shading>",
          empty +
              "vec3 lum_shade(Surface s) {\n"
              "  if (s.line == LINE_NONE) return shade(s);\n"
              "  vec4 lum_ink = ink(s);\n"
              "  vec3 lit = lum_ink.a != 0.0 ? lum_ink.a * lum_ink.rgb * shade(s) : vec3(0.0);\n"
              "  return lum_candidate.z == LUM_NONE ? lit : lit + (1.0 - lum_ink.a) * lum_ink.rgb;\n"
              "}\n"};
}

/// A file outside the asset roots (a style or a light type knows its own path).
Result<SourceChunk> file_chunk(const std::string& path) {
  LUM_TRY(std::string text, read_file(path));
  return SourceChunk{path, std::move(text)};
}

}  // namespace

RelightLayout relight_layout(std::int64_t max_uniform_block_bytes, const LightTypes& types, const Style& style) {
  const auto array = [&](const ParamSchema& schema) {
    const std::size_t stride = schema.byte_size();
    return BlockArray{stride, std::max<std::size_t>(1, static_cast<std::size_t>(max_uniform_block_bytes) / stride)};
  };
  RelightLayout layout{array(*types.ambient()), array(*style.schema), {}};
  for (const LightType& type : types.all()) layout.light_types.push_back(array(*type.schema));
  return layout;
}

Result<std::vector<SourceChunk>> relight_source(const RelightLayout& layout, const LightTypes& types,
                                                const Style& style, const AssetRoots& roots) {
  const std::vector<Block> blocks = blocks_of(layout, types, style);
  std::vector<SourceChunk> chunks{bindings_chunk()};
  for (const char* file : {"shaders/lib/surface.glsl", "shaders/lib/host.glsl", "shaders/lib/helpers.glsl"}) {
    LUM_TRY(SourceChunk chunk, load_chunk(roots, file));
    chunks.push_back(std::move(chunk));
  }
  chunks.push_back(blocks_chunk(blocks, types));
  for (const LightType& type : types.all()) {
    LUM_TRY(SourceChunk chunk, file_chunk(type.glsl_path));
    chunks.push_back(std::move(chunk));
  }
  chunks.push_back(lights_chunk(blocks, types));
  LUM_TRY(SourceChunk diffuse, load_chunk(roots, "shaders/lib/diffuse.glsl"));
  chunks.push_back(std::move(diffuse));
  chunks.push_back(textures_chunk(style));
  for (const std::string* path : {&style.glsl_path, &style.ink_path}) {
    if (path->empty()) continue;
    LUM_TRY(SourceChunk file, file_chunk(*path));
    chunks.push_back(std::move(file));
  }
  chunks.push_back(shading_chunk(style));
  for (const char* file : {"shaders/raster/dispatch.glsl", kKernelFile}) {
    LUM_TRY(SourceChunk chunk, load_chunk(roots, file));
    chunks.push_back(std::move(chunk));
  }
  return chunks;
}

Result<Program> compile_relight(Device& device, const RelightLayout& layout, const LightTypes& types,
                                const Style& style, const AssetRoots& roots) {
  LUM_TRY(const auto chunks, relight_source(layout, types, style, roots));
  Result<Program> program = Program::compute(device, chunks, "style " + style.name);
  if (program) return program;
  Error error = std::move(program).error();
  // The three chunks behind the style's files are ours and right, so what is wrong there came out of the last of them.
  const bool inked = !style.ink_path.empty() && error.what.find("'shade'") == std::string::npos;
  for (std::size_t i = chunks.size() - 3; i < chunks.size(); ++i) {
    if (!error.where.starts_with(chunks[i].file + ":")) continue;
    error.where = inked ? style.ink_path : style.glsl_path;
    error.hint =
        fmt::format("the file must define `{}(Surface s)` and close every brace", inked ? "vec4 ink" : "vec3 shade");
  }
  if (inked && error.where.starts_with(style.ink_path + ":") && error.hint.empty()) {
    error.hint = fmt::format("if that line is right, a brace is open in {}", style.glsl_path);
  }
  return error;
}

}  // namespace luminist
