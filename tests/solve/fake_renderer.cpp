#include "solve/fake_renderer.h"

#include <array>
#include <cmath>

#include "render/metric.h"
#include "solve/random.h"

namespace luminist {
namespace {

constexpr float kTinyWidth = 1e-4F;

float ramp(float start, float width, float x) {
  const float t = std::clamp((x - start) / std::max(width, kTinyWidth), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

ParamSpec number(const std::string& name, double value, double low, double high) {
  ParamSpec spec;
  spec.name = name;
  spec.default_value = {value};
  spec.range_min = {low};
  spec.range_max = {high};
  spec.group = "Style";
  spec.doc = "A number of the fake style.";
  return spec;
}

ParamSpec color(const std::string& name, double value) {
  ParamSpec spec = number(name, value, 0.0, 2.0);
  spec.type = ParamType::kColor;
  spec.default_value.assign(3, value);
  spec.range_min.assign(3, 0.0);
  spec.range_max.assign(3, 2.0);
  spec.role = "color";
  spec.solve = true;
  return spec;
}

std::vector<ParamSpec> specs_of(FakeStyle style) {
  std::vector<ParamSpec> specs{number("threshold", 0.4, 0.0, 1.0), number("dark", 0.2, 0.0, 1.0)};
  if (style != FakeStyle::kTwoTone && style != FakeStyle::kGlowing) return specs;
  specs.push_back(color("bright", 1.0));
  specs.push_back(color("shade", 0.2));
  return specs;
}

LightTypes load_types() {
  auto types = LightTypes::load(AssetRoots::standard());
  LUM_CHECK(types.has_value(), "tests run where shaders/light is found");
  return std::move(*types);
}

}  // namespace

struct FakeRenderer::LightValues {
  bool muted = false;
  Vec3 position, direction, color, barn;
  Vec2 near_cutoff, far_cutoff;
  float exponent = 0.0F, reference = 1.0F, density = 1.0F, softness = 0.01F;
};

FakeRenderer::FakeRenderer(int width, int height, FakeStyle style) : types_(load_types()), kind_(style) {
  spheres_ = {{{-0.9F, 0.6F, 0.0F}, 0.6F, {0.8F, 0.5F, 0.4F}},
              {{0.5F, 0.45F, 0.4F}, 0.45F, {0.4F, 0.7F, 0.5F}},
              {{0.2F, 0.8F, -0.9F}, 0.8F, {0.5F, 0.5F, 0.8F}},
              {{1.4F, 0.3F, 0.1F}, 0.3F, {0.8F, 0.8F, 0.3F}}};
  static constexpr std::array<const char*, 6> kNames{"matte", "toon", "two-tone", "glowing", "dotted", "tinted"};
  style_.name = kNames[static_cast<std::size_t>(style)];
  style_.lights = style == FakeStyle::kToon ? LightCombination::kJoint : LightCombination::kSum;
  auto schema = ParamSchema::create(specs_of(style), "fake");
  LUM_CHECK(schema.has_value(), "the fake's schema is valid");
  style_.schema = *schema;
  if (style == FakeStyle::kDotted) style_.metric.blur = 0.06F;  // over several dots
  surface_.width = width;
  surface_.height = height;
  surface_.eye = Vec3(0.0F, 1.8F, 5.0F);
  const std::size_t pixels = surface_.pixels();
  surface_.position.assign(pixels, Vec3(0.0F));
  surface_.normal = surface_.albedo = surface_.specular = surface_.position;
  surface_.roughness.assign(pixels, 0.5F);
  surface_.object.assign(pixels, 0);
  surface_.material.assign(pixels, 0);
  surface_.object_names = {"", "floor", "wall", "sphere 1", "sphere 2", "sphere 3", "sphere 4"};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) trace(x, y);
  }
}

void FakeRenderer::trace(int x, int y) {
  const float u = (static_cast<float>(x) + 0.5F) / static_cast<float>(surface_.width) - 0.5F;
  const float v = 0.5F - (static_cast<float>(y) + 0.5F) / static_cast<float>(surface_.height);
  const Vec3 eye = surface_.eye;
  const Vec3 ahead = glm::normalize(Vec3(0.0F, 0.6F, 0.0F) - eye);
  const Vec3 right = glm::normalize(glm::cross(ahead, Vec3(0.0F, 1.0F, 0.0F)));
  const Vec3 way = glm::normalize(ahead + 0.85F * (u * right + v * glm::cross(right, ahead)));
  float nearest = 1e9F;
  const std::size_t i = surface_.index(x, y);
  const auto hit = [&](float distance, const Vec3& normal, const Vec3& albedo, std::uint32_t object) {
    if (!(distance > 0.0F) || distance >= nearest) return;
    nearest = distance;
    surface_.position[i] = eye + distance * way;
    surface_.normal[i] = normal;
    surface_.albedo[i] = albedo;
    surface_.object[i] = surface_.material[i] = object;
  };
  hit(-eye.y / way.y, Vec3(0.0F, 1.0F, 0.0F), Vec3(0.6F), 1);
  hit((-2.2F - eye.z) / way.z, Vec3(0.0F, 0.0F, 1.0F), Vec3(0.5F, 0.55F, 0.6F), 2);
  for (std::size_t s = 0; s < spheres_.size(); ++s) {
    const Vec3 offset = eye - spheres_[s].center;
    const float b = glm::dot(offset, way);
    const float root = b * b - glm::dot(offset, offset) + spheres_[s].radius * spheres_[s].radius;
    if (root < 0.0F) continue;
    const float distance = -b - std::sqrt(root);
    const Vec3 normal = glm::normalize(eye + distance * way - spheres_[s].center);
    hit(distance, normal, spheres_[s].albedo, static_cast<std::uint32_t>(3 + s));
  }
}

FakeRenderer::LightValues FakeRenderer::read(const Light& light) const {
  const ParamSchema& schema = light.params.schema();
  const auto param = [&](const char* name) { return *schema.find(name); };
  LightValues values;
  values.muted = light.muted;
  values.position = light.params.vec3(param("position"));
  values.direction = glm::normalize(light.params.vec3(param("direction")));
  values.color = light.params.vec3(param("color"));
  values.barn = light.params.vec3(param("barn"));
  values.near_cutoff = light.params.vec2(param("near_cutoff"));
  values.far_cutoff = light.params.vec2(param("far_cutoff"));
  values.exponent = light.params.scalar(param("falloff_exponent"));
  values.reference = light.params.scalar(param("falloff_distance"));
  values.density = light.params.scalar(param("shadow_density"));
  values.softness = light.params.scalar(param("shadow_softness"));
  return values;
}

float FakeRenderer::visibility(const LightValues& light, std::size_t pixel, float angle) const {
  const Vec3 to_point = surface_.position[pixel] - light.position;
  const float distance = glm::length(to_point);
  float lit = 1.0F;
  for (std::size_t s = 0; s < spheres_.size(); ++s) {
    if (surface_.object[pixel] == 3 + s) continue;  // its dark side faces away
    const Vec3 to_center = spheres_[s].center - light.position;
    const float center_distance = glm::length(to_center);
    if (distance <= center_distance || center_distance <= spheres_[s].radius) continue;
    const float cosine = glm::dot(to_point, to_center) / (distance * center_distance);
    const float beside = std::acos(std::clamp(cosine, -1.0F, 1.0F)) - std::asin(spheres_[s].radius / center_distance);
    lit *= ramp(-angle, 2.0F * angle, beside);
  }
  return lit;
}

Vec3 FakeRenderer::light_term(const LightValues& light, const ParamState& state, std::size_t pixel,
                              const Softness& softness, bool shadows) const {
  if (light.muted) return Vec3(0.0F);
  const Vec3 to_light = light.position - surface_.position[pixel];
  const float r = glm::length(to_light);
  if (!(r > 0.0F)) return Vec3(0.0F);
  const Vec3 l = to_light / r;
  float facing = std::max(0.0F, glm::dot(surface_.normal[pixel], l));
  const float ahead = -glm::dot(l, light.direction);
  if (ahead <= 1e-4F) return Vec3(0.0F);
  const Vec3 axis = light.direction;  // right and up as level as can be, regular straight down
  const float steep = ramp(0.96F, 0.04F, 1.0F - axis.x * axis.x - axis.z * axis.z);
  const Vec3 right =
      glm::normalize(Vec3(-axis.z, 0.0F, axis.x) + 0.1F * steep * (Vec3(1.0F, 0.0F, 0.0F) - axis.x * axis));
  const Vec3 up = glm::cross(right, axis);
  const Vec2 at(-glm::dot(l, right) / ahead, -glm::dot(l, up) / ahead);
  const Vec2 inside = glm::max(glm::abs(Vec2(light.barn)), Vec2(1e-4F));
  const Vec2 scaled = at / inside;
  const float across = std::pow(std::pow(scaled.x, 4.0F) + std::pow(scaled.y, 4.0F), 0.25F);
  const float edge = std::max(std::abs(light.barn.z), softness.light_edge) / std::max(inside.x, inside.y);
  float strength = 1.0F - ramp(1.0F, edge, across);
  strength *= ramp(light.near_cutoff.x, light.near_cutoff.y, r);
  strength *= 1.0F - ramp(light.far_cutoff.x, light.far_cutoff.y, r);
  if (strength <= 0.0F) return Vec3(0.0F);
  const float ratio = r / std::max(1e-3F, std::abs(light.reference));
  strength *= std::pow(2.0F / (1.0F + ratio * ratio), 0.5F * std::clamp(light.exponent, -12.0F, 12.0F));
  if (shadows) {
    const float lit = visibility(light, pixel, std::max(softness.shadow_angle, std::max(1e-4F, light.softness)));
    strength *= 1.0F - light.density * (1.0F - lit);
  }
  if (kind_ == FakeStyle::kToon) {
    const float width = std::max(softness.threshold, 0.02F);
    const float dark = state.style.scalar(1);
    facing = dark + (1.0F - dark) * ramp(state.style.scalar(0) - width, 2.0F * width, facing);
  }
  Vec3 color = light.color;
  if (kind_ == FakeStyle::kTinted) color = 0.5F * color + Vec3(0.5F * (color.x * color.x + color.y) / 2.0F);
  if (kind_ == FakeStyle::kTwoTone || kind_ == FakeStyle::kGlowing) {
    const float width = std::max(softness.threshold, 0.02F);
    Vec3 bright = state.style.vec3(2);
    if (kind_ == FakeStyle::kGlowing) bright *= bright;
    color *= glm::mix(state.style.vec3(3), bright, ramp(state.style.scalar(0) - width, 2.0F * width, facing));
    facing = 1.0F;
  }
  return surface_.albedo[pixel] * color * (facing * strength);
}

Vec3 FakeRenderer::shade(const ParamState& state, std::span<const LightValues> lights, int which, std::size_t pixel,
                         const Softness& softness, bool shadows) const {
  if (surface_.object[pixel] == 0) return Vec3(0.0F);
  if (which >= 0) return light_term(lights[static_cast<std::size_t>(which)], state, pixel, softness, shadows);
  Vec3 sum = surface_.albedo[pixel] * state.rig.ambient.vec3(0);
  if (which == Candidate::kNoLights) return sum;
  for (const LightValues& light : lights) sum += light_term(light, state, pixel, softness, shadows);
  return sum;
}

Result<Image> FakeRenderer::render(const ParamState& state, const RenderOptions& options) {
  std::vector<LightValues> lights;
  for (const Light& light : state.rig.lights) lights.push_back(read(light));
  Image image(surface_.width, surface_.height, 3);
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const Vec3 color = shade(state, lights, Candidate::kAllLights, i, {}, options.shadows);
    const std::size_t row = i / static_cast<std::size_t>(surface_.width);
    const bool gap = kind_ == FakeStyle::kDotted && (i % 4 != 0 || row % 4 != 0);
    image.set_rgb(i, kind_ != FakeStyle::kDotted ? color : gap ? Vec3(0.0F) : 16.0F * color);
  }
  const double work = static_cast<double>(image.pixels()) * static_cast<double>(lights.size());
  work_.shades += work;
  work_.shadow_queries += options.shadows ? work : 0.0;
  work_.pictures += 1.0;
  return image;
}

