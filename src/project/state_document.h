#pragma once
// project/state_document.h -- the rig, the parameters of style and materials and all locks as paths of a document.
#include <string>
#include <vector>

#include "project/document.h"
#include "render/param_state.h"

namespace luminist {

/// Paths: "rig/lights" (names in order), "rig/shadow_light", "rig/constraints" (objects as the tables of a rig file;
/// absent if there are none), "lights/NAME/@type", "@group", "@muted", "@objects" (absent: it lights everything),
/// "lights/NAME/PARAM", "ambient/PARAM", "style/PARAM", "materials/NAME/PARAM" (absent: as the scene has it),
/// "keys/lights/NAME/PARAM" (arrays of [frame, interpolation, numbers...]; "PARAM.x" for keys of one number of it), and
/// "locks/..." of each of these: one boolean per degree of freedom. Values are exact: what is read back has the same
/// bits. Paths of other kinds stay as they are, but lights that are not in the state are erased.
void write_state(const ParamState& state, Document& document);

/// The state keeps its constraints. materials: as the scene has them. errors kBadContent naming the path; kUsage for an
/// unknown light type.
Result<ParamState> read_state(const Document& document, const LightTypes& types, const Style& style,
                              const SceneFrame& frame, std::vector<MaterialParams> materials = {});

/// Names of materials of which the document says something and the state's scene has none.
std::vector<std::string> missing_materials(const Document& document, const ParamState& state);

}  // namespace luminist
