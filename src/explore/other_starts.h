#pragma once
// explore/other_starts.h -- where a solve begins that is to end elsewhere.
#include <vector>

#include "render/param_state.h"
#include "solve/random.h"
#include "solve/sample_cells.h"

namespace luminist {

/// A start and the same with what was moved held there.
struct OtherStart {
  ParamState state;
  ParamState held;
};

/// Draws states in which free lights stand elsewhere: they go on shining at the same place with the same footprint, but
/// from another side of it, as far as can be from the sides that were tried before, and nearer or farther by up to an
/// octave. Every light is drawn every other time, one at least. A light that cannot be moved, and what else is free of
/// a state without lights to move, is jittered by a third of its ranges. All values are within their ranges.
class OtherStarts {
 public:
  /// The cells say where the picture counts and which way its surfaces face; they must outlive it.
  OtherStarts(const ParamState& home, const SampleCells& cells, const SceneFrame& frame, const Vec3& focus,
              std::uint64_t seed);
  OtherStart next();

 private:
  struct Mover {
    std::size_t light = 0;
    Vec3 aim{0.0F};
    Vec3 normal{0.0F, 1.0F, 0.0F};  ///< of the surfaces around the aim, unit
    float distance = 1.0F;
    bool turns = false;       ///< its direction is free, or it has none
    std::vector<Vec3> sides;  ///< unit ways from the aim to where it stood, all that were tried
  };
  void move(Mover& mover, OtherStart& start);
  void jitter(std::size_t block, ParamState& state);
  [[nodiscard]] Vec3 other_side(const Mover& mover);

  ParamState home_;
  const SampleCells* cells_;
  SceneFrame frame_;
  Random random_;
  std::vector<Mover> movers_;
  std::vector<std::size_t> jittered_;  ///< blocks with free parameters but none to move
};

}  // namespace luminist
