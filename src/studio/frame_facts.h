#pragma once
// studio/frame_facts.h -- what a window shows of a shot's frames.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/image.h"
#include "project/frame_paint.h"
#include "studio/solved.h"

namespace luminist {

/// A small picture of a frame.
struct FramePicture {
  double frame = 0.0;
  std::shared_ptr<const Image> picture;
  bool old = false;  ///< under other lights than those shown; it will be made again
};

struct FrameFacts {
  std::string camera;  ///< that is looked through
  double frame = 0.0;  ///< that is looked at
  double fps = 24.0;
  int first = 0;  ///< range of what moves, of the keys and the paint; two seconds at least
  int last = 0;
  bool moving = false;                ///< something of the scene does
  std::optional<double> previewed;    ///< the picture shown is a quick one of this frame
  std::vector<PaintedFrame> painted;  ///< by any camera
  std::vector<FramePicture> strip;    ///< ascending
  std::vector<SolvedFrame> solved;    ///< of a proposal for several; without their paint

  [[nodiscard]] bool several_cameras() const {  ///< are painted through
    return std::ranges::any_of(painted, [&](const auto& each) { return each.at.camera != painted[0].at.camera; });
  }
};

}  // namespace luminist
