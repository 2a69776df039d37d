#pragma once
// app/channels.h -- the pictures that a canvas can show of a session.
#include <span>
#include <string>

#include "app/display.h"
#include "base/image.h"
#include "studio/studio_snapshot.h"

namespace luminist {

enum class Channel {
  kLight,       ///< what the lights make of it; strokes that no solve has answered lie over it
  kPaint,       ///< what is painted
  kResidual,    ///< where the two differ, as much as it counts: a heat map
  kImportance,  ///< how much each pixel counts, as the paper prints it: black counts most
  kWeighed,     ///< the same with the picture faintly in it, to paint importance on
  kAlbedo,
  kNormal,    ///< (n + 1) / 2
  kDistance,  ///< from the eye: near is bright
  kObjects,   ///< a colour for each
};

struct ChannelFacts {
  const char* name;
  const char* doc;
};
const ChannelFacts& facts_of(Channel channel);
/// How a channel is shown when light is shown like that: exposure is for light, numbers are shown as they are.
DisplayOptions display_of(Channel channel, const DisplayOptions& light);
inline constexpr int kChannels = 9;

/// The picture of a channel, 1 or 3 channels, linear. cost O(pixels); nothing but a copy for the first two.
Image channel_image(const StudioSnapshot& snapshot, Channel channel);

}  // namespace luminist