Result<double> FakeRenderer::error(const ParamState& state, const Target& target) {
  LUM_TRY(const Image picture, render(state, {}));
  return picture_error(picture, target, style_.metric);
}

Result<void> FakeRenderer::evaluate(std::span<const Candidate> candidates, const SampleSet& samples,
                                    const Softness& softness, std::span<Vec3> out) {
  const std::size_t count = samples.pixels.size();
  LUM_CHECK(out.size() == candidates.size() * count, "one result per candidate and sample");
  std::vector<std::pair<int, Vec3>> seen_from;  // visibility is looked up once for each place of a light
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const ParamState& state = *candidates[k].state;
    std::vector<LightValues> lights;
    for (const Light& light : state.rig.lights) lights.push_back(read(light));
    for (std::size_t i = 0; i < count; ++i) {
      out[k * count + i] = shade(state, lights, candidates[k].light, samples.pixels[i], softness, true);
    }
    for (int i = 0; i < static_cast<int>(lights.size()); ++i) {
      if (candidates[k].light != Candidate::kAllLights && candidates[k].light != i) continue;
      work_.shades += static_cast<double>(count);
      const std::pair<int, Vec3> place(i, lights[static_cast<std::size_t>(i)].position);
      if (std::find(seen_from.begin(), seen_from.end(), place) != seen_from.end()) continue;
      seen_from.push_back(place);
      work_.shadow_queries += static_cast<double>(count) * softness.shadow_rays;
    }
  }
  return {};
}

