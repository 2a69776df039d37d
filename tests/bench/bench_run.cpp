#include "bench/bench_run.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

namespace luminist {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPoints = 200;  // of a convergence that are stored

/// The first, the last and as many between them as are kept, evenly by index.
std::vector<ConvergencePoint> thinned(const std::vector<ConvergencePoint>& points) {
  if (points.size() <= kMostPoints) return points;
  std::vector<ConvergencePoint> kept;
  for (std::size_t i = 0; i < kMostPoints; ++i) kept.push_back(points[i * (points.size() - 1) / (kMostPoints - 1)]);
  return kept;
}

Json to_json(const BenchKey& key) {
  return {{"bench", key.bench}, {"scene", key.scene},   {"task", key.task}, {"method", key.method},
          {"width", key.width}, {"height", key.height}, {"caps", key.caps}, {"seed", key.seed}};
}

BenchKey key_of(const Json& json) {
  return {json.at("bench"), json.at("scene"),  json.at("task"), json.at("method"),
          json.at("width"), json.at("height"), json.at("caps"), json.at("seed")};
}

BenchRun run_of(const Json& json) {
  BenchRun run;
  run.key = key_of(json.at("key"));
  json.at("lights").get_to(run.lights);
  json.at("dofs").get_to(run.dofs);
  json.at("success").get_to(run.success);
  json.at("capped").get_to(run.capped);
  json.at("epsilon_start").get_to(run.epsilon_start);
  json.at("epsilon").get_to(run.epsilon);
  json.at("goal").get_to(run.goal);
  json.at("evals").get_to(run.evals);
  json.at("render_equivalents").get_to(run.equivalents);
  json.at("seconds").get_to(run.seconds);
  json.at("total_render_equivalents").get_to(run.total_equivalents);
  json.at("total_seconds").get_to(run.total_seconds);
  json.at("first_seconds").get_to(run.first_seconds);
  json.at("evaluation_seconds").get_to(run.evaluation_seconds);
  for (const Json& point : json.at("convergence")) {
    run.convergence.push_back({point.at(0), point.at(1), point.at(2), point.at(3)});
  }
  return run;
}

}  // namespace

std::string BenchKey::text() const {
  return fmt::format("{}/{}/{}/{}/{}x{}/{}/{}", bench, scene, task, method, width, height, caps, seed);
}

std::string to_json_line(const BenchRun& run) {
  Json line;
  line["key"] = to_json(run.key);
  line["lights"] = run.lights;
  line["dofs"] = run.dofs;
  line["success"] = run.success;
  line["capped"] = run.capped;
  line["epsilon_start"] = run.epsilon_start;
  line["epsilon"] = run.epsilon;
  line["goal"] = run.goal;
  line["evals"] = run.evals;
  line["render_equivalents"] = run.equivalents;
  line["seconds"] = run.seconds;
  line["total_render_equivalents"] = run.total_equivalents;
  line["total_seconds"] = run.total_seconds;
  line["first_seconds"] = run.first_seconds;
  line["evaluation_seconds"] = run.evaluation_seconds;
  line["convergence"] = Json::array();
  for (const ConvergencePoint& point : thinned(run.convergence)) {
    line["convergence"].push_back({point.render_equivalents, point.evals, point.seconds, point.epsilon});
  }
  return line.dump();
}

Result<BenchRun> parse_run(const std::string& line) {
  try {
    return run_of(Json::parse(line));
  } catch (const nlohmann::json::exception& error) {
    return Error{ErrorKind::kBadContent, error.what(), "", "", ""};
  }
}

}  // namespace luminist
