#include <algorithm>
#include <cstdio>
#include <map>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/image.h"
#include "paint/located_json.h"
#include "paint/stroke.h"

namespace luminist {
namespace {

/// "#rrggbb" in sRGB.
bool read_hex(const std::string& text, Vec3& color) {
  if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) {
    return false;
  }
  const int digits = std::stoi(text.substr(1), nullptr, 16);
  for (int c = 0; c < 3; ++c) {
    color[c] = linear_from_srgb(static_cast<float>((digits >> (16 - 8 * c)) & 0xFF) / 255.0F);
  }
  return true;
}

bool all_numbers(const JsonNode& node) {
  if (node.kind != JsonNode::Kind::kArray) return false;
  for (const JsonNode& item : node.items) {
    if (item.kind != JsonNode::Kind::kNumber) return false;
  }
  return true;
}

float number(const JsonNode& node) {
  return static_cast<float>(node.number);
}

/// Turns one parsed file into strokes. Fields of errors are JSON paths: strokes[2].diameter.
class Reader {
 public:
  Reader(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  Result<StrokeFile> read(const JsonNode& root) {
    static const std::vector<std::string> keys = {"units", "height", "nu", "delta", "brushes", "strokes"};
    LUM_TRY_VOID(expect(root, JsonNode::Kind::kObject, "an object", ""));
    for (const JsonNode& item : root.items) {
      if (std::find(keys.begin(), keys.end(), item.key) == keys.end()) return unknown_key(item, keys, item.key);
    }
    LUM_TRY_VOID(read_units(root));
    StrokeFile file;
    LUM_TRY_VOID(read_weight(root, "nu", file.nu));
    LUM_TRY_VOID(read_weight(root, "delta", file.delta));
    if (const JsonNode* brushes = root.find("brushes")) LUM_TRY_VOID(read_brushes(*brushes));
    const JsonNode* strokes = root.find("strokes");
    if (strokes == nullptr) return bad(root.at, "there are no strokes", "strokes", "give \"strokes\": [...]");
    LUM_TRY_VOID(expect(*strokes, JsonNode::Kind::kArray, "a list of strokes", "strokes"));
    for (std::size_t i = 0; i < strokes->items.size(); ++i) {
      LUM_TRY(Stroke stroke, read_stroke(strokes->items[i], fmt::format("strokes[{}]", i)));
      file.strokes.push_back(std::move(stroke));
    }
    return file;
  }

  Result<Brush> read_brush(const JsonNode& root, Brush brush) const {
    LUM_TRY_VOID(expect(root, JsonNode::Kind::kObject, "an object of qualities", "brush"));
    const std::vector<std::string> keys = quality_names();
    for (const JsonNode& item : root.items) LUM_TRY_VOID(read_quality(item, keys, "brush", brush));
    return brush;
  }

 private:
  [[nodiscard]] Error bad(std::size_t at, std::string what, std::string field, std::string hint = "") const {
    return {ErrorKind::kBadContent, std::move(what), located(text_, path_, at), std::move(field), std::move(hint)};
  }
  [[nodiscard]] Error unknown_word(std::size_t at, const char* what, const std::string& word,
                                   std::span<const std::string> words, const std::string& field) const {
    const std::string near = nearest_name(word, words);
    return bad(
        at, fmt::format("unknown {} \"{}\"", what, word), field,
        near.empty() ? fmt::format("one of {}", fmt::join(words, ", ")) : fmt::format("did you mean \"{}\"?", near));
  }
  [[nodiscard]] Error unknown_key(const JsonNode& item, std::span<const std::string> keys,
                                  const std::string& field) const {
    return unknown_word(item.key_at, "key", item.key, keys, field);
  }
  Result<void> expect(const JsonNode& node, JsonNode::Kind kind, const char* wanted, const std::string& field) const {
    if (node.kind == kind) return {};
    return bad(node.at, fmt::format("{} is expected", wanted), field);
  }

  Result<void> read_units(const JsonNode& root) {
    const JsonNode* units = root.find("units");
    const JsonNode* height = root.find("height");
    static const std::vector<std::string> words = {"height", "pixels"};
    if (units != nullptr) {
      LUM_TRY_VOID(expect(*units, JsonNode::Kind::kString, "\"height\" or \"pixels\"", "units"));
      if (units->text != "height" && units->text != "pixels") {
        return unknown_word(units->at, "unit", units->text, words, "units");
      }
    }
    const bool pixels = units != nullptr && units->text == "pixels";
    if (!pixels) {
      if (height == nullptr) return {};
      return bad(height->key_at, "the height is only needed with pixels", "height", "add \"units\": \"pixels\"");
    }
    if (height == nullptr) {
      return bad(units->at, "pixels of which picture", "units", "add \"height\": the height of that picture in pixels");
    }
    LUM_TRY_VOID(expect(*height, JsonNode::Kind::kNumber, "a number of pixels", "height"));
    if (!(height->number >= 1.0 && height->number <= 65536.0)) {
      return bad(height->at, "must be from 1 to 65536 pixels", "height");
    }
    pixel_ = 1.0 / height->number;
    return {};
  }

  Result<void> read_weight(const JsonNode& root, const char* name, float& weight) const {
    const JsonNode* node = root.find(name);
    if (node == nullptr) return {};
    LUM_TRY_VOID(expect(*node, JsonNode::Kind::kNumber, "a number", name));
    if (!(node->number >= 0.0 && node->number <= 1.0)) return bad(node->at, "must be from 0 to 1", name);
    weight = number(*node);
    return {};
  }

  Result<void> read_brushes(const JsonNode& table) {
    LUM_TRY_VOID(expect(table, JsonNode::Kind::kObject, "an object of named brushes", "brushes"));
    const std::vector<std::string> keys = quality_names();
    for (const JsonNode& entry : table.items) {
      const std::string field = fmt::format("brushes.{}", entry.key);
      LUM_TRY_VOID(expect(entry, JsonNode::Kind::kObject, "an object of qualities", field));
      Brush brush;
      for (const JsonNode& item : entry.items) LUM_TRY_VOID(read_quality(item, keys, field, brush));
      brushes_.emplace(entry.key, brush);
    }
    return {};
  }

  Result<Stroke> read_stroke(const JsonNode& node, const std::string& field) const {
    LUM_TRY_VOID(expect(node, JsonNode::Kind::kObject, "an object", field));
    Stroke stroke;
    if (const JsonNode* name = node.find("brush")) LUM_TRY_VOID(look_up_brush(*name, field, stroke.brush));
    std::vector<std::string> keys = quality_names();
    keys.insert(keys.end(), {"brush", "points"});
    for (const JsonNode& item : node.items) {
      if (item.key == "brush") continue;
      if (item.key == "points") {
        LUM_TRY_VOID(read_points(item, field + ".points", stroke.points));
      } else {
        LUM_TRY_VOID(read_quality(item, keys, field, stroke.brush));
      }
    }
    if (auto good = check_stroke(stroke); !good) {
      const Error& error = good.error();
      return bad(place_of(node, error.field), error.what, fmt::format("{}.{}", field, error.field), error.hint);
    }
    return stroke;
  }

  Result<void> look_up_brush(const JsonNode& name, const std::string& field, Brush& brush) const {
    LUM_TRY_VOID(expect(name, JsonNode::Kind::kString, "the name of a brush", field + ".brush"));
    const auto found = brushes_.find(name.text);
    if (found != brushes_.end()) {
      brush = found->second;
      return {};
    }
    std::vector<std::string> names;
    for (const auto& [known, unused] : brushes_) names.push_back(known);
    if (names.empty()) {
      return bad(name.at, fmt::format("unknown brush \"{}\"", name.text), field + ".brush",
                 "describe it in \"brushes\"");
    }
    return unknown_word(name.at, "brush", name.text, names, field + ".brush");
  }

  Result<void> read_points(const JsonNode& node, const std::string& field, std::vector<StrokePoint>& points) const {
    LUM_TRY_VOID(expect(node, JsonNode::Kind::kArray, "a list of points", field));
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const JsonNode& item = node.items[i];
      if (!all_numbers(item) || item.items.size() < 2 || item.items.size() > 3) {
        return bad(item.at, "[x, y] or [x, y, pressure] is expected", fmt::format("{}[{}]", field, i));
      }
      points.push_back(
          {length(item.items[0]), length(item.items[1]), item.items.size() == 3 ? number(item.items[2]) : 1.0F});
    }
    return {};
  }

