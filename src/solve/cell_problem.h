#pragma once
// solve/cell_problem.h -- states of the lights, compared with the target on the cells of one level.
#include <span>
#include <vector>

#include "base/result.h"
#include "render/renderer.h"
#include "solve/color_solve.h"
#include "solve/sample_cells.h"

namespace luminist {

/// A part that has the colour of another light, or its own.
struct ColoredPart {
  int part = 0;
  float factor = 1.0F;
};

/// A summand of the picture. A style that sums its lights has what is left without lights and one part a light, white
/// where its colour scales it; any other style is one part.
struct Part {
  int light = Candidate::kAllLights;  ///< as in Candidate
  int color_param = -1;               ///< of a light that its colour scales: the parameter; else -1
  std::vector<ColoredPart> colored;   ///< what its colour scales: itself and those that have it
};

/// How the picture of a rig falls into parts, and which of them a degree of freedom touches.
class PictureParts {
 public:
  /// Whether colours really scale is tried on the probe samples; where they do not, colours are as other parameters.
  /// errors the renderer's. cost 2 candidates on the probe.
  static Result<PictureParts> create(Renderer& renderer, const ParamState& state, const SampleSet& probe);

  [[nodiscard]] const std::vector<Part>& list() const { return parts_; }
  [[nodiscard]] std::vector<int> touched_by(const ParamState& state, const Dof& dof) const;
  /// Those that the degrees of freedom of some blocks touch besides colours, in order, each once.
  [[nodiscard]] std::vector<int> touched_by(const ParamState& state, const UnitMap& map,
                                            std::span<const int> blocks) const;
  /// The part that a colour channel scales, or -1 if this degree of freedom is nothing so simple.
  [[nodiscard]] int scaled_by(const Dof& dof) const;

 private:
  std::vector<Part> parts_;
};

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

/// One level's problem. Colours of unlocked lights are solved in closed form wherever a state is measured.
/// thread: the renderer's. The renderer, parts and level must outlive it.
class CellProblem {
 public:
  /// free: a state whose locks say what may change; parts that nothing unlocked touches are evaluated once.
  /// still: what is fixed on the cells, if the renderer's picture says it (moving lights left out); else empty.
  /// errors the renderer's.
  static Result<CellProblem> create(Renderer& renderer, const PictureParts& parts, const Level& level,
                                    const ParamState& free, Norm norm, const CellField& still = {});

  struct Request {
    const ParamState* state = nullptr;
    int part = 0;
  };
  /// The difference between a state's picture and what its samples say becomes part of every point from now on: the
  /// samples are then exact at that state. point: of that state; points measured before must be measured again.
  void correct(const CellPoint& point, const CellField& shown);

  /// Parts of states in one batch; result [requests.size()], white where a colour scales them.
  Result<std::vector<CellField>> evaluate(std::span<const Request> requests) const;

  /// Measures states: fields, colours (written into the state), cost; constraints hold in what comes back. One batch.
  /// Only parts in `changed` are evaluated, the rest is base's; base may be null, then everything free is.
  Result<std::vector<CellPoint>> measure(std::vector<ParamState> states, const CellPoint* base,
                                         std::span<const int> changed) const;
  Result<CellPoint> measure(const ParamState& state) const;
  /// The same with the state's own colours.
  Result<CellPoint> measure_as_is(const ParamState& state) const;

  /// What one unit of a part's colour adds: its white field, and those of the parts that have its colour.
  [[nodiscard]] CellField white(const CellPoint& point, int part) const;
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

  Renderer* renderer_ = nullptr;
  const PictureParts* parts_ = nullptr;
  const Level* level_ = nullptr;
  Norm norm_ = Norm::kUnsquared;
  std::vector<int> free_parts_;
  std::vector<ColorRange> ranges_;  ///< [parts]
  std::vector<CellField> fixed_;    ///< [parts] of what never changes; empty for free parts
  CellField offset_;                ///< [cells] what samples miss; see correct()
};

/// The colour that scales a part; ones if none does.
Vec3 part_color(const ParamState& state, const Part& part);

}  // namespace luminist
