#include "style/style.h"

#include <algorithm>

#include <fmt/format.h>

#include "params/toml_reader.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "styles";
constexpr const char* kManifest = "style.toml";
constexpr int kMaxGoldenSize = 4096;
constexpr double kMaxBlur = 0.5;
constexpr const char* kSumWord = "sum";

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

/// The GLSL file beside the manifest; a mistake is reported where it is named.
std::string read_shade(TomlReader& read, const fs::path& manifest) {
  const std::string name = read.string("shade");
  if (name.empty()) return "";
  const auto path = resolve_beside(manifest, name);
  if (path) return path->string();
  read.fail("shade", path.error().what, path.error().hint);
  return "";
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

Result<GoldenCase> read_golden(const TomlValue& table, const std::vector<GoldenCase>& others, const std::string& path) {
  TomlReader read(table, path, ErrorKind::kStyle);
  GoldenCase golden;
  golden.name = read.string("name");
  golden.scene = read.string("scene");
  golden.rig = read.string("rig", "");
  golden.camera = read.string("camera", "");
  golden.width = read_side(read, "width");
  golden.height = read_side(read, "height");
  golden.set = read.strings("set");
  golden.max_difference = read_difference(read, "max_difference");
  golden.mean_difference = read_difference(read, "mean_difference");
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
  return choice < choices.size() && choices[choice] == kSumWord ? LightCombination::kSum : LightCombination::kJoint;
}

Result<Style> load_style(const AssetRoots& roots, const std::string& name) {
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
  style.glsl_path = read_shade(read, manifest);
  LUM_TRY(style.schema, ParamSchema::parse(text, path));
  read_lights(read, style);
  const TomlValue* metric = read.table("metric");
  const std::span<const TomlValue> golden = read.tables("golden");
  read.tables("param");
  LUM_TRY_VOID(read.finish());

  LUM_TRY(style.metric, read_metric(metric, path));
  for (const TomlValue& table : golden) {
    LUM_TRY(GoldenCase one, read_golden(table, style.golden, path));
    style.golden.push_back(std::move(one));
  }
  return style;
}

std::vector<std::string> style_names(const AssetRoots& roots) {
  std::vector<std::string> names;
  for (const std::string& folder : roots.list(kFolder, "")) {
    if (roots.find(fs::path(kFolder) / folder / kManifest)) names.push_back(folder);
  }
  return names;
}

}  // namespace luminist
