#pragma once
// verdict/judge.h -- judges a solve stroke by stroke.
#include <functional>

#include "base/result.h"
#include "render/renderer.h"
#include "verdict/verdict.h"

namespace luminist {

struct JudgeOptions {
  const Light* new_light = nullptr;  ///< as made: what "add a light" adds; null: as the rig's first, if there is one
  std::function<bool()> go_on;       ///< asked before every batch of candidates; false cancels the verdict
};

/// What became of each stroke of `target` in `state`, whose locks are those of the solve and whose picture is
/// `picture`.
///
/// A stroke that the picture shows is met. For any other a search on some of its pixels tries what is free, for this
/// stroke alone. If that helps, the lights that it found go on with everything that is wished: either the whole gets
/// better too, on the full picture (missed), or the stroke is conflicting, with whoever must be left out for it to be
/// met. If it does not help, or is certified not to, the stroke is impossible, and locks are opened one after another
/// and lights added from many sides to say why. A stroke that nothing brings nearer, of which half came true, is met as
/// near as light comes.
///
/// Works through evaluate() and pictures alone. Where a style's metric blurs, what is painted and what is shown are
/// blurred first, and candidates show the mean of their dots and strokes.
/// Where samples are estimates (a path tracer's), distances are those that are left when what chance alone makes is
/// taken off, a gain must be larger than chance, and what is said of a stroke says how much chance hides.
/// errors the renderer's; kCancelled. cost for each stroke that is not met a few hundred candidates several times over
/// on 64 to some hundred samples, whatever the size of the picture; besides, once if any is not met, the pictures of
/// AttainableColors. thread: the renderer's.
Result<Verdict> judge(Renderer& renderer, const ParamState& state, const Target& target, const Image& picture,
                      const JudgeOptions& options = {});

}  // namespace luminist
