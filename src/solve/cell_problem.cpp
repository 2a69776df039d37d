#include "solve/cell_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "base/check.h"
#include "solve/objective.h"

namespace luminist {
namespace {

ColorRange range_of(const ParamState& state, const PartColor& color, const SceneFrame& frame) {
  ColorRange range;
  const ParamBlock& params = *state.blocks()[static_cast<std::size_t>(color.block)];
  const ParamSpec& spec = params.schema()[color.param];
  // The map knows what 0 and 1 mean on any scale.
  ParamBlock alone = params;
  alone.set_param_locked(-1, true);
  alone.set_param_locked(color.param, false);
  const std::array<const ParamBlock*, 1> blocks{&alone};
  const UnitMap map = UnitMap::create(blocks, frame);
  const std::array<ParamBlock*, 1> writable{&alone};
  for (const bool upper : {false, true}) {
    const std::vector<double> x(static_cast<std::size_t>(map.dofs()), upper ? 1.0 : 0.0);
    map.from_unit(x, writable);
    for (std::size_t c = 0; c < 3; ++c) {
      (upper ? range.high : range.low)[c] = alone.get(color.param, static_cast<int>(c));
    }
  }
  for (std::size_t c = 0; c < 3; ++c) range.free[c] = !params.locked(spec.first_dof + static_cast<int>(c));
  return range;
}

}  // namespace

Result<CellProblem> CellProblem::create(Renderer& renderer, const PictureParts& parts, const Level& level,
                                        const ParamState& free, Norm norm, const CellField& still) {
  CellProblem problem;
  problem.renderer_ = &renderer;
  problem.parts_ = &parts;
  problem.level_ = &level;
  problem.norm_ = norm;
  const std::size_t count = parts.list().size();
  std::vector<bool> is_free(count, false);
  const std::vector<const ParamBlock*> blocks = free.blocks();
  const UnitMap map = UnitMap::create(blocks, renderer.frame());
  const std::vector<int> moving = moving_lights(free, map);
  for (const Dof& dof : map.list()) {
    if (parts.color_of(dof) >= 0) continue;  // white parts stay as they are
    for (const int part : parts.touched_by(free, dof)) is_free[static_cast<std::size_t>(part)] = true;
  }
  const CellField nothing(static_cast<std::size_t>(level.cells.size()), Vec3(0.0F));
  problem.fixed_.resize(count);
  problem.offset_ = nothing;
  for (const PartColor& color : parts.colors()) {
    problem.ranges_.push_back(range_of(free, color, renderer.frame()));
  }
  // What the style's colours scale without lights is not told from the rest in a picture.
  const bool splits = std::ranges::any_of(parts.colors(), [](const PartColor& color) { return color.of_style; });
  std::vector<Request> requests;
  for (std::size_t part = 0; part < count; ++part) {
    const Part& each = parts.list()[part];
    const bool base = each.light == Candidate::kNoLights;
    if (is_free[part]) {
      problem.free_parts_.push_back(static_cast<int>(part));
    } else if (!still.empty() && std::ranges::find(moving, each.light) == moving.end() && !(base && splits)) {
      problem.fixed_[part] = base ? still : nothing;
    } else {
      requests.push_back({&free, static_cast<int>(part)});
    }
  }
  LUM_TRY(std::vector<CellField> fields, problem.evaluate(requests));
  for (std::size_t i = 0; i < requests.size(); ++i) {
    problem.fixed_[static_cast<std::size_t>(requests[i].part)] = std::move(fields[i]);
  }
  return problem;
}

Result<std::vector<CellField>> CellProblem::evaluate(std::span<const Request> requests) const {
  if (requests.empty()) return std::vector<CellField>{};
  std::vector<ParamState> states;
  states.reserve(requests.size());
  std::vector<Candidate> candidates;
  std::map<int, const ParamState*> white;  // of the present request's state, by what of the style is white in it
  constexpr int kTogether = -2;            // no parameter, and not what a rest has
  const ParamState* last = nullptr;
  for (const Request& request : requests) {
    if (request.state != last) white.clear();
    last = request.state;
    const Part& part = parts_->list()[static_cast<std::size_t>(request.part)];
    const auto known = white.try_emplace(request.together ? kTogether : part.style_color, nullptr).first;
    if (known->second == nullptr) {
      states.push_back(request.together ? parts_->whitened(*request.state)
                                        : parts_->whitened(*request.state, request.part));
      known->second = &states.back();
    }
    candidates.push_back({known->second, part.light});
  }
  const SampleSet& samples = level_->cells.samples;
  const std::size_t count = samples.pixels.size();
  std::vector<Vec3> out(candidates.size() * count);
  LUM_TRY_VOID(renderer_->evaluate(candidates, samples, level_->softness, out));
  for (Vec3& value : out) {
    if (!is_finite(value)) value = Vec3(0.0F);  // one mad sample must not stop a search
  }
  std::vector<CellField> fields;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    fields.push_back(level_->cells.average(std::span(out).subspan(i * count, count)));
  }
  std::size_t rest = 0;
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const Part& part = parts_->list()[static_cast<std::size_t>(requests[i].part)];
    if (part.rest == requests[i].part) rest = i;
    if (part.style_color < 0) continue;
    LUM_CHECK(requests[rest].state == requests[i].state && requests[rest].part == part.rest, "the rest comes first");
    for (std::size_t c = 0; c < fields[i].size(); ++c) fields[i][c] -= fields[rest][c];
  }
  return fields;
}

