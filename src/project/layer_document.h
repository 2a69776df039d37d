#pragma once
// project/layer_document.h -- layers and their strokes as paths of a document.
#include "paint/canvas.h"
#include "project/document.h"
#include "project/tile_store.h"

namespace luminist {

/// Paths: "paint/layers/I" with name, visible, opacity and the numbers of its strokes, lowest first; "paint/kept/N"
/// with the stroke of that number as in stroke files, the peak that it repeats and the name of what it copies, whose
/// pixels are "paint/sources/NAME/..."; "paint/counts/N"; "paint/ground/...". One empty layer without a ground is not
/// written. errors kUnwritable. cost O(strokes), of sources that are new O(pixels).
Result<void> write_layers(const LayerStack& layers, Document& document, TileStore& tiles);

/// The layers of a canvas whose composite was read. Paint of a project that knows no layers becomes the ground.
/// errors kBadContent and kMissing, naming the path or the tile.
Result<void> read_layers(const Document& document, const TileStore& tiles, CanvasState& canvas);

/// The layers without any pixels: neither what strokes copy, nor the ground. errors kBadContent. cost O(points).
Result<LayerStack> read_stack(const Document& document);
/// Whether there is paint whose strokes are not known.
bool has_ground(const Document& document);

}  // namespace luminist
