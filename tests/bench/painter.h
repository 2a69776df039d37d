#pragma once
// tests/bench/painter.h -- a hand that paints targets: crude, unsteady, the same again for the same seed.
#include <span>
#include <string>
#include <vector>

#include "bench/bench_scene.h"
#include "paint/canvas.h"
#include "solve/random.h"

namespace luminist {

/// A canvas over the picture of a state; its shadow brushes see that state's free lights. errors the renderer's.
Result<Canvas> canvas_on(const BenchStage& stage, const ParamState& state);

/// A committed stroke file. errors those of load_strokes().
Result<StrokeFile> committed_strokes(const std::string& file);

/// As another hand would have painted it: points off by a few thousandths of the picture's height and colours by a few
/// percent, a bucket's colour too.
StrokeFile unsteady(StrokeFile strokes, Random& random);

/// Round dabs of one brush over the pixels of a mask [pixels]: one for each cell of the brush's size of which at least
/// half is in the mask, a little off its middle.
std::vector<Stroke> dabs(const Brush& brush, std::span<const unsigned char> mask, int width, int height,
                         Random& random);

/// The same with colours from a picture: each dab has the picture's mean over the masked part of its cell.
std::vector<Stroke> colored_dabs(const Brush& brush, const Image& picture, std::span<const unsigned char> mask,
                                 Random& random);

}  // namespace luminist