Result<std::vector<CellPoint>> CellProblem::measure(std::vector<ParamState> states, const CellPoint* base,
                                                    std::span<const int> changed) const {
  const std::span<const int> wanted = base != nullptr ? changed : std::span<const int>(free_parts_);
  for (ParamState& state : states) keep_constraints(state.rig);
  std::vector<Request> requests;
  for (const ParamState& state : states) {
    for (const int part : wanted) requests.push_back({&state, part});
  }
  LUM_TRY(std::vector<CellField> fields, evaluate(requests));
  std::vector<CellPoint> points;
  std::size_t next = 0;
  for (ParamState& state : states) {
    CellPoint point{std::move(state), base != nullptr ? base->fields : fixed_, 0.0};
    for (const int part : wanted) point.fields[static_cast<std::size_t>(part)] = std::move(fields[next++]);
    settle(point);
    points.push_back(std::move(point));
  }
  return points;
}

Result<CellPoint> CellProblem::measure(const ParamState& state) const {
  LUM_TRY(std::vector<CellPoint> points, measure({state}, nullptr, {}));
  return std::move(points.front());
}

Result<CellPoint> CellProblem::measure_as_is(const ParamState& state) const {
  std::vector<Request> requests;
  for (const int part : free_parts_) requests.push_back({&state, part});
  LUM_TRY(std::vector<CellField> fields, evaluate(requests));
  CellPoint point{state, fixed_, 0.0};
  for (std::size_t i = 0; i < free_parts_.size(); ++i) {
    point.fields[static_cast<std::size_t>(free_parts_[i])] = std::move(fields[i]);
  }
  point.cost = cell_cost(level_->cells, picture(point), norm_);
  return point;
}

void CellProblem::correct(const CellPoint& point, const CellField& shown) {
  const CellField sampled = picture(point);
  for (std::size_t c = 0; c < offset_.size(); ++c) offset_[c] += shown[c] - sampled[c];
}

CellField CellProblem::white(const CellPoint& point, int color) const {
  CellField sum(static_cast<std::size_t>(level_->cells.size()), Vec3(0.0F));
  const PartColor& scaling = parts_->colors()[static_cast<std::size_t>(color)];
  for (const ColoredPart& colored : scaling.parts) {
    const auto part = static_cast<std::size_t>(colored.part);
    const Vec3 factor = colored.factor * part_color_without(point.state, parts_->list()[part], scaling.of_style);
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += factor * point.fields[part][c];
  }
  return sum;
}

