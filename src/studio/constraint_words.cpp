#include "studio/constraint_words.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/files.h"
#include "params/param_text.h"

namespace luminist {
namespace {

constexpr Vec3 kUp(0.0F, 1.0F, 0.0F);

/// The sides of the scene's bounds as the camera sees them, by name.
std::optional<Plane> side_of(const Box& bounds, const Vec3& eye, std::string_view name) {
  const Vec3 half = 0.5F * (bounds.hi - bounds.lo);
  const Vec3 view = bounds.center() - eye;
  // The horizontal axis along which the camera looks most.
  Vec3 ahead = std::abs(view.x) > std::abs(view.z) ? Vec3(1.0F, 0.0F, 0.0F) : Vec3(0.0F, 0.0F, 1.0F);
  if (glm::dot(ahead, view) < 0.0F || view == Vec3(0.0F)) ahead = -ahead;
  const Vec3 right = glm::cross(ahead, kUp);
  const std::array<std::pair<std::string_view, Vec3>, 6> sides{{{"floor", kUp},
                                                                {"ceiling", -kUp},
                                                                {"back wall", -ahead},
                                                                {"front wall", ahead},
                                                                {"left wall", right},
                                                                {"right wall", -right}}};
  constexpr Vec3 kNoMinusZero(0.0F);
  if (name == "middle") return Plane{bounds.center(), right + kNoMinusZero};
  for (const auto& [side, normal] : sides) {
    if (side == name) return Plane{bounds.center() - half * normal, normal + kNoMinusZero};
  }
  return std::nullopt;
}

/// The place of a light's axis that is nearest to the centre of the scene; nothing if it shines away from there.
std::optional<Vec3> aim_of(const Light& light, const Vec3& center) {
  const std::optional<int> position = light.params.schema().by_role("position");
  const std::optional<int> direction = light.params.schema().by_role("direction");
  if (!position || !direction) return std::nullopt;
  const Vec3 from = light.params.vec3(*position);
  const Vec3 axis = glm::normalize(light.params.vec3(*direction));
  const float along = glm::dot(center - from, axis);
  return along > 0.0F ? std::optional(from + along * axis) : std::nullopt;
}

/// The words of one constraint, from left to right. The first mistake is kept.
class ConstraintReader {
 public:
  ConstraintReader(std::string_view words, const LightRig& rig, const SurfaceBuffer& surface, const Box& bounds)
      : words_(words), rest_(words), rig_(&rig), surface_(&surface), bounds_(bounds) {}

  Result<Constraint> read() {
    Constraint constraint{light(), {}};
    if (take("on")) {
      constraint.rule = OnPlane{plane()};
    } else if (take("at distance")) {
      constraint.rule = at_distance(constraint.light);
    } else if (take("mirror of")) {
      MirrorOf image{light(), {}};
      if (!take("across")) fail("a mirror image needs a plane", kConstraintForms);
      image.plane = plane();
      constraint.rule = image;
    } else if (take("same color as")) {
      SameColor same{light(), 1.0F};
      if (take("times")) same.factor = numbers<1>()[0];
      constraint.rule = same;
    } else {
      constraint.rule = between();
    }
    if (!skip_blanks().empty()) fail(fmt::format("\"{}\" is one word too many", rest_), kConstraintForms);
    if (error_) return *error_;
    return constraint;
  }

 private:
  void fail(std::string what, std::string hint) {
    if (!error_) error_ = Error{ErrorKind::kUsage, std::move(what), "", std::string(words_), std::move(hint)};
  }

