#include "solve/picture_parts.h"

#include <algorithm>
#include <array>
#include <optional>

namespace luminist {
namespace {

int color_param_of(const Light& light) {
  const std::optional<int> param = light.params.schema().by_role("color");
  if (!param || light.params.schema()[*param].type != ParamType::kColor) return -1;
  return *param;
}

/// The style's colours that may change.
std::vector<int> free_style_colors(const ParamBlock& style) {
  std::vector<int> free;
  for (int param = 0; param < style.schema().size(); ++param) {
    const ParamSpec& spec = style.schema()[param];
    if (spec.role != "color" || spec.type != ParamType::kColor) continue;
    bool locked = true;
    for (int c = 0; c < spec.dofs(); ++c) locked = locked && style.locked(spec.first_dof + c);
    if (!locked) free.push_back(param);
  }
  return free;
}

bool near(const Vec3& got, const Vec3& wanted) {
  return glm::length(wanted - got) <= 1e-3F * (glm::length(wanted) + 1e-3F);
}

/// Whether each channel of a light's part is that channel of its colour times a number.
Result<bool> scales(Renderer& renderer, const ParamState& state, const Part& part, const SampleSet& probe) {
  const Vec3 color(2.0F, 0.5F, 0.0F);
  std::array<ParamState, 2> states{state, state};
  const auto light = static_cast<std::size_t>(part.light);
  states[0].rig.lights[light].params.set_vec3(part.light_color, Vec3(1.0F));
  states[1].rig.lights[light].params.set_vec3(part.light_color, color);
  const std::array<Candidate, 2> candidates{Candidate{&states[0], part.light}, Candidate{&states[1], part.light}};
  std::vector<Vec3> out(2 * probe.pixels.size());
  LUM_TRY_VOID(renderer.evaluate(candidates, probe, {}, out));
  for (std::size_t i = 0; i < probe.pixels.size(); ++i) {
    if (!near(out[probe.pixels.size() + i], color * out[i])) return false;
  }
  return true;
}

/// The parts that one colour scales stand together: if it does not scale one of them, it is as another parameter.
void untie_colors(const LightRig& rig, std::vector<Part>& parts) {
  for (std::size_t light = 0; light < rig.lights.size(); ++light) {
    const std::optional<int> color = rig.lights[light].params.schema().by_role("color");
    if (!color) continue;
    const std::vector<Tie> ties = tied_to(rig, light, *color);
    const bool scaling =
        std::all_of(ties.begin(), ties.end(), [&](const Tie& tie) { return parts[tie.light + 1].light_color >= 0; });
    if (scaling) continue;
    for (const Tie& tie : ties) parts[tie.light + 1].light_color = -1;
  }
}

}  // namespace

Vec3 part_color(const ParamState& state, const Part& part) {
  return part_color_without(state, part, false) * part_color_without(state, part, true);
}

Vec3 part_color_without(const ParamState& state, const Part& part, bool style) {
  if (!style) return part.style_color < 0 ? Vec3(1.0F) : state.style.vec3(part.style_color);
  if (part.light_color < 0) return Vec3(1.0F);
  return state.rig.lights[static_cast<std::size_t>(part.light)].params.vec3(part.light_color);
}

Result<PictureParts> PictureParts::create(Renderer& renderer, const ParamState& state, const SampleSet& probe) {
  PictureParts result;
  const bool joint = renderer.style().combination(state.style) == LightCombination::kJoint;
  result.find_groups(state, joint);
  if (!joint) LUM_TRY_VOID(result.try_light_colors(renderer, state, probe));
  const std::vector<int> free = free_style_colors(state.style);
  LUM_TRY(const bool all, result.scale_together(renderer, state, probe, free));
  if (all) {
    result.split(free);
  } else {
    std::vector<int> scaling;
    for (const int param : free) {
      LUM_TRY(const bool alone, result.scale_together(renderer, state, probe, {param}));
      if (alone) scaling.push_back(param);
    }
    LUM_TRY(const bool together, result.scale_together(renderer, state, probe, scaling));
    if (together) result.split(scaling);
  }
  result.list_colors(state);
  return result;
}

void PictureParts::find_groups(const ParamState& state, bool joint) {
  if (joint) {
    parts_ = {Part{}};
    return;
  }
  parts_ = {Part{Candidate::kNoLights}};
  for (int light = 0; light < static_cast<int>(state.rig.lights.size()); ++light) {
    parts_.push_back({light, color_param_of(state.rig.lights[static_cast<std::size_t>(light)]), -1, light + 1});
  }
}

Result<void> PictureParts::try_light_colors(Renderer& renderer, const ParamState& state, const SampleSet& probe) {
  for (Part& part : parts_) {
    if (part.light_color < 0) continue;
    LUM_TRY(const bool linear, scales(renderer, state, part, probe));
    if (!linear) part.light_color = -1;
  }
  untie_colors(state.rig, parts_);
  return {};
}

Result<bool> PictureParts::scale_together(Renderer& renderer, const ParamState& state, const SampleSet& probe,
                                          const std::vector<int>& params) const {
  static constexpr std::array<Vec3, 3> kMixed{Vec3(0.9F, 0.3F, 0.5F), Vec3(0.2F, 0.7F, 0.4F), Vec3(0.6F, 0.1F, 0.8F)};
  const Vec3 light_color(2.0F, 0.5F, 0.25F);
  if (params.empty()) return true;
  const std::size_t n = params.size();
  std::vector<ParamState> states(n + 2, whitened(state, 0));  // black, one after another white, all mixed
  for (std::size_t k = 0; k < n; ++k) {
    for (ParamState& each : states) each.style.set_vec3(params[k], Vec3(0.0F));
  }
  for (std::size_t k = 0; k < n; ++k) {
    states[k + 1].style.set_vec3(params[k], Vec3(1.0F));
    states.back().style.set_vec3(params[k], kMixed[k % kMixed.size()]);
  }
  for (const Part& part : parts_) {
    if (part.light_color < 0) continue;
    states.back().rig.lights[static_cast<std::size_t>(part.light)].params.set_vec3(part.light_color, light_color);
  }
  std::vector<Candidate> candidates;
  for (const Part& part : parts_) {
    for (const ParamState& each : states) candidates.push_back({&each, part.light});
  }
  const std::size_t count = probe.pixels.size();
  std::vector<Vec3> out(candidates.size() * count);
  LUM_TRY_VOID(renderer.evaluate(candidates, probe, {}, out));
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = [&](std::size_t which) { return out[(part * (n + 2) + which) * count + i]; };
      Vec3 wanted = at(0);
      for (std::size_t k = 0; k < n; ++k) wanted += kMixed[k % kMixed.size()] * (at(k + 1) - at(0));
      if (parts_[part].light_color >= 0) wanted *= light_color;
      if (!near(at(n + 1), wanted)) return false;
    }
  }
  return true;
}

