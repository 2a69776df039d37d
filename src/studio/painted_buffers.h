#pragma once
// studio/painted_buffers.h -- what is painted as values for others to keep, without a copy of it all for each event.
#include <array>
#include <cstdint>
#include <memory>

#include "paint/coverage.h"
#include "render/target.h"
#include "studio/studio_snapshot.h"

namespace luminist {

/// A few buffers in turn. One that nobody looks at any more takes what changed since it was filled.
class PaintedBuffers {
 public:
  /// Inside the box the target is another than when it was shown last.
  void note(const PixelBox& changed);
  /// All of it may be.
  void note_all();
  /// Another target takes the place of the one that was noted until now (null: of none that is known). cost O(pixels)
  void note_change(const Target* before, const Target& now);
  /// The target as it is now. cost O(pixels that changed), of all if every buffer is held.
  std::shared_ptr<const PaintedPictures> show(const Target& target);

 private:
  struct Buffer {
    std::shared_ptr<PaintedPictures> pictures;
    PixelBox stale;
    bool all_stale = true;
  };
  std::array<Buffer, 4> buffers_;  ///< the thread's latest, what the window draws, what it drew before, one more
};

}  // namespace luminist