  std::string_view skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size()));
    return rest_;
  }

  /// Whether these words come next; then they are read.
  bool take(std::string_view words) {
    if (!skip_blanks().starts_with(words)) return false;
    if (rest_.size() > words.size() && rest_[words.size()] != ' ') return false;
    rest_.remove_prefix(words.size());
    return true;
  }

  std::string_view word() {
    skip_blanks();
    const std::string_view found = rest_.substr(0, rest_.find(' '));
    rest_.remove_prefix(found.size());
    return found;
  }

  /// A name may have blanks: the longest name of the rig that fits.
  std::string light() {
    constexpr std::string_view kPrefix = "lights/";
    if (!skip_blanks().starts_with(kPrefix)) {
      fail("the path of a light is wanted", kConstraintForms);
      return "";
    }
    rest_.remove_prefix(kPrefix.size());
    const std::string* longest = nullptr;
    std::vector<std::string> names;
    for (const Light& each : rig_->lights) {
      names.push_back(each.name);
      const bool fits =
          rest_.starts_with(each.name) && (rest_.size() == each.name.size() || rest_[each.name.size()] == ' ');
      if (fits && (longest == nullptr || each.name.size() > longest->size())) longest = &each.name;
    }
    if (longest != nullptr) {
      rest_.remove_prefix(longest->size());
      return *longest;
    }
    const std::string name(word());
    const std::string nearest = nearest_name(name, names);
    fail(fmt::format("there is no light \"{}\"", name), !nearest.empty() ? fmt::format("did you mean \"{}\"?", nearest)
                                                        : names.empty()
                                                            ? "the rig has no lights"
                                                            : fmt::format("there are: {}", fmt::join(names, ", ")));
    return name;
  }

  template <std::size_t N>
  std::array<float, N> numbers() {
    std::array<float, N> list{};
    std::string_view text = word();
    const std::string written(text);
    for (std::size_t i = 0; i < N; ++i) {
      const std::size_t comma = i + 1 < N ? text.find(',') : text.size();
      const auto number = comma == std::string_view::npos ? std::nullopt : parse_number(text.substr(0, comma));
      if (!number) {
        fail(fmt::format("\"{}\" is not what is wanted here", written), N == 1   ? "give a number"
                                                                        : N == 2 ? "give two numbers, as 0.5,0.3"
                                                                                 : "give three numbers, as 0,2.5,0");
        return list;
      }
      list[i] = static_cast<float>(*number);
      text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return list;
  }

  Vec3 vector() {
    const std::array<float, 3> list = numbers<3>();
    return {list[0], list[1], list[2]};
  }

  Plane plane() {
    if (take("plane")) {
      const Vec3 point = vector();
      return {point, vector()};
    }
    if (take("surface")) return surface();
    for (const char* name : kPlaneNames) {
      if (take(name)) return *side_of(bounds_, surface_->eye, name);
    }
    fail("the name of a plane is wanted", kConstraintForms);
    return {};
  }

  Plane surface() {
    const std::array<float, 2> place = numbers<2>();
    const float x = std::floor(place[0] * static_cast<float>(surface_->height));
    const float y = std::floor(place[1] * static_cast<float>(surface_->height));
    if (x >= 0.0F && y >= 0.0F && x < static_cast<float>(surface_->width) && y < static_cast<float>(surface_->height)) {
      const std::size_t pixel = surface_->index(static_cast<int>(x), static_cast<int>(y));
      if (surface_->object[pixel] != 0) return {surface_->position[pixel], surface_->normal[pixel]};
    }
    fail("nothing is visible there", "give a place in picture heights from the top left, as strokes have it");
    return {};
  }

  AtDistance at_distance(const std::string& name) {
    AtDistance at;
    const bool present = take("present");
    if (!present) at.distance = numbers<1>()[0];
    if (!take("from")) fail("a distance is measured from somewhere", kConstraintForms);
    const Light* light = rig_->find(name);
    if (take("aim")) {
      const std::optional<Vec3> place = light != nullptr ? aim_of(*light, bounds_.center()) : std::nullopt;
      if (!place) fail("the light does not shine towards the scene", "give a place, as 0,1,0");
      at.from = place.value_or(Vec3(0.0F));
    } else {
      at.from = vector();
    }
    const std::optional<int> position =
        light != nullptr ? light->params.schema().by_role("position") : std::optional<int>();
    if (present && position) at.distance = glm::distance(light->params.vec3(*position), at.from);
    return at;
  }

  Between between() {
    Between range{std::string(word()), 0.0F, 0.0F};
    if (!take("between")) {
      fail("this is no constraint", kConstraintForms);
      return range;
    }
    range.low = numbers<1>()[0];
    if (!take("and")) fail("a range ends somewhere", kConstraintForms);
    range.high = numbers<1>()[0];
    return range;
  }

  std::string_view words_;
  std::string_view rest_;
  const LightRig* rig_;
  const SurfaceBuffer* surface_;
  Box bounds_;
  std::optional<Error> error_;
};

}  // namespace

Result<Constraint> parse_constraint(std::string_view words, const LightRig& rig, const SurfaceBuffer& surface,
                                    const Box& bounds) {
  return ConstraintReader(words, rig, surface, bounds).read();
}

std::string rule_words(const Constraint& constraint, const SurfaceBuffer& surface, const Box& bounds) {
  const std::string words = to_text(constraint);
  const std::string rule = words.substr(std::string("lights/").size() + constraint.light.size() + 1);
  const auto* on = std::get_if<OnPlane>(&constraint.rule);
  const auto* mirror = std::get_if<MirrorOf>(&constraint.rule);
  const Plane* plane = on != nullptr ? &on->plane : mirror != nullptr ? &mirror->plane : nullptr;
  if (plane == nullptr) return rule;
  const float small = 1e-4F * std::max(glm::length(bounds.hi - bounds.lo), 1e-3F);
  for (const char* name : kPlaneNames) {
    const std::optional<Plane> known = side_of(bounds, surface.eye, name);
    if (!known || glm::length(known->normal - plane->normal) > 1e-4F) continue;
    if (std::abs(glm::dot(known->point - plane->point, known->normal)) > small) continue;
    return rule.substr(0, rule.rfind("plane ")) + name;
  }
  return rule;
}

Result<void> add_constraints(LightRig& rig, const std::vector<std::string>& words, const SurfaceBuffer& surface,
                             const Box& bounds) {
  LightRig next = rig;
  for (const std::string& each : words) {
    LUM_TRY(Constraint constraint, parse_constraint(each, next, surface, bounds));
    std::erase_if(next.constraints, [&](const Constraint& present) { return same_kind(present, constraint); });
    next.constraints.push_back(std::move(constraint));
    LUM_TRY_VOID(check_constraints(next));
    keep_constraints(next);  // the next words may speak of where the light stands now
  }
  rig = std::move(next);
  return {};
}

}  // namespace luminist