void PictureParts::split(const std::vector<int>& params) {
  stride_ = 1 + static_cast<int>(params.size());
  std::vector<Part> split;
  for (Part part : parts_) {
    part.rest = static_cast<int>(split.size());
    split.push_back(part);
    for (const int param : params) {
      part.style_color = param;
      split.push_back(part);
    }
  }
  parts_ = std::move(split);
}

void PictureParts::list_colors(const ParamState& state) {
  const auto add_group = [&](PartColor& color, int group, float factor) {
    for (int k = 0; k < stride_; ++k) color.parts.push_back({group * stride_ + k, factor});
  };
  for (int group = 0; group < static_cast<int>(parts_.size()) / stride_; ++group) {
    const Part& part = parts_[static_cast<std::size_t>(group * stride_)];
    if (part.light_color < 0) continue;
    PartColor color{light_block(part.light), part.light_color, false, {}};
    for (const Tie& tie : tied_to(state.rig, static_cast<std::size_t>(part.light), part.light_color)) {
      add_group(color, static_cast<int>(tie.light) + 1, tie.factor);
    }
    colors_.push_back(std::move(color));
  }
  const int style = static_cast<int>(state.rig.lights.size()) + 1;
  for (int k = 1; k < stride_; ++k) {
    PartColor color{style, parts_[static_cast<std::size_t>(k)].style_color, true, {}};
    for (int part = k; part < static_cast<int>(parts_.size()); part += stride_) color.parts.push_back({part, 1.0F});
    colors_.push_back(std::move(color));
  }
}

int PictureParts::color_of(const Dof& dof) const {
  for (std::size_t k = 0; k < colors_.size(); ++k) {
    if (colors_[k].block == dof.block && colors_[k].param == dof.param) return static_cast<int>(k);
  }
  return -1;
}

std::vector<int> PictureParts::touched_by(const ParamState& state, const Dof& dof) const {
  const int lights = static_cast<int>(state.rig.lights.size());
  const int groups = static_cast<int>(parts_.size()) / stride_;
  std::vector<int> touched;
  const auto touch = [&](int first, int end) {
    for (int part = first * stride_; part < end * stride_; ++part) touched.push_back(part);
  };
  if (parts_[0].light == Candidate::kAllLights || dof.block > lights) {
    touch(0, groups);
    return touched;
  }
  if (dof.block == 0) {
    touch(0, 1);
    return touched;
  }
  // Group 0 is the base, block 0 the ambient: both are followed by the lights.
  bool shared = false;
  for (const Tie& tie : tied_to(state.rig, static_cast<std::size_t>(dof.block - 1), dof.param)) {
    touch(static_cast<int>(tie.light) + 1, static_cast<int>(tie.light) + 2);
    shared = shared || state.rig.shadow_light == state.rig.lights[tie.light].name;
  }
  if (!shared || color_of(dof) >= 0) return touched;
  touched.clear();
  touch(1, groups);  // its shadow map is everyone's
  return touched;
}

std::vector<int> PictureParts::touched_by(const ParamState& state, const UnitMap& map,
                                          std::span<const int> blocks) const {
  std::vector<int> touched;
  for (const Dof& dof : map.list()) {
    if (std::ranges::find(blocks, dof.block) == blocks.end() || color_of(dof) >= 0) continue;
    for (const int part : touched_by(state, dof)) touched.push_back(part);
  }
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  return touched;
}

ParamState PictureParts::whitened(const ParamState& state) const {
  ParamState white = state;
  for (const Part& each : parts_) {
    if (each.light_color >= 0) {
      white.rig.lights[static_cast<std::size_t>(each.light)].params.set_vec3(each.light_color, Vec3(1.0F));
    }
  }
  return white;
}

ParamState PictureParts::whitened(const ParamState& state, int part) const {
  ParamState white = whitened(state);
  const int style_color = parts_[static_cast<std::size_t>(part)].style_color;
  for (int k = 1; k < stride_; ++k) {
    const int param = parts_[static_cast<std::size_t>(k)].style_color;
    white.style.set_vec3(param, Vec3(param == style_color ? 1.0F : 0.0F));
  }
  return white;
}

}  // namespace luminist