CellField CellProblem::together(const CellPoint& point, int rest) const {
  CellField sum(static_cast<std::size_t>(level_->cells.size()), Vec3(0.0F));
  for (std::size_t part = static_cast<std::size_t>(rest); part < point.fields.size(); ++part) {
    const Part& each = parts_->list()[part];
    if (each.rest != rest) break;
    const Vec3 color = part_color_without(point.state, each, false);
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += color * point.fields[part][c];
  }
  return sum;
}

CellField CellProblem::picture(const CellPoint& point) const {
  CellField sum = offset_;
  for (std::size_t part = 0; part < point.fields.size(); ++part) {
    const Vec3 color = part_color(point.state, parts_->list()[part]);
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += color * point.fields[part][c];
  }
  return sum;
}

bool CellProblem::solve_colors_of(CellPoint& point, bool style) const {
  CellField rest = offset_;
  std::vector<CellField> sums;
  std::vector<ColorRange> ranges;
  std::vector<Vec3> colors;
  std::vector<std::size_t> solved;
  std::vector<bool> scaled(point.fields.size(), false);  // by one of the colours that are solved
  const std::vector<ParamBlock*> blocks = point.state.blocks();
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    const PartColor& color = parts_->colors()[k];
    const ColorRange& range = ranges_[k];
    if (color.of_style != style || (!range.free[0] && !range.free[1] && !range.free[2])) continue;
    for (const ColoredPart& colored : color.parts) scaled[static_cast<std::size_t>(colored.part)] = true;
    sums.push_back(white(point, static_cast<int>(k)));
    ranges.push_back(range);
    colors.push_back(blocks[static_cast<std::size_t>(color.block)]->vec3(color.param));
    solved.push_back(k);
  }
  if (solved.empty()) return false;
  for (std::size_t part = 0; part < point.fields.size(); ++part) {
    if (scaled[part]) continue;
    const Vec3 color = part_color(point.state, parts_->list()[part]);
    for (std::size_t c = 0; c < rest.size(); ++c) rest[c] += color * point.fields[part][c];
  }
  for (std::size_t k = 0; k < colors.size(); ++k) {
    for (int c = 0; c < 3; ++c) {
      const auto channel = static_cast<std::size_t>(c);
      if (!ranges[k].free[channel]) continue;
      colors[k][c] = std::clamp(colors[k][c], static_cast<float>(ranges[k].low[channel]),
                                static_cast<float>(ranges[k].high[channel]));
    }
  }
  std::vector<const CellField*> white;
  for (const CellField& sum : sums) white.push_back(&sum);
  solve_colors(level_->cells, rest, white, ranges, norm_, colors);
  for (std::size_t k = 0; k < solved.size(); ++k) {
    const PartColor& color = parts_->colors()[solved[k]];
    blocks[static_cast<std::size_t>(color.block)]->set_vec3(color.param, colors[k]);
  }
  if (!point.state.rig.constraints.empty()) keep_constraints(point.state.rig);  // colours that follow those
  return true;
}

void CellProblem::settle(CellPoint& point) const {
  constexpr int kTurns = 3;       // of the lights' colours and the style's: the picture is a product of both
  constexpr double kGain = 0.01;  // a turn that gains less was the last
  const bool of_lights = solve_colors_of(point, false);
  const bool both = solve_colors_of(point, true) && of_lights;
  point.cost = cell_cost(level_->cells, picture(point), norm_);
  for (int turn = 1; both && turn < kTurns; ++turn) {
    const double before = point.cost;
    solve_colors_of(point, false);
    solve_colors_of(point, true);
    point.cost = cell_cost(level_->cells, picture(point), norm_);
    if (point.cost > (1.0 - kGain) * before) return;
  }
}

}  // namespace luminist
