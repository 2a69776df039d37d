#pragma once
// tests/bench/prep.h -- how meshes come out of repair and unwrapping, and what that costs.
#include <string>

#include "base/result.h"

namespace luminist {

struct PrepOptions {
  bool json = false;   ///< one object a line instead of a table
  std::string meshes;  ///< a folder, searched with those below; empty: generated meshes of every kind
};

/// A line a mesh. JSON: {bench: "prep", kind: "result", scene, mesh, faces, charts, rigid, flipped, area, worst_area,
/// angle, worst_angle, stretch, coherence, seams, utilization, repair_seconds, curvature_seconds, unwrap_seconds}:
/// unwrap_seconds is the whole of unwrap(), which does the other two as well. errors kMissing: no mesh in the folder;
/// a file that cannot be read is named on stderr and left out.
Result<void> run_prep(const PrepOptions& options);

}  // namespace luminist
