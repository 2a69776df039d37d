#include "scene/texture_image.h"

#include <algorithm>

namespace luminist {

Image as_color(Image image) {
  if (image.channels == 3 || image.channels == 4) return image;
  const bool grey = image.channels <= 2;
  Image result(image.width, image.height, image.channels == 1 ? 3 : 4);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) result.at(x, y, c) = image.at(x, y, grey ? 0 : c);
      if (result.channels == 4) result.at(x, y, 3) = image.at(x, y, grey ? 1 : 3);
    }
  }
  return result;
}

}  // namespace luminist
