#pragma once
// project/paint_document.h -- a canvas as paths of a document, its pixels as tiles.
#include "paint/canvas.h"
#include "project/document.h"
#include "project/tile_store.h"

namespace luminist {

/// Paths: "paint/nu", "paint/delta", "paint/strokes", "paint/peak", a plane of tiles "paint/PLANE/X,Y" for each image
/// (project/tile_planes.h), and the layers (project/layer_document.h). A canvas without strokes keeps only its layers
/// and the importance of the last accepted solve: its picture is rendered again. errors kUnwritable. cost O(pixels),
/// hashing.
Result<void> write_paint(const CanvasState& canvas, Document& document, TileStore& tiles);

/// Whether the document holds strokes.
bool has_paint(const Document& document);

/// Puts the document's paint into a canvas; `fresh` is the state of an unpainted one of the right size.
/// errors kBadContent and kMissing, naming the path or the tile.
Result<CanvasState> read_paint(const Document& document, const TileStore& tiles, CanvasState fresh);

}  // namespace luminist
