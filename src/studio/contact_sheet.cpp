#include <algorithm>

#include "studio/drawing.h"
#include "studio/results.h"

namespace luminist {
namespace {

constexpr int kGap = 12;

int scaled_height(const Image& image, int width) {
  return std::max(1, static_cast<int>(static_cast<long>(image.height) * width / std::max(image.width, 1)));
}

}  // namespace

Image contact_sheet(const std::vector<std::string>& columns, const std::vector<SheetRow>& rows, int column_width) {
  const int line = text_height(kTextScale) + kGap / 2;
  int height = kGap + line;
  std::vector<int> row_heights;
  for (const SheetRow& row : rows) {
    int tallest = 0;
    for (const Image& picture : row.pictures) tallest = std::max(tallest, scaled_height(picture, column_width));
    row_heights.push_back(line + tallest + kGap);
    height += row_heights.back();
  }
  Image sheet(kGap + static_cast<int>(columns.size()) * (column_width + kGap), height, 3);
  Drawing drawing(sheet);
  const Vec3 ink = rgb8(225, 225, 222);
  drawing.fill(0, 0, sheet.width, sheet.height, rgb8(40, 40, 42));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    drawing.text(kGap + static_cast<int>(c) * (column_width + kGap), kGap, columns[c], kTextScale, ink);
  }
  int y = kGap + line;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    drawing.text(kGap, y, rows[r].label, kTextScale, rgb8(150, 150, 150));
    for (std::size_t c = 0; c < rows[r].pictures.size(); ++c) {
      const Image& picture = rows[r].pictures[c];
      drawing.picture(kGap + static_cast<int>(c) * (column_width + kGap), y + line,
                      resized(picture, column_width, scaled_height(picture, column_width)));
    }
    y += row_heights[r];
  }
  return sheet;
}

}  // namespace luminist
