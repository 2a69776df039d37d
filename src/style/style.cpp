#include "style/style.h"

#include <algorithm>

#include <fmt/format.h>

#include "params/spec_rules.h"
#include "params/toml_reader.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "styles";
constexpr const char* kManifest = "style.toml";
constexpr int kMaxGoldenSize = 4096;
constexpr double kMaxBlur = 0.5;
constexpr int kMaxLevels = 12;
constexpr std::size_t kMaxTextures = 8;
constexpr const char* kSumWord = "sum";
constexpr const char* kKeyWord = "key";

void read_lights(TomlReader& read, Style& style) {
  const std::string word = read.string("lights", "joint");
  if (word == kSumWord) style.lights = LightCombination::kSum;
  if (word == kSumWord || word == "joint") return;
  const std::optional<int> param = style.schema->find(word);
  if (param && std::ranges::count((*style.schema)[*param].choices, kSumWord) > 0) {
    style.lights_param = *param;
    return;
  }
  read.fail("lights", fmt::format("unknown combination \"{}\"", word),
            "one of sum, joint, or a parameter of type choice with the word sum");
}

/// A file beside the manifest, "" where the key is missing; a mistake is reported where the file is named.
std::string read_beside(TomlReader& read, const fs::path& manifest, std::string_view key) {
  const std::string name = read.string(key, "");
  if (name.empty()) return "";  // left out; or no string, which is reported already
  const auto path = resolve_beside(manifest, name);
  if (path) return path->string();
  read.fail(key, path.error().what, path.error().hint);
  return "";
}

void read_engine(TomlReader& read, Style& style) {
  const std::string word = read.string("engine", "raster");
  if (word == "path") style.engine = StyleEngine::kPath;
  if (word != "path" && word != "raster") {
    read.fail("engine", fmt::format("unknown engine \"{}\"", word), "one of raster, path");
  }
}

/// The style's GLSL: `shade`, or `ink` of a style that draws lines over others.
void read_shaders(TomlReader& read, const fs::path& manifest, Style& style) {
  read_engine(read, style);
  if (style.engine == StyleEngine::kPath) return;  // `shade` and `ink` are unknown keys then
  style.ink_path = read_beside(read, manifest, "ink");
  if (!style.ink_path.empty()) return;
  style.glsl_path = read_beside(read, manifest, "shade");
  if (style.glsl_path.empty())
    read.fail("shade", "\"shade\" is missing", "name the GLSL file, as shade = \"style.glsl\"");
}

/// Whether GLSL may call a texture so: as a parameter, and not as what the host declares.
bool is_texture_name(const std::string& name) {
  static constexpr std::string_view kHost = " style shade ink light ambient ";
  ParamSpec spec;
  spec.name = name;
  spec.default_value = {0.0};
  const auto fault = find_fault(spec);
  return !(fault && fault->key == "name") && !name.starts_with("lum_") &&
         kHost.find(fmt::format(" {} ", name)) == std::string_view::npos;
}

Result<StyleTexture> read_texture(const TomlValue& table, const Style& style, const fs::path& manifest) {
  TomlReader read(table, manifest.string(), ErrorKind::kStyle);
  StyleTexture texture;
  texture.name = read.string("name");
  texture.path = read_beside(read, manifest, "file");
  texture.levels = read.integer("levels", 0);
  texture.colors = read.boolean("colors", false);
  const auto is_taken = [&](const StyleTexture& other) { return other.name == texture.name; };
  if (!is_texture_name(texture.name)) {
    read.fail("name", fmt::format("\"{}\" cannot name a texture", texture.name),
              "use a to z, 0 to 9 and _, and no word of GLSL");
  } else if (std::ranges::any_of(style.textures, is_taken)) {
    read.fail("name", fmt::format("two textures are named \"{}\"", texture.name), "rename one of them");
  }
  if (texture.path.empty()) read.fail("file", "a texture needs a picture", "name it, as file = \"textures/ink.png\"");
  if (texture.colors && texture.levels > 0)
    read.fail("colors", "a strip of levels holds numbers", "take one of them out");
  if (texture.levels < 0 || texture.levels > kMaxLevels) {
    read.fail("levels", fmt::format("{} levels are outside 0 to {}", texture.levels, kMaxLevels));
  }
  LUM_TRY_VOID(read.finish());
  return texture;
}

int read_side(TomlReader& read, std::string_view key) {
  const int side = read.integer(key, 256);
  if (side < 1 || side > kMaxGoldenSize) {
    read.fail(key, fmt::format("the {} {} is outside 1 to {}", key, side, kMaxGoldenSize));
  }
  return side;
}

