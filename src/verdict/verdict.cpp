#include "verdict/verdict.h"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace luminist {
namespace {

using Json = nlohmann::json;

Json vector_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Json optional_json(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json remedy_json(const Remedy& remedy) {
  constexpr std::array kNames = {"none", "unlock", "add_light", "importance", "restart"};
  Json json = {{"kind", kNames[static_cast<std::size_t>(remedy.kind)]}, {"text", remedy.text}};
  if (remedy.kind == Remedy::Kind::kUnlock) json["patterns"] = remedy.patterns;
  if (remedy.kind == Remedy::Kind::kImportance) {
    json["stroke"] = remedy.stroke;
    json["importance"] = remedy.importance;
  }
  if (remedy.light) {
    json["light"] = {{"at", vector_json(remedy.light->hot_spot)},
                     {"position", vector_json(remedy.light->position)},
                     {"direction", vector_json(remedy.light->direction)},
                     {"color", vector_json(remedy.light->intensity)}};
  }
  return json;
}

}  // namespace

const char* to_string(StrokeOutcome outcome) {
  constexpr std::array kNames = {"met", "missed", "conflicting", "impossible"};
  return kNames[static_cast<std::size_t>(outcome)];
}

const char* to_string(Cause cause) {
  constexpr std::array kNames = {"",
                                 "search ended",
                                 "nothing there",
                                 "surface faces away",
                                 "darker than locked light allows",
                                 "locked parameter",
                                 "strokes disagree",
                                 "rest of the picture disagrees",
                                 "needs another light",
                                 "beyond light"};
  return kNames[static_cast<std::size_t>(cause)];
}

std::string verdict_line(const StrokeVerdict& stroke) {
  std::string line = fmt::format("{}: {}", stroke.label, to_string(stroke.outcome));
  if (!stroke.text.empty()) line += ", " + stroke.text;
  if (!stroke.remedy.text.empty()) line += "; " + stroke.remedy.text;
  return line;
}

Json verdict_to_json(const Verdict& verdict) {
  Json strokes = Json::array();
  for (const StrokeVerdict& stroke : verdict.strokes) {
    Json json = {{"stroke", stroke.stroke},
                 {"label", stroke.label},
                 {"outcome", to_string(stroke.outcome)},
                 {"cause", to_string(stroke.cause)},
                 {"text", stroke.text},
                 {"remedy", remedy_json(stroke.remedy)},
                 {"wished", stroke.wished},
                 {"missed", stroke.missed},
                 {"least_missed", optional_json(stroke.least_missed)},
                 {"near_missed", optional_json(stroke.near_missed)}};
    if (stroke.other != 0) json["other"] = stroke.other;
    strokes.push_back(std::move(json));
  }
  return {{"epsilon", verdict.epsilon},
          {"least_epsilon", optional_json(verdict.least_epsilon)},
          {"estimated_epsilon", optional_json(verdict.estimated_epsilon)},
          {"strokes", std::move(strokes)}};
}

}  // namespace luminist
