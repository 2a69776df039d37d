#pragma once
// rig/constraint.h -- what holds of a light before it is solved: where it stands, whom it follows, in what range.
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/math.h"
#include "base/result.h"

namespace luminist {

struct Light;
struct LightRig;

struct Plane {
  Vec3 point{0.0F};
  Vec3 normal{0.0F, 1.0F, 0.0F};  ///< of any length but 0
};

/// The light stands on a plane: the ceiling, a wall.
struct OnPlane {
  Plane plane;
};

/// The light stands at a distance from a point, in scene units.
struct AtDistance {
  float distance = 1.0F;  ///< > 0
  Vec3 from{0.0F};
};

/// The light is another one's mirror image: position and direction are reflected, all other parameters are equal. Its
/// shape keeps the roll that its direction gives it, which is the mirrored one for planes along the axes.
struct MirrorOf {
  std::string light;
  Plane plane;
};

/// The light has another one's colour, times a factor.
struct SameColor {
  std::string light;
  float factor = 1.0F;  ///< >= 0
};

/// A number of the light, or each of a vector or a colour, stays in a range, which takes the place of the declared one.
struct Between {
  std::string param;  ///< "size", "position.x"
  float low = 0.0F;   ///< below high; above 0 where the parameter is solved on a logarithmic scale
  float high = 1.0F;
};

/// One thing that always holds of a light, whoever turns the rig.
struct Constraint {
  std::string light;  ///< which light obeys
  std::variant<OnPlane, AtDistance, MirrorOf, SameColor, Between> rule;
};

/// What the rules are called in rig files, by Constraint::rule's alternatives.
inline constexpr std::array<const char*, 5> kRuleNames{"on_plane", "at_distance", "mirror_of", "same_color", "between"};
const char* rule_name(const Constraint& constraint);
/// Of one light and kind, ranges of one parameter: the later one takes the place of the earlier.
bool same_kind(const Constraint& a, const Constraint& b);

/// What a range is of: some components of a parameter.
struct LimitedNumbers {
  int param = 0;
  int first = 0;
  int count = 1;
};
/// Nothing if the light has no such numbers, or what has that name cannot be solved for as one.
std::optional<LimitedNumbers> limited_numbers(const Light& light, std::string_view param);

/// The light that the constrained one follows; null where it follows none.
const std::string* leader(const Constraint& constraint);

/// Moves the lights to where their constraints hold, and marks what follows another light, which is no degree of
/// freedom (ParamBlock::following()).
///
/// Numbers go into their ranges first (ParamBlock::limits()); a dark light stays dark. A position goes to the nearest
/// place that is allowed, along its unlocked axes where they lead there; where no place is nearest (the centre of a
/// sphere) it goes against the light's direction. What follows is set after what it follows, in whatever order the
/// constraints stand; a rig that obeys keeps its bits, so keeping twice is keeping once.
/// Constraints of lights that the rig does not have, and numbers that are not finite, are passed over.
/// cost O(lights + constraints). thread any.
void keep_constraints(LightRig& rig);

/// A light that has something of another.
struct Tie {
  std::size_t light = 0;  ///< its place in the rig
  float factor = 1.0F;    ///< of the other's colour
};
/// The lights that a parameter of one reaches: itself first, then mirror images and, for its colour, what has that.
std::vector<Tie> tied_to(const LightRig& rig, std::size_t light, int param);

/// Whether a solver may change anything of a light: what is unlocked in it, or in a light that it follows.
bool may_change(const LightRig& rig, const Light& light);

/// What makes a constraint impossible: its index, its field as rig files name it, and what to say.
struct ConstraintFault {
  std::size_t index = 0;
  std::string field;
  std::string what;
  std::string hint;
};

/// The first constraint that cannot be kept: a light that the rig does not have (with the nearest name) or whose type
/// lacks what is constrained; a degenerate normal or distance; a light that follows itself, or others in a circle, or
/// two at once; two constraints of one kind on one light; a mirror with a will of its own; a plane that does not reach
/// the distance; a range of what another constraint decides.
std::optional<ConstraintFault> find_fault(const LightRig& rig);
/// The same as an error: kUsage with the constraint in words as the field.
Result<void> check_constraints(const LightRig& rig);

/// Takes a light out of the rig: its constraints and those that name it go too (what followed it stays where it is),
/// and a shadow map that others shared. returns the constraints that went. The light exists.
std::vector<Constraint> remove_light(LightRig& rig, const std::string& name);

/// In words, as `--constrain` takes them: "lights/key on plane 0,2,0 0,-1,0".
std::string to_text(const Constraint& constraint);

}  // namespace luminist