double read_difference(TomlReader& read, std::string_view key) {
  const double value = read.number(key);
  if (value < 0.0) read.fail(key, "a difference cannot be negative");
  return value;
}

Result<StyleMetric> read_metric(const TomlValue* table, const std::string& path) {
  StyleMetric metric;
  if (table == nullptr) return metric;
  TomlReader read(*table, path, ErrorKind::kStyle);
  const double blur = read.number("blur", 0.0);
  if (blur < 0.0 || blur > kMaxBlur) {
    read.fail("blur", fmt::format("the blur {} is outside 0 to {}", blur, kMaxBlur), "give a fraction of the height");
  }
  LUM_TRY_VOID(read.finish());
  metric.blur = static_cast<float>(blur);
  return metric;
}

Result<GoldenAllowance> read_allowance(const TomlValue& table, const std::string& path) {
  TomlReader read(table, path, ErrorKind::kStyle);
  GoldenAllowance allowance;
  allowance.max_difference = read_difference(read, "max_difference");
  allowance.mean_difference = read_difference(read, "mean_difference");
  allowance.reason = read.string("reason");
  if (allowance.reason.empty()) read.fail("reason", "the differences need a reason");
  LUM_TRY_VOID(read.finish());
  return allowance;
}

Result<GoldenCase> read_golden(const TomlValue& table, const Style& style, const std::string& path) {
  const std::vector<GoldenCase>& others = style.golden;
  TomlReader read(table, path, ErrorKind::kStyle);
  GoldenCase golden;
  golden.name = read.string("name");
  golden.style = read.string("style", "");
  if (golden.style.empty() != style.shades()) {
    read.fail("style", style.shades() ? "a style that shades is seen by itself" : "lines are drawn over a style",
              style.shades() ? "take the key out" : "name the style below, as style = \"toon\"");
  }
  golden.scene = read.string("scene");
  golden.rig = read.string("rig", "");
  golden.camera = read.string("camera", "");
  golden.width = read_side(read, "width");
  golden.height = read_side(read, "height");
  golden.link = read.strings("link");
  golden.set = read.strings("set");
  golden.max_difference = read_difference(read, "max_difference");
  golden.mean_difference = read_difference(read, "mean_difference");
  golden.blurred = read.boolean("blurred", false);
  golden.reason = read.string("reason");
  if (golden.reason.empty()) read.fail("reason", "the differences need a reason");
  if (golden.name.empty() || golden.name.find('/') != std::string::npos) {
    read.fail("name", fmt::format("\"{}\" cannot name a picture", golden.name), "it becomes golden/<name>.exr");
  }
  if (std::any_of(others.begin(), others.end(), [&](const GoldenCase& other) { return other.name == golden.name; })) {
    read.fail("name", fmt::format("two golden cases are named \"{}\"", golden.name), "rename one of them");
  }
  LUM_TRY_VOID(read.finish());
  return golden;
}

Error unknown_style(const AssetRoots& roots, const std::string& name) {
  const std::vector<std::string> names = style_names(roots);
  const std::string nearest = nearest_name(name, names);
  std::string hint =
      names.empty() ? "there are no styles; set LUMINIST_ROOT" : fmt::format("there are {}", fmt::join(names, ", "));
  if (!nearest.empty()) hint = fmt::format("did you mean \"{}\"? {}", nearest, hint);
  return {ErrorKind::kMissing, fmt::format("there is no style \"{}\"", name), "", "style", hint};
}

}  // namespace

LightCombination Style::combination(const ParamBlock& params) const {
  if (lights_param < 0) return lights;
  const std::vector<std::string>& choices = (*schema)[lights_param].choices;
  const auto choice = static_cast<std::size_t>(std::max(0.0, params.get(lights_param)));
  const bool sums = choice < choices.size() && (choices[choice] == kSumWord || choices[choice] == kKeyWord);
  return sums ? LightCombination::kSum : LightCombination::kJoint;
}

