#pragma once
// solve/cell_problem.h -- states of the lights, compared with the target on the cells of one level.
#include <span>
#include <vector>

#include "base/result.h"
#include "render/renderer.h"
#include "solve/color_solve.h"
#include "solve/picture_parts.h"
#include "solve/sample_cells.h"

namespace luminist {

/// Samples, how soft edges are, and how far parameters step when a slope is wanted (unit coordinates): the sharper the
/// picture, the shorter.
struct Level {
  SampleCells cells;
  Softness softness;
  double position_step = 0.01;  ///< of positions
  double step = 0.01;           ///< of all others
  int iterations = 12;          ///< at most
};

/// A state and its parts on the cells of one level.
struct CellPoint {
  ParamState state;
  std::vector<CellField> fields;  ///< [parts], white where a colour scales them
  double cost = 0.0;
};

/// One level's problem. Colours of unlocked lights and of the style that scale parts are solved wherever a state is
/// measured: each kind in closed form, in turns where both are free.
/// thread: the renderer's. The renderer, parts and level must outlive it.
class CellProblem {
 public:
  /// free: a state whose locks say what may change; parts that nothing unlocked touches are evaluated once.
  /// still: what is fixed on the cells, if the renderer's picture says it (moving lights left out); else empty.
  /// errors the renderer's.
  static Result<CellProblem> create(Renderer& renderer, const PictureParts& parts, const Level& level,
                                    const ParamState& free, Norm norm, const CellField& still = {});

  /// together: of a rest, with what the style's colours scale, as they are in the state; only the light's is white.
  struct Request {
    const ParamState* state = nullptr;
    int part = 0;
    bool together = false;
  };
  /// The difference between a state's picture and what its samples say becomes part of every point from now on: the
  /// samples are then exact at that state. point: of that state; points measured before must be measured again.
  void correct(const CellPoint& point, const CellField& shown);

  /// Parts of states in one batch; result [requests.size()], white where colours scale them. The rest of a light comes
  /// before its parts that the style scales.
  Result<std::vector<CellField>> evaluate(std::span<const Request> requests) const;

  /// Measures states: fields, colours (written into the state), cost; constraints hold in what comes back. One batch.
  /// Only parts in `changed` are evaluated, the rest is base's; base may be null, then everything free is.
  Result<std::vector<CellPoint>> measure(std::vector<ParamState> states, const CellPoint* base,
                                         std::span<const int> changed) const;
  Result<CellPoint> measure(const ParamState& state) const;
  /// The same with the state's own colours.
  Result<CellPoint> measure_as_is(const ParamState& state) const;

  /// What one unit of a colour (of parts().colors()) adds to the picture, the other colours being the point's.
  [[nodiscard]] CellField white(const CellPoint& point, int color) const;
  /// The field of a rest together with what the style's colours scale, as they are in the point.
  [[nodiscard]] CellField together(const CellPoint& point, int rest) const;
  /// The picture of a point on the cells.
  [[nodiscard]] CellField picture(const CellPoint& point) const;
  [[nodiscard]] const std::vector<int>& free_parts() const { return free_parts_; }
  [[nodiscard]] const Level& level() const { return *level_; }
  [[nodiscard]] const PictureParts& parts() const { return *parts_; }
  [[nodiscard]] Norm norm() const { return norm_; }
  [[nodiscard]] SceneFrame frame() const { return renderer_->frame(); }

 private:
  CellProblem() = default;
  void settle(CellPoint& point) const;  ///< solves colours, computes the cost
  /// Solves the free colours of the lights, or those of the style. returns whether there are any.
  bool solve_colors_of(CellPoint& point, bool style) const;

  Renderer* renderer_ = nullptr;
  const PictureParts* parts_ = nullptr;
  const Level* level_ = nullptr;
  Norm norm_ = Norm::kUnsquared;
  std::vector<int> free_parts_;
  std::vector<ColorRange> ranges_;  ///< [colors]
  std::vector<CellField> fixed_;    ///< [parts] of what never changes; empty for free parts
  CellField offset_;                ///< [cells] what samples miss; see correct()
};

}  // namespace luminist