  Result<void> read_quality(const JsonNode& item, std::span<const std::string> keys, const std::string& where,
                            Brush& brush) const {
    const std::string field = fmt::format("{}.{}", where, item.key);
    for (const BrushQuality& quality : brush_qualities()) {
      if (item.key != quality.name) continue;
      LUM_TRY_VOID(std::visit([&](auto member) { return read_value(item, brush.*member, field); }, quality.member));
      if (item.key == "diameter") brush.diameter = length(item);
      if (auto good = check_quality(brush, quality); !good) return bad(item.at, good.error().what, field);
      return {};
    }
    return unknown_key(item, keys, field);
  }

  Result<void> read_value(const JsonNode& item, float& value, const std::string& field) const {
    LUM_TRY_VOID(expect(item, JsonNode::Kind::kNumber, "a number", field));
    value = number(item);
    return {};
  }
  Result<void> read_value(const JsonNode& item, bool& value, const std::string& field) const {
    LUM_TRY_VOID(expect(item, JsonNode::Kind::kBool, "true or false", field));
    value = item.boolean;
    return {};
  }
  Result<void> read_value(const JsonNode& item, std::string& value, const std::string& field) const {
    LUM_TRY_VOID(expect(item, JsonNode::Kind::kString, "a text", field));
    value = item.text;
    return {};
  }
  Result<void> read_value(const JsonNode& item, Vec3& value, const std::string& field) const {
    if (item.kind == JsonNode::Kind::kString && read_hex(item.text, value)) return {};
    if (!all_numbers(item) || item.items.size() != 3) {
      return bad(item.at, "[r, g, b] (linear) or \"#rrggbb\" (sRGB) is expected", field);
    }
    value = {number(item.items[0]), number(item.items[1]), number(item.items[2])};
    return {};
  }
  Result<void> read_value(const JsonNode& item, PaintTool& value, const std::string& field) const {
    return read_word(item, tool_words(), "tool", value, field);
  }
  Result<void> read_value(const JsonNode& item, PeakKind& value, const std::string& field) const {
    return read_word(item, peak_words(), "peak", value, field);
  }
  template <class Enum>
  Result<void> read_word(const JsonNode& item, std::span<const std::string> words, const char* what, Enum& value,
                         const std::string& field) const {
    LUM_TRY_VOID(expect(item, JsonNode::Kind::kString, "a word", field));
    const auto word = std::find(words.begin(), words.end(), item.text);
    if (word == words.end()) return unknown_word(item.at, what, item.text, words, field);
    value = static_cast<Enum>(word - words.begin());
    return {};
  }