namespace {

Result<void> read_tables(TomlReader& read, Style& style, const fs::path& manifest) {
  const std::string path = manifest.string();
  const TomlValue* metric = read.table("metric");
  const std::span<const TomlValue> golden = read.tables("golden");
  const TomlValue* golden_gpu = read.table("golden_gpu");
  const std::span<const TomlValue> textures = read.tables("texture");
  read.tables("param");
  if (textures.size() > kMaxTextures) read.fail("texture", fmt::format("more than {} textures", kMaxTextures));
  LUM_TRY_VOID(read.finish());
  LUM_TRY(style.metric, read_metric(metric, path));
  for (const TomlValue& table : textures) {
    LUM_TRY(StyleTexture one, read_texture(table, style, manifest));
    style.textures.push_back(std::move(one));
  }
  for (const TomlValue& table : golden) {
    LUM_TRY(GoldenCase one, read_golden(table, style, path));
    style.golden.push_back(std::move(one));
  }
  if (golden_gpu != nullptr) {
    LUM_TRY(style.golden_gpu, read_allowance(*golden_gpu, path));
  }
  return {};
}

/// The style of one folder.
Result<Style> load_folder(const AssetRoots& roots, const std::string& name) {
  const std::vector<std::string> names = style_names(roots);
  if (std::find(names.begin(), names.end(), name) == names.end()) return unknown_style(roots, name);
  LUM_TRY(const fs::path manifest, roots.find(fs::path(kFolder) / name / kManifest));
  LUM_TRY(const std::string text, read_file(manifest));
  const std::string path = manifest.string();

  Style style;
  style.name = name;
  style.folder = manifest.parent_path().string();
  LUM_TRY(const TomlValue document, parse_toml(text, path, ErrorKind::kStyle));
  TomlReader read(document, path, ErrorKind::kStyle);
  style.doc = read.string("doc");
  read_shaders(read, manifest, style);
  LUM_TRY(style.schema, ParamSchema::parse(text, path));
  read_lights(read, style);
  style.strokes = read.boolean("strokes", false);
  LUM_TRY_VOID(read_tables(read, style, manifest));
  return style;
}

/// One style with the lines of another.
Result<Style> stacked(Style below, const Style& lines) {
  std::vector<ParamSpec> specs = below.schema->specs();
  specs.insert(specs.end(), lines.schema->specs().begin(), lines.schema->specs().end());
  LUM_TRY(below.schema, ParamSchema::create(std::move(specs), fmt::format("{}/{}", lines.folder, kManifest)));
  below.name = fmt::format("{}+{}", below.name, lines.name);
  below.doc = fmt::format("{} {}", below.doc, lines.doc);
  below.ink_path = lines.ink_path;
  below.ink_folder = lines.folder;
  below.strokes = below.strokes || lines.strokes;
  for (const StyleTexture& texture : lines.textures) {
    const bool taken =
        std::ranges::any_of(below.textures, [&](const auto& other) { return other.name == texture.name; });
    if (taken || below.textures.size() >= kMaxTextures) {
      return Error{ErrorKind::kStyle,
                   taken ? fmt::format("both styles have a texture \"{}\"", texture.name)
                         : fmt::format("both styles together have more than {} textures", kMaxTextures),
                   fmt::format("{}/{}", lines.folder, kManifest), "texture", taken ? "rename one of them" : ""};
    }
    below.textures.push_back(texture);
  }
  below.golden.clear();
  return below;
}

}  // namespace

Result<Style> load_style(const AssetRoots& roots, const std::string& name) {
  const std::size_t plus = name.find('+');
  LUM_TRY(Style style, load_folder(roots, name.substr(0, plus)));
  if (plus == std::string::npos) return style;
  LUM_TRY(const Style lines, load_folder(roots, name.substr(plus + 1)));
  if (style.engine == StyleEngine::kPath && !lines.shades()) {
    return Error{ErrorKind::kUsage,
                 fmt::format("\"{}\" is path traced, and lines are drawn by the raster engine", style.name), "",
                 "style", "draw lines over a style that has GLSL, as toon+outline"};
  }
  if (!style.shades() || lines.shades()) {
    return Error{ErrorKind::kUsage,
                 fmt::format("\"{}\" {}", style.shades() ? lines.name : style.name,
                             style.shades() ? "draws no lines over another style" : "only draws lines over a style"),
                 "", "style", "write a style that shades, then one that draws lines, as toon+outline"};
  }
  return stacked(std::move(style), lines);
}

Result<Style> load_whole_style(const AssetRoots& roots, const std::string& name) {
  LUM_TRY(Style style, load_style(roots, name));
  if (style.shades()) return style;
  return Error{ErrorKind::kUsage, fmt::format("the style \"{}\" only draws lines over another", name), "", "style",
               fmt::format("name the one below it, as toon+{}", name)};
}

std::vector<std::string> style_names(const AssetRoots& roots) {
  std::vector<std::string> names;
  for (const std::string& folder : roots.list(kFolder, "")) {
    if (roots.find(fs::path(kFolder) / folder / kManifest)) names.push_back(folder);
  }
  return names;
}

}  // namespace luminist
