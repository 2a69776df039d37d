#pragma once
// app/timeline.h -- frames on the screen, and which keys are shown in which row.
#include <string>
#include <vector>

#include "rig/light_rig.h"

namespace luminist {

/// A line of the timeline: keys of one track, or of all that a light has.
struct KeyRow {
  std::string name;     ///< "position.x", "key"
  std::string pattern;  ///< of its keys: "lights/key/position.x", "lights/key"
  std::vector<Key> keys;
};
/// The tracks of the light that is selected; without one a row for each light that has keys.
std::vector<KeyRow> key_rows(const LightRig& rig, const std::string& selected);

/// Frames and screen: where a frame lies on the timeline.
struct TimeScale {
  float left = 0.0F;
  float right = 1.0F;
  int first = 0;
  int last = 1;

  [[nodiscard]] float x_of(double frame) const;
  [[nodiscard]] double frame_at(float x) const;  ///< whole, inside the range
  [[nodiscard]] int step(float least_px) const;  ///< frames between labels: 1, 2, 5, 10...
};

}  // namespace luminist