  static std::vector<std::string> quality_names() {
    std::vector<std::string> names;
    for (const BrushQuality& quality : brush_qualities()) names.emplace_back(quality.name);
    return names;
  }
  /// Where the field that check_stroke() names stands in a stroke; the stroke itself if it is not there.
  static std::size_t place_of(const JsonNode& stroke, const std::string& field) {
    std::size_t index = 0;
    const JsonNode* points = stroke.find("points");
    if (std::sscanf(field.c_str(), "points[%zu]", &index) == 1) return points->items[index].at;
    const JsonNode* node = stroke.find(field);
    return node != nullptr ? node->at : stroke.at;
  }
  /// A length of the file in picture heights.
  [[nodiscard]] float length(const JsonNode& node) const { return static_cast<float>(node.number * pixel_); }

  const std::string& text_;
  const std::string& path_;
  double pixel_ = 1.0;  ///< the file's unit in picture heights
  std::map<std::string, Brush> brushes_;
};

std::string to_json(float value) {
  return fmt::format("{}", value);
}
std::string to_json(bool value) {
  return value ? "true" : "false";
}
std::string to_json(const Vec3& value) {
  return fmt::format("[{}, {}, {}]", value.x, value.y, value.z);
}
std::string to_json(const std::string& value) {
  return nlohmann::json(value).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}
std::string to_json(PaintTool value) {
  return to_json(tool_words()[static_cast<std::size_t>(value)]);
}
std::string to_json(PeakKind value) {
  return to_json(peak_words()[static_cast<std::size_t>(value)]);
}

/// "quality": value for each that differs.
std::vector<std::string> changes(const Brush& from, const Brush& to) {
  std::vector<std::string> items;
  for (const BrushQuality& quality : brush_qualities()) {
    std::visit(
        [&](auto member) {
          if (to.*member == from.*member) return;
          items.push_back(fmt::format("\"{}\": {}", quality.name, to_json(to.*member)));
        },
        quality.member);
  }
  return items;
}

std::string stroke_to_json(const Stroke& stroke) {
  std::string text = "    {";
  for (const std::string& item : changes(Brush(), stroke.brush)) text += item + ", ";
  text += "\"points\": [";
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    const StrokePoint& p = stroke.points[i];
    text += fmt::format("{}[{}, {}", i == 0 ? "" : ", ", p.x, p.y);
    text += p.pressure == 1.0F ? "]" : fmt::format(", {}]", p.pressure);
  }
  return text + "]}";
}

}  // namespace

Result<StrokeFile> parse_strokes(const std::string& json, const std::string& path) {
  LUM_TRY(const JsonNode root, parse_located_json(json, path));
  return Reader(json, path).read(root);
}

Result<StrokeFile> load_strokes(const std::string& path) {
  LUM_TRY(const std::string json, read_file(path));
  return parse_strokes(json, path);
}

Result<Brush> parse_brush(const std::string& json, const std::string& path, const Brush& brush) {
  LUM_TRY(const JsonNode root, parse_located_json(json, path));
  return Reader(json, path).read_brush(root, brush);
}

std::string brush_changes(const Brush& from, const Brush& to) {
  return fmt::format("{{{}}}", fmt::join(changes(from, to), ", "));
}

std::string strokes_to_json(const StrokeFile& file) {
  std::string strokes;
  for (const Stroke& stroke : file.strokes) strokes += (strokes.empty() ? "\n" : ",\n") + stroke_to_json(stroke);
  return fmt::format("{{\n  \"nu\": {},\n  \"delta\": {},\n  \"strokes\": [{}\n  ]\n}}\n", file.nu, file.delta,
                     strokes);
}

std::string stroke_reference() {
  std::string table = "| quality | default | range | |\n|-|-|-|-|\n";
  const Brush plain;
  for (const BrushQuality& quality : brush_qualities()) {
    const std::string value = std::visit([&](auto member) { return to_json(plain.*member); }, quality.member);
    table += fmt::format("| {} | {} | {} | {} |\n", quality.name, value, quality_range(quality), quality.doc);
  }
  return table;
}

}  // namespace luminist
