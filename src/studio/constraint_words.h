#pragma once
// studio/constraint_words.h -- constraints as a lighter says them: "lights/key on ceiling".
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "render/surface_buffer.h"
#include "rig/light_rig.h"

namespace luminist {

/// The forms, for help and errors.
inline constexpr const char* kConstraintForms =
    "lights/NAME on PLANE; at distance D from PLACE; mirror of lights/OTHER across PLANE; same color as lights/OTHER "
    "[times F]; PARAMETER between A and B. PLANE: floor, ceiling, back wall, front wall, left wall, right wall, "
    "middle, "
    "surface X,Y, or plane X,Y,Z NX,NY,NZ. D: a number or `present`. PLACE: X,Y,Z or aim";

/// The planes that have names.
inline constexpr std::array<const char*, 7> kPlaneNames = {"floor",     "ceiling",    "back wall", "front wall",
                                                           "left wall", "right wall", "middle"};

/// Reads one of the forms. Floor, ceiling and walls are the sides of the scene's bounds as the camera sees them, their
/// normals inwards; the middle halves the scene into left and right; `surface X,Y` is the plane through what is visible
/// there, in picture heights from the top left, as strokes have it. `aim` is the place of the light's axis nearest to
/// the centre of the scene; `present` is the distance that the light has now. errors kUsage with the words as the
/// field: another form, a light that the rig does not have (nearest name), a pixel that shows nothing.
Result<Constraint> parse_constraint(std::string_view words, const LightRig& rig, const SurfaceBuffer& surface,
                                    const Box& bounds);

/// What a constraint says of its light, its plane by name where that is one of kPlaneNames: "on ceiling".
std::string rule_words(const Constraint& constraint, const SurfaceBuffer& surface, const Box& bounds);

/// Adds constraints in words to a rig, which then keeps them; one replaces that of its light and kind. All or none.
/// errors those of parse_constraint() and check_constraints().
Result<void> add_constraints(LightRig& rig, const std::vector<std::string>& words, const SurfaceBuffer& surface,
                             const Box& bounds);

}  // namespace luminist
