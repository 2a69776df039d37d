#include "scene/face_faults.h"

#include <fmt/format.h>

namespace luminist {

void FaceFaults::report(Diagnostics& diagnostics) const {
  if (count_ == 0) return;
  diagnostics.warn(where_,
                   fmt::format("{} face{} dropped: {} (first: {})", count_, count_ == 1 ? "" : "s", what_, detail_));
}

}  // namespace luminist
