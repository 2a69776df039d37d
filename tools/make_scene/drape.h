#pragma once
// make_scene/drape.h -- cloth that falls over things.
#include "make_scene/sdf.h"

namespace luminist {

struct Drape {
  Surface start;          ///< where the cloth hangs at first; u and v run along its edges
  Point2 size{0.5, 0.5};  ///< of the flat cloth; a start that is smaller makes folds
  int columns = 90;
  int rows = 80;
  Field obstacle;             ///< what it falls on
  Field ceiling;              ///< optional: the height below which it is pressed, by (x, z)
  double thickness = 0.0015;  ///< distance kept from the obstacle
  double friction = 0.8;      ///< Coulomb's coefficient
  int steps = 400;            ///< of 1/120 s
};

/// Position based dynamics (Mueller et al. 2007) with stretch, shear and bend constraints, until it rests, about.
/// Texture coordinates are (u, v). cost columns x rows x steps x 0.3 us.
Mesh fallen(const Drape& drape);

}  // namespace luminist
