#include "project/layer_document.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "params/param_text.h"
#include "project/peak_json.h"
#include "project/tile_planes.h"

namespace luminist {
namespace {

using Json = nlohmann::json;

constexpr const char* kLayers = "paint/layers/";
constexpr const char* kKept = "paint/kept/";
constexpr const char* kCounts = "paint/counts/";
constexpr const char* kSources = "paint/sources/";
constexpr const char* kGround = "paint/ground";

/// The path of paint by number, from all of one kind.
template <class Visit>
Result<void> for_each_number(const Document& document, const std::string& prefix, const Visit& visit) {
  const auto& entries = document.entries();
  for (auto entry = entries.lower_bound(prefix); entry != entries.end() && entry->first.starts_with(prefix); ++entry) {
    std::uint32_t number = 0;
    const char* end = entry->first.data() + entry->first.size();
    const auto [rest, error] = std::from_chars(entry->first.data() + prefix.size(), end, number);
    if (error != std::errc() || rest != end) return wrong_paint(entry->first, "a number is wanted at the end");
    LUM_TRY_VOID(visit(number, entry->first, Json::parse(entry->second, nullptr, false)));
  }
  return {};
}

Result<PaintLayer> layer_from(const Json& json, const std::string& path) {
  const bool whole = json.is_object() && json.contains("name") && json["name"].is_string() &&
                     json.contains("visible") && json["visible"].is_boolean() && json.contains("opacity") &&
                     json["opacity"].is_number() && json.contains("strokes") && json["strokes"].is_array();
  if (!whole) return wrong_paint(path, "name, visible, opacity and strokes are wanted");
  PaintLayer layer;
  layer.name = json["name"].get<std::string>();
  layer.visible = json["visible"].get<bool>();
  layer.opacity = static_cast<float>(json["opacity"].get<double>());
  for (const Json& number : json["strokes"]) {
    if (!number.is_number_unsigned()) return wrong_paint(path, "numbers of strokes are wanted");
    layer.strokes.push_back(number.get<std::uint32_t>());
  }
  return layer;
}

/// The stroke, and the name of what it copies.
Result<KeptStroke> kept_from(const Json& json, const std::string& path) {
  if (!json.is_object() || !json.contains("stroke")) return wrong_paint(path, "a stroke is wanted");
  KeptStroke kept;
  LUM_TRY(StrokeFile file, parse_strokes(Json{{"strokes", Json::array({json["stroke"]})}}.dump(), path));
  kept.stroke = std::move(file.strokes.front());
  if (json.contains("peak")) {
    LUM_TRY(kept.peak, peak_from_json(json["peak"], path));
  }
  return kept;
}

Json json_of(const KeptStroke& kept, const std::string& source) {
  const Json strokes = Json::parse(strokes_to_json({0.0F, 0.0F, {kept.stroke}}));
  Json json = {{"stroke", strokes["strokes"][0]}};
  if (kept.peak) json["peak"] = peak_to_json(*kept.peak);
  if (!source.empty()) json["source"] = source;
  return json;
}

std::string name_of(const Image& image) {
  return content_hash({reinterpret_cast<const char*>(image.data.data()), image.data.size() * sizeof(float)});
}

/// Images that strokes copy, each once. returns their names.
Result<std::map<const Image*, std::string>> write_sources(const LayerStack& layers, Document& document,
                                                          TileStore& tiles) {
  std::map<const Image*, std::string> names;
  for (const auto& [number, kept] : layers.strokes) {
    const Image* source = kept->source.get();
    if (source == nullptr || names.contains(source)) continue;
    names[source] = name_of(*source);
    const std::string plane = kSources + names[source];
    document.set(plane + "/channels", Json(source->channels).dump());
    LUM_TRY_VOID(write_plane(*source, plane, document, tiles));
  }
  return names;
}

Result<std::shared_ptr<const Image>> read_source(const Document& document, const TileStore& tiles,
                                                 const std::string& name, int width, int height) {
  const std::string plane = kSources + name;
  const Json channels = Json::parse(document.get(plane + "/channels"), nullptr, false);
  if (!channels.is_number_unsigned() || channels.get<unsigned>() < 1 || channels.get<unsigned>() > 4) {
    return wrong_paint(plane + "/channels", "1 to 4 channels are wanted");
  }
  Image image(width, height, channels.get<int>());
  LUM_TRY_VOID(read_plane(document, plane, tiles, image));
  return std::make_shared<const Image>(std::move(image));
}

Result<void> read_sources(const Document& document, const TileStore& tiles, int width, int height, LayerStack& layers) {
  std::map<std::string, std::shared_ptr<const Image>> known;
  for (auto& [number, kept] : layers.strokes) {
    const std::string path = kKept + std::to_string(number);
    const Json json = Json::parse(document.get(path), nullptr, false);
    if (!json.contains("source")) continue;
    if (!json["source"].is_string()) return wrong_paint(path, "the name of a source is wanted");
    std::shared_ptr<const Image>& source = known[json["source"].get<std::string>()];
    if (!source) {
      LUM_TRY(source, read_source(document, tiles, json["source"].get<std::string>(), width, height));
    }
    KeptStroke whole = *kept;
    whole.source = source;
    kept = std::make_shared<const KeptStroke>(std::move(whole));
  }
  return {};
}

Image as_image(const std::vector<std::uint32_t>& strokes, int width, int height) {
  Image image(width, height, 1);
  std::transform(strokes.begin(), strokes.end(), image.data.begin(),
                 [](std::uint32_t stroke) { return static_cast<float>(stroke); });
  return image;
}

std::string ground(const char* plane) {
  return fmt::format("{}/{}", kGround, plane);
}

Result<void> write_ground(const PaintPlanes& planes, Document& document, TileStore& tiles) {
  const Image strokes = as_image(planes.stroke, planes.color.width, planes.color.height);
  LUM_TRY_VOID(write_plane(planes.color, ground("color"), document, tiles));
  LUM_TRY_VOID(write_plane(planes.left, ground("left"), document, tiles));
  LUM_TRY_VOID(write_plane(strokes, ground("stroke"), document, tiles));
  if (planes.importance.empty()) return {};
  return write_plane(planes.importance, ground("importance"), document, tiles);
}

Result<PaintPlanes> read_ground(const Document& document, const TileStore& tiles, const CanvasState& canvas) {
  const int width = canvas.target.color.width;
  const int height = canvas.target.color.height;
  PaintPlanes planes{Image(width, height, 3), Image(width, height, 1), canvas.target.stroke, {}};
  Image strokes(width, height, 1);
  LUM_TRY_VOID(read_plane(document, ground("color"), tiles, planes.color));
  LUM_TRY_VOID(read_plane(document, ground("left"), tiles, planes.left));
  LUM_TRY_VOID(read_plane(document, ground("stroke"), tiles, strokes));
  const auto counts = [&](float number) { return number >= 0.0F && number <= static_cast<float>(canvas.strokes); };
  if (!std::all_of(strokes.data.begin(), strokes.data.end(), counts)) {
    return wrong_paint(ground("stroke"), "a tile names a stroke that is not there");
  }
  std::transform(strokes.data.begin(), strokes.data.end(), planes.stroke.begin(),
                 [](float number) { return static_cast<std::uint32_t>(number); });
  if (has_plane(document, ground("importance"))) {
    planes.importance = Image(width, height, 2);
    LUM_TRY_VOID(read_plane(document, ground("importance"), tiles, planes.importance));
  }
  return planes;
}

}  // namespace

Result<void> write_layers(const LayerStack& layers, Document& document, TileStore& tiles) {
  for (const char* prefix : {kLayers, kKept, kCounts, kSources, "paint/ground/"}) document.erase_below(prefix);
  const LayerStack plain;
  const bool untouched = layers.empty() && layers.layers.size() == 1 && layers.layers[0].name == plain.layers[0].name &&
                         layers.layers[0].visible && layers.layers[0].opacity == 1.0F;
  if (untouched) return {};
  for (std::size_t i = 0; i < layers.layers.size(); ++i) {
    const PaintLayer& layer = layers.layers[i];
    const Json json = {{"name", layer.name},
                       {"visible", layer.visible},
                       {"opacity", shortest_double(layer.opacity)},
                       {"strokes", layer.strokes}};
    document.set(kLayers + std::to_string(i), json.dump());
  }
  LUM_TRY(const auto names, write_sources(layers, document, tiles));
  for (const auto& [number, kept] : layers.strokes) {
    const std::string source = kept->source ? names.at(kept->source.get()) : "";
    document.set(kKept + std::to_string(number), json_of(*kept, source).dump());
  }
  for (const auto& [number, counts] : layers.counts) {
    document.set(kCounts + std::to_string(number), Json(shortest_double(counts)).dump());
  }
  return layers.ground ? write_ground(*layers.ground, document, tiles) : Result<void>();
}

Result<LayerStack> read_stack(const Document& document) {
  LayerStack stack;
  std::map<std::uint32_t, PaintLayer> layers;
  LUM_TRY_VOID(for_each_number(document, kLayers, [&](std::uint32_t i, const std::string& path, const Json& json) {
    auto layer = layer_from(json, path);
    if (layer) layers[i] = std::move(*layer);
    return layer ? Result<void>() : std::move(layer).error();
  }));
  LUM_TRY_VOID(for_each_number(document, kKept, [&](std::uint32_t i, const std::string& path, const Json& json) {
    auto kept = kept_from(json, path);
    if (kept) stack.strokes[i] = std::make_shared<const KeptStroke>(std::move(*kept));
    return kept ? Result<void>() : std::move(kept).error();
  }));
  LUM_TRY_VOID(for_each_number(document, kCounts, [&](std::uint32_t i, const std::string& path, const Json& json) {
    if (!json.is_number() || !(json.get<double>() >= 0.0)) return Result<void>(wrong_paint(path, "a weight is wanted"));
    stack.counts[i] = static_cast<float>(json.get<double>());
    return Result<void>();
  }));
  if (!layers.empty()) stack.layers.clear();
  for (auto& [i, layer] : layers) stack.layers.push_back(std::move(layer));
  stack.active = stack.layers.size() - 1;
  if (auto good = check_stack(stack); !good) return wrong_paint(kLayers + good.error().field, good.error().what);
  return stack;
}

bool has_ground(const Document& document) {
  return has_plane(document, ground("color")) ||
         (has_plane(document, "paint/color") && !document.has("paint/layers/0"));
}

Result<void> read_layers(const Document& document, const TileStore& tiles, CanvasState& canvas) {
  LUM_TRY(LayerStack stack, read_stack(document));
  if (!stack.strokes.empty() && stack.strokes.rbegin()->first > canvas.strokes) {
    return wrong_paint(kKept + std::to_string(stack.strokes.rbegin()->first), "a number above \"paint/strokes\"");
  }
  LUM_TRY_VOID(read_sources(document, tiles, canvas.target.color.width, canvas.target.color.height, stack));
  if (has_plane(document, ground("color"))) {
    LUM_TRY(PaintPlanes planes, read_ground(document, tiles, canvas));
    stack.ground = std::make_shared<const PaintPlanes>(std::move(planes));
  } else if (has_ground(document)) {
    stack.ground = std::make_shared<const PaintPlanes>(
        PaintPlanes{canvas.target.color, canvas.paint_left, canvas.target.stroke, canvas.importance.paint});
  }
  canvas.layers = std::move(stack);
  return {};
}

}  // namespace luminist
