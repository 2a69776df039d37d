#pragma once
// app/range_popup.h -- holds numbers of a light in a range, whoever turns them: a popup of a parameter's name.
#include <array>
#include <string>

#include "app/desk.h"
#include "params/param_block.h"

namespace luminist {

/// One for the window. A row for each number of the parameter: whether it is held, from where to where, in the units of
/// the widgets. "Keep" makes them the light's constraints (Between) in place of those that the parameter had.
class RangePopup {
 public:
  /// Behind the name of a parameter that a range can hold: a right click opens it. path: "lights/key/barn".
  void offer(Desk& desk, const ParamBlock& block, int param, const std::string& path);

 private:
  struct Row {
    bool held = false;
    float low = 0.0F;
    float high = 1.0F;
    bool operator==(const Row&) const = default;
  };
  void read(const ParamBlock& block, int param, const SceneFrame& frame);
  void record(Desk& desk, const ParamSpec& spec, const std::string& light) const;

  std::array<Row, 3> rows_{};
  std::array<Row, 3> seen_{};  ///< as they were when it was opened
};

/// Whether ranges can hold a parameter: numbers of lights that a solve turns.
bool takes_ranges(const ParamSpec& spec, const std::string& path);

}  // namespace luminist
