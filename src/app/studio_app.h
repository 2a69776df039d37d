#pragma once
// app/studio_app.h -- the studio: the window, and everything on it.
#include <filesystem>

#include "base/files.h"
#include "base/result.h"

namespace luminist {

struct StudioRequest {
  AssetRoots roots;
  std::filesystem::path path;  ///< a scene or a project; empty: the demo scene
};

/// Opens the window and comes back when it is closed. returns the exit status. Main thread.
/// errors kGl without a display or OpenGL for it; what goes wrong later is shown in the window.
Result<int> run_studio(const StudioRequest& request);

}  // namespace luminist
