#pragma once
// scene/material_params.h -- what may be turned of a scene's materials, beside its lights.
#include <memory>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/result.h"
#include "params/param_block.h"
#include "scene/material.h"
#include "scene/scene.h"

namespace luminist {

/// One material's parameters. The schema's defaults are the values that the scene has.
struct MaterialParams {
  std::string name;  ///< as material_names() has it
  ParamBlock params;
};

/// shaders/material.toml, whose parameters C++ finds by their roles: "tint" (color), "specular", "roughness" (float).
/// errors kMissing; kStyle at the manifest's line, or naming the role that is missing.
Result<std::shared_ptr<const ParamSchema>> load_material_schema(const AssetRoots& roots);

/// Names of a scene's materials, each once and good for a path: "/ * = :", control characters and what is no UTF-8 are
/// "-", one without a name is "material", and one whose name is taken gets "-2", "-3"... in the order of the scene.
std::vector<std::string> material_names(const std::vector<Material>& materials);

/// The parameters of a scene's materials, in its order, locked as the schema says. What a material has outside of a
/// range widens it; the tint of a colour without a texture ranges up to where all light is reflected.
std::vector<MaterialParams> material_params(const std::vector<Material>& materials, const ParamSchema& schema);

/// What a material's parameters make of a surface, as the raster engine's shaders read it. Factors of what the surface
/// has, so that textures keep their detail; shifts where the material's own factor is 0 and a factor would do nothing.
struct MaterialTurn {
  Vec3 tint{1.0F};
  float roughness_scale = 1.0F;
  float roughness_shift = 0.0F;
  float specular_scale = 1.0F;
  float specular_shift = 0.0F;  ///< of the reflectance at normal incidence
  float turns = 0.0F;           ///< 0: every surface stays as it is, to the bit

  [[nodiscard]] bool nothing() const { return turns == 0.0F; }
};
static_assert(sizeof(MaterialTurn) == 32, "LumMaterial of shaders/lib/host.glsl");

MaterialTurn turn_of(const ParamBlock& params);

/// A place on a surface: what a MaterialTurn changes.
struct SurfaceColors {
  Vec3 albedo{0.0F};        ///< diffuse reflectance
  Vec3 specular{0.0F};      ///< reflectance at normal incidence
  float dielectric = 0.0F;  ///< the share of specular that has no colour; the rest is a metal's
  float roughness = 0.0F;
};
/// The surface, turned: finite and reflecting at most what arrives, whatever the parameters (a solver may leave their
/// ranges). lum_turn() of shaders/lib/host.glsl is the same.
SurfaceColors turned(const MaterialTurn& turn, const SurfaceColors& colors);

/// The scene with its materials as the parameters have them, for other programs: factors where they say it exactly. A
/// tint that a factor cannot say (above 1, under a texture) becomes a texture of the material's own. params: of this
/// scene (LUM_CHECK), or none.
Scene with_materials(Scene scene, const std::vector<MaterialParams>& params);

}  // namespace luminist
