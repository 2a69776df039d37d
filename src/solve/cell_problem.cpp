#include "solve/cell_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>

#include "solve/objective.h"

namespace luminist {
namespace {

/// The same rig with all colours that scale parts at one.
ParamState whitened(const ParamState& state, std::span<const Part> parts) {
  ParamState white = state;
  for (const Part& part : parts) {
    if (part.color_param >= 0) {
      white.rig.lights[static_cast<std::size_t>(part.light)].params.set_vec3(part.color_param, Vec3(1.0F));
    }
  }
  return white;
}

int color_param_of(const Light& light) {
  const std::optional<int> param = light.params.schema().by_role("color");
  if (!param || light.params.schema()[*param].type != ParamType::kColor) return -1;
  return *param;
}

/// Whether each channel of a light's part is that channel of its colour times a number.
Result<bool> scales(Renderer& renderer, const ParamState& state, const Part& part, const SampleSet& probe) {
  const Vec3 color(2.0F, 0.5F, 0.0F);
  std::array<ParamState, 2> states{state, state};
  const auto light = static_cast<std::size_t>(part.light);
  states[0].rig.lights[light].params.set_vec3(part.color_param, Vec3(1.0F));
  states[1].rig.lights[light].params.set_vec3(part.color_param, color);
  const std::array<Candidate, 2> candidates{Candidate{&states[0], part.light}, Candidate{&states[1], part.light}};
  std::vector<Vec3> out(2 * probe.pixels.size());
  LUM_TRY_VOID(renderer.evaluate(candidates, probe, {}, out));
  for (std::size_t i = 0; i < probe.pixels.size(); ++i) {
    const Vec3 wanted = color * out[i];
    const Vec3 got = out[probe.pixels.size() + i];
    if (glm::length(wanted - got) > 1e-3F * (glm::length(wanted) + 1e-3F)) return false;
  }
  return true;
}

/// The parts that one colour scales stand together: if it does not scale one of them, it is as another parameter.
void tie_colors(const LightRig& rig, std::vector<Part>& parts) {
  for (std::size_t light = 0; light < rig.lights.size(); ++light) {
    const std::optional<int> color = rig.lights[light].params.schema().by_role("color");
    if (!color) continue;
    const std::vector<Tie> ties = tied_to(rig, light, *color);
    const bool scaling =
        std::all_of(ties.begin(), ties.end(), [&](const Tie& tie) { return parts[tie.light + 1].color_param >= 0; });
    for (const Tie& tie : ties) {
      if (scaling) {
        parts[light + 1].colored.push_back({static_cast<int>(tie.light + 1), tie.factor});
      } else {
        parts[tie.light + 1].color_param = -1;
      }
    }
  }
}

ColorRange range_of(const ParamState& state, const Part& part, const SceneFrame& frame) {
  ColorRange range;
  if (part.color_param < 0) return range;
  const ParamBlock& params = state.rig.lights[static_cast<std::size_t>(part.light)].params;
  const ParamSpec& spec = params.schema()[part.color_param];
  // The map knows what 0 and 1 mean on any scale.
  ParamBlock alone = params;
  alone.set_param_locked(-1, true);
  alone.set_param_locked(part.color_param, false);
  const std::array<const ParamBlock*, 1> blocks{&alone};
  const UnitMap map = UnitMap::create(blocks, frame);
  const std::array<ParamBlock*, 1> writable{&alone};
  for (const bool upper : {false, true}) {
    const std::vector<double> x(static_cast<std::size_t>(map.dofs()), upper ? 1.0 : 0.0);
    map.from_unit(x, writable);
    for (std::size_t c = 0; c < 3; ++c) {
      (upper ? range.high : range.low)[c] = alone.get(part.color_param, static_cast<int>(c));
    }
  }
  for (std::size_t c = 0; c < 3; ++c) range.free[c] = !params.locked(spec.first_dof + static_cast<int>(c));
  return range;
}

}  // namespace

Vec3 part_color(const ParamState& state, const Part& part) {
  if (part.color_param < 0) return Vec3(1.0F);
  return state.rig.lights[static_cast<std::size_t>(part.light)].params.vec3(part.color_param);
}

Result<PictureParts> PictureParts::create(Renderer& renderer, const ParamState& state, const SampleSet& probe) {
  PictureParts result;
  if (renderer.style().combination(state.style) == LightCombination::kJoint) {
    result.parts_.push_back({Candidate::kAllLights, -1, {}});
    return result;
  }
  result.parts_.push_back({Candidate::kNoLights, -1, {}});
  for (int light = 0; light < static_cast<int>(state.rig.lights.size()); ++light) {
    Part part{light, color_param_of(state.rig.lights[static_cast<std::size_t>(light)]), {}};
    if (part.color_param >= 0) {
      LUM_TRY(const bool linear, scales(renderer, state, part, probe));
      if (!linear) part.color_param = -1;
    }
    result.parts_.push_back(part);
  }
  tie_colors(state.rig, result.parts_);
  return result;
}

std::vector<int> PictureParts::touched_by(const ParamState& state, const Dof& dof) const {
  if (parts_.size() == 1 && parts_[0].light == Candidate::kAllLights) return {0};
  const int lights = static_cast<int>(state.rig.lights.size());
  if (dof.block == 0) return {0};
  std::vector<int> all;
  if (dof.block > lights) {
    for (int part = 0; part < static_cast<int>(parts_.size()); ++part) all.push_back(part);
    return all;
  }
  // Part 0 is the base, block 0 the ambient: both are followed by the lights.
  std::vector<int> touched;
  bool shared = false;
  for (const Tie& tie : tied_to(state.rig, static_cast<std::size_t>(dof.block - 1), dof.param)) {
    touched.push_back(static_cast<int>(tie.light) + 1);
    shared = shared || state.rig.shadow_light == state.rig.lights[tie.light].name;
  }
  if (!shared || scaled_by(dof) >= 0) return touched;
  for (int other = 1; other < static_cast<int>(parts_.size()); ++other) all.push_back(other);
  return all;  // its shadow map is everyone's
}

std::vector<int> PictureParts::touched_by(const ParamState& state, const UnitMap& map,
                                          std::span<const int> blocks) const {
  std::vector<int> touched;
  for (const Dof& dof : map.list()) {
    if (std::ranges::find(blocks, dof.block) == blocks.end() || scaled_by(dof) >= 0) continue;
    for (const int part : touched_by(state, dof)) touched.push_back(part);
  }
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

int PictureParts::scaled_by(const Dof& dof) const {
  for (int part = 0; part < static_cast<int>(parts_.size()); ++part) {
    const Part& p = parts_[static_cast<std::size_t>(part)];
    if (p.color_param >= 0 && dof.block == light_block(p.light) && dof.param == p.color_param) return part;
  }
  return -1;
}

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
    if (parts.scaled_by(dof) >= 0) continue;  // white parts stay as they are
    for (const int part : parts.touched_by(free, dof)) is_free[static_cast<std::size_t>(part)] = true;
  }
  const CellField nothing(static_cast<std::size_t>(level.cells.size()), Vec3(0.0F));
  problem.fixed_.resize(count);
  problem.offset_ = nothing;
  std::vector<Request> requests;
  for (std::size_t part = 0; part < count; ++part) {
    problem.ranges_.push_back(range_of(free, parts.list()[part], renderer.frame()));
    if (is_free[part]) {
      problem.free_parts_.push_back(static_cast<int>(part));
    } else if (!still.empty() && std::ranges::find(moving, parts.list()[part].light) == moving.end()) {
      problem.fixed_[part] = parts.list()[part].light == Candidate::kNoLights ? still : nothing;
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
  const ParamState* last = nullptr;
  for (const Request& request : requests) {
    if (request.state != last) {
      states.push_back(whitened(*request.state, parts_->list()));
      last = request.state;
    }
    candidates.push_back({&states.back(), parts_->list()[static_cast<std::size_t>(request.part)].light});
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

CellField CellProblem::white(const CellPoint& point, int part) const {
  CellField sum(static_cast<std::size_t>(level_->cells.size()), Vec3(0.0F));
  for (const ColoredPart& colored : parts_->list()[static_cast<std::size_t>(part)].colored) {
    const CellField& field = point.fields[static_cast<std::size_t>(colored.part)];
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += colored.factor * field[c];
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

void CellProblem::settle(CellPoint& point) const {
  CellField rest = offset_;
  std::vector<const CellField*> white;
  std::vector<ColorRange> ranges;
  std::vector<Vec3> colors;
  std::vector<std::size_t> solved;
  std::vector<bool> tied(point.fields.size(), false);  // its colour is solved with another's
  std::list<CellField> sums;
  for (std::size_t part = 0; part < point.fields.size(); ++part) {
    const ColorRange& range = ranges_[part];
    if (!range.free[0] && !range.free[1] && !range.free[2]) continue;
    const Part& scaled = parts_->list()[part];
    for (const ColoredPart& colored : scaled.colored) tied[static_cast<std::size_t>(colored.part)] = true;
    const bool alone = scaled.colored.size() == 1;
    white.push_back(alone ? &point.fields[part] : &sums.emplace_back(this->white(point, static_cast<int>(part))));
    ranges.push_back(range);
    colors.push_back(part_color(point.state, scaled));
    solved.push_back(part);
  }
  for (std::size_t part = 0; part < point.fields.size(); ++part) {
    if (tied[part]) continue;
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
  solve_colors(level_->cells, rest, white, ranges, norm_, colors);
  for (std::size_t k = 0; k < solved.size(); ++k) {
    const Part& part = parts_->list()[solved[k]];
    point.state.rig.lights[static_cast<std::size_t>(part.light)].params.set_vec3(part.color_param, colors[k]);
  }
  if (!point.state.rig.constraints.empty()) keep_constraints(point.state.rig);  // colours that follow those
  point.cost = cell_cost(level_->cells, picture(point), norm_);
}

}  // namespace luminist
