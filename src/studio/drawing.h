#pragma once
// studio/drawing.h -- lines and words on an image, for plots and sheets.
#include <string_view>

#include "base/image.h"

namespace luminist {

/// A point in pixels from the upper left corner.
struct DrawPoint {
  float x = 0.0F;
  float y = 0.0F;
};

/// Draws into a three-channel image, antialiased, clipped at its borders. Colours are linear.
class Drawing {
 public:
  explicit Drawing(Image& image) : image_(&image) {}

  void fill(int x, int y, int width, int height, const Vec3& color);
  /// A straight line of that width with round ends.
  void line(DrawPoint from, DrawPoint to, float width_px, const Vec3& color);
  /// Latin letters, digits and some signs, 7 pixels high times scale above the baseline; others are left blank.
  /// (x, y) is the upper left corner. returns where the next letter would start.
  int text(int x, int y, std::string_view words, int scale, const Vec3& color);
  /// Copies a picture of one or three channels.
  void picture(int x, int y, const Image& picture);

 private:
  void blend(int x, int y, const Vec3& color, float coverage);
  Image* image_;
};

/// Pixels that a text takes: width, and height down to the lowest descender.
int text_width(std::string_view words, int scale);
int text_height(int scale);
inline constexpr int kTextScale = 2;  ///< of words on plots and sheets

/// "#rrggbb" as three numbers 0 to 255, decoded to linear.
Vec3 rgb8(int red, int green, int blue);

}  // namespace luminist
