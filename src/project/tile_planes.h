#pragma once
// project/tile_planes.h -- images as paths of a document, their pixels as tiles.
#include <string>

#include "base/image.h"
#include "project/document.h"
#include "project/tile_store.h"

namespace luminist {

/// Side of a tile in pixels; the tiles at the right and lower edges are smaller.
inline constexpr int kTileSide = 64;

/// "PLANE/X,Y" for each tile of the image. A tile of one value is written as that value (a number, or an array of the
/// channels), any other by its name in the store. errors kUnwritable. cost O(pixels), hashing.
Result<void> write_plane(const Image& image, const std::string& plane, Document& document, TileStore& tiles);
/// Reads all tiles of an image that has its size already. errors kBadContent and kMissing, naming path or tile.
Result<void> read_plane(const Document& document, const std::string& plane, const TileStore& tiles, Image& image);
bool has_plane(const Document& document, const std::string& plane);

/// A path of the paint that says what it must not.
Error wrong_paint(const std::string& path, const std::string& what);

}  // namespace luminist
