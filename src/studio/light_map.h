#pragma once
// studio/light_map.h -- where the lights stand, as a drawing (paper, Figure 7(d)).
#include <span>

#include "base/image.h"
#include "render/surface_buffer.h"
#include "rig/light_rig.h"

namespace luminist {

enum class MapView {
  kAbove,  ///< the camera is below the drawing and looks up
  kSide,   ///< the camera is on the left and looks right
};

/// What all drawings of one sheet share, so that they can be compared.
struct MapScale {
  SceneFrame frame;
  float extent = 1.0F;  ///< world lengths from the scene's centre to the border
};

/// Wide enough for all lights of all rigs, up to six scene radii; what stands farther is drawn at the border.
MapScale map_scale(std::span<const LightRig* const> rigs, const SceneFrame& frame);

/// What the camera sees as dots, each unmuted light as a disc in its colour with a line the way it shines and its name,
/// the camera as a wedge. Lights are found by the roles of their parameters. returns width x height pixels, linear RGB.
Image light_map(const LightRig& rig, const SurfaceBuffer& surface, const MapScale& scale, MapView view, int width,
                int height);

}  // namespace luminist