ParamState FakeRenderer::empty_state() const {
  return initial_state(types_, style_, frame());
}

Light FakeRenderer::cinematic(const std::string& name) const {
  auto light = make_light(types_, "cinematic", name, frame());
  LUM_CHECK(light.has_value(), "the cinematic light is a type");
  const ParamSchema& schema = light->params.schema();
  for (int param = 0; param < schema.size(); ++param) {
    light->params.set_param_locked(param, schema[param].name == "shadow_softness");
  }
  return std::move(*light);
}

Target FakeRenderer::target_of(const ParamState& wanted, const ParamState& before) {
  Target target;
  target.color = *render(wanted, {});
  target.before = *render(before, {});
  target.importance = Image(surface_.width, surface_.height, 1, 1.0F);
  target.stroke.assign(surface_.pixels(), 0);
  return target;
}

Light hidden_light(const FakeRenderer& renderer, const std::string& name, std::uint64_t seed) {
  Random random(seed * 7919 + 17);
  Light light = renderer.cinematic(name);
  const ParamSchema& schema = light.params.schema();
  const SceneFrame frame = renderer.frame();
  const auto param = [&](const char* word) { return *schema.find(word); };
  const Vec3 aim = frame.center + 0.6F * frame.radius * static_cast<float>(random.uniform()) * random.direction();
  Vec3 from = random.direction();
  from.y = std::abs(from.y) + 0.3F;
  from.z = std::abs(from.z) + 0.2F;
  const auto distance = static_cast<float>(frame.radius * random.uniform(1.2, 3.0));
  const Vec3 position = aim + distance * glm::normalize(from);
  light.params.set_vec3(param("position"), position);
  light.params.set_vec3(param("direction"), glm::normalize(aim - position));
  for (int c = 0; c < 3; ++c) light.params.set(param("color"), c, random.uniform(0.3, 2.0));
  light.params.set(param("barn"), 0, random.uniform(0.15, 0.6));
  light.params.set(param("barn"), 1, random.uniform(0.15, 0.6));
  light.params.set(param("barn"), 2, random.uniform(0.05, 0.4));
  light.params.set(param("near_cutoff"), 0, random.uniform(0.0, 0.5) * distance);
  light.params.set(param("near_cutoff"), 1, random.uniform(0.1, 0.5) * distance);
  light.params.set(param("far_cutoff"), 0, random.uniform(1.0, 3.0) * distance);
  light.params.set(param("far_cutoff"), 1, random.uniform(0.2, 2.0) * distance);
  light.params.set(param("falloff_exponent"), 0, random.uniform(0.0, 2.5));
  light.params.set(param("falloff_distance"), 0, distance);
  light.params.set(param("shadow_density"), 0, random.uniform(0.4, 1.0));
  return light;
}

}  // namespace luminist
