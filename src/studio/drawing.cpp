#include "studio/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luminist {
namespace {

constexpr int kGlyphWidth = 5;
constexpr int kGlyphHeight = 9;

/// Nine rows from the top, the last two below the baseline; a row is five pixels as one digit of base 32.
struct Glyph {
  char letter;
  const char* rows;
};

constexpr std::array kGlyphs = {
    Glyph{'0', "ehjlphe00"}, Glyph{'1', "4c4444e00"},  Glyph{'2', "eh168gv00"}, Glyph{'3', "eh161he00"},
    Glyph{'4', "26aiv2200"}, Glyph{'5', "vgu11he00"},  Glyph{'6', "68guhhe00"}, Glyph{'7', "v12444400"},
    Glyph{'8', "ehhehhe00"}, Glyph{'9', "ehhf12c00"},  Glyph{'A', "ehhvhhh00"}, Glyph{'B', "uhhuhhu00"},
    Glyph{'C', "ehggghe00"}, Glyph{'D', "uhhhhhu00"},  Glyph{'E', "vgguggv00"}, Glyph{'F', "vgguggg00"},
    Glyph{'G', "ehgnhhe00"}, Glyph{'H', "hhhvhhh00"},  Glyph{'I', "e44444e00"}, Glyph{'J', "72222ic00"},
    Glyph{'K', "hikokih00"}, Glyph{'L', "ggggggv00"},  Glyph{'M', "hrllhhh00"}, Glyph{'N', "hpljhhh00"},
    Glyph{'O', "ehhhhhe00"}, Glyph{'P', "uhhuggg00"},  Glyph{'Q', "ehhhlid00"}, Glyph{'R', "uhhukih00"},
    Glyph{'S', "fgge11u00"}, Glyph{'T', "v44444400"},  Glyph{'U', "hhhhhhe00"}, Glyph{'V', "hhhhha400"},
    Glyph{'W', "hhhllrh00"}, Glyph{'X', "hha4ahh00"},  Glyph{'Y', "hha444400"}, Glyph{'Z', "v1248gv00"},
    Glyph{'a', "00e1fhf00"}, Glyph{'b', "gguhhhu00"},  Glyph{'c', "00egghe00"}, Glyph{'d', "11fhhhf00"},
    Glyph{'e', "00ehvge00"}, Glyph{'f', "698s88800"},  Glyph{'g', "00fhhhf1e"}, Glyph{'h', "ggmphhh00"},
    Glyph{'i', "40c444e00"}, Glyph{'j', "2062222ic"},  Glyph{'k', "ggikoki00"}, Glyph{'l', "c44444e00"},
    Glyph{'m', "00qllll00"}, Glyph{'n', "00mphhh00"},  Glyph{'o', "00ehhhe00"}, Glyph{'p', "00uhhhugg"},
    Glyph{'q', "00fhhhf11"}, Glyph{'r', "00mpggg00"},  Glyph{'s', "00fge1u00"}, Glyph{'t', "88s889600"},
    Glyph{'u', "00hhhjd00"}, Glyph{'v', "00hhha400"},  Glyph{'w', "00hhlla00"}, Glyph{'x', "00ha4ah00"},
    Glyph{'y', "00hhhhf1e"}, Glyph{'z', "00v248v00"},  Glyph{'.', "00000cc00"}, Glyph{',', "00000cc48"},
    Glyph{':', "0cc0cc000"}, Glyph{'-', "000e00000"},  Glyph{'+', "044v44000"}, Glyph{'/', "11248gg00"},
    Glyph{'(', "248884200"}, Glyph{')', "842224800"},  Glyph{'=', "00v0v0000"}, Glyph{'%', "pp248jj00"},
    Glyph{'_', "000000v00"}, Glyph{'\'', "448000000"}, Glyph{'"', "aa0000000"}, Glyph{'!', "444440400"},
    Glyph{'&', "cik8lid00"},
};

const char* rows_of(char letter) {
  const auto* glyph = std::find_if(kGlyphs.begin(), kGlyphs.end(), [&](const Glyph& g) { return g.letter == letter; });
  return glyph == kGlyphs.end() ? nullptr : glyph->rows;
}

int row_bits(char digit) {
  return digit <= '9' ? digit - '0' : digit - 'a' + 10;
}

}  // namespace

void Drawing::blend(int x, int y, const Vec3& color, float coverage) {
  if (x < 0 || y < 0 || x >= image_->width || y >= image_->height || coverage <= 0.0F) return;
  const std::size_t pixel = image_->index(x, y);
  image_->set_rgb(pixel, glm::mix(image_->rgb(pixel), color, std::min(coverage, 1.0F)));
}

void Drawing::fill(int x, int y, int width, int height, const Vec3& color) {
  for (int row = std::max(y, 0); row < std::min(y + height, image_->height); ++row) {
    for (int column = std::max(x, 0); column < std::min(x + width, image_->width); ++column) {
      image_->set_rgb(image_->index(column, row), color);
    }
  }
}

void Drawing::line(DrawPoint from, DrawPoint to, float width_px, const Vec3& color) {
  const Vec2 a(from.x, from.y);
  const Vec2 along = Vec2(to.x, to.y) - a;
  const float length_squared = glm::dot(along, along);
  const float reach = 0.5F * width_px + 1.0F;
  const auto low = [&](float u, float v) { return static_cast<int>(std::floor(std::min(u, v) - reach)); };
  const auto high = [&](float u, float v) { return static_cast<int>(std::ceil(std::max(u, v) + reach)); };
  for (int y = std::max(low(from.y, to.y), 0); y <= std::min(high(from.y, to.y), image_->height - 1); ++y) {
    for (int x = std::max(low(from.x, to.x), 0); x <= std::min(high(from.x, to.x), image_->width - 1); ++x) {
      const Vec2 p = Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F) - a;
      const float t = length_squared > 0.0F ? std::clamp(glm::dot(p, along) / length_squared, 0.0F, 1.0F) : 0.0F;
      blend(x, y, color, 0.5F * width_px + 0.5F - glm::length(p - t * along));
    }
  }
}

int Drawing::text(int x, int y, std::string_view words, int scale, const Vec3& color) {
  for (const char letter : words) {
    const char* rows = rows_of(letter);
    for (int row = 0; rows != nullptr && row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        const bool ink = (row_bits(rows[row]) >> (kGlyphWidth - 1 - column) & 1) != 0;
        if (ink) fill(x + column * scale, y + row * scale, scale, scale, color);
      }
    }
    x += (kGlyphWidth + 1) * scale;
  }
  return x;
}

void Drawing::picture(int x, int y, const Image& picture) {
  for (int row = 0; row < picture.height; ++row) {
    for (int column = 0; column < picture.width; ++column) {
      const std::size_t from = picture.index(column, row);
      blend(x + column, y + row, picture.channels == 1 ? Vec3(picture.data[from]) : picture.rgb(from), 1.0F);
    }
  }
}

int text_width(std::string_view words, int scale) {
  return static_cast<int>(words.size()) * (kGlyphWidth + 1) * scale;
}
int text_height(int scale) {
  return kGlyphHeight * scale;
}

Vec3 rgb8(int red, int green, int blue) {
  const auto linear = [](int value) { return linear_from_srgb(static_cast<float>(value) / 255.0F); };
  return {linear(red), linear(green), linear(blue)};
}

}  // namespace luminist
