#include <cstring>

#include <fmt/format.h>

#include "scene/polygon_soup.h"
#include "scene/text_cursor.h"
#include "scene/triple_index.h"

namespace luminist {
namespace {

/// STL repeats every corner; equal positions become one vertex.
class Welder {
 public:
  Welder(PolygonSoup& soup, std::size_t expected) : soup_(&soup), index_(expected) {}
  std::int64_t vertex(const Vec3& p) {
    const std::size_t known = index_.size();
    const std::uint32_t index = index_.add(position_bits(p));
    if (index_.size() > known) soup_->add_vertex(p);
    return index;
  }

 private:
  PolygonSoup* soup_;
  TripleIndex index_;
};

constexpr std::size_t kHeader = 84, kRecord = 50;  // bytes: 80 of comment and a count; normal, 3 corners, 2 unused

std::size_t declared_triangles(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeader) std::memcpy(&count, bytes.data() + 80, sizeof(count));
  return count;
}

Result<void> read_binary(std::string_view bytes, PolygonSoup& soup) {
  const std::size_t count = declared_triangles(bytes);
  if (bytes.size() < kHeader || count > (bytes.size() - kHeader) / kRecord) {
    return Error{ErrorKind::kBadContent, fmt::format("{} triangles do not fit into {} bytes", count, bytes.size()),
                 soup.path(), "", "the file is cut off or not an STL file"};
  }
  Welder welder(soup, count / 2);
  for (std::size_t i = 0; i < count; ++i) {
    float numbers[12];
    std::memcpy(numbers, bytes.data() + kHeader + i * kRecord, sizeof(numbers));
    std::int64_t corners[3];
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = welder.vertex({numbers[3 + 3 * k], numbers[4 + 3 * k], numbers[5 + 3 * k]});
    }
    soup.add_polygon(corners, soup.path());
  }
  return {};
}

Result<void> read_text(std::string_view bytes, PolygonSoup& soup) {
  TextCursor text(bytes, false);
  const auto here = [&] { return fmt::format("{}:{}", soup.path(), text.line()); };
  Welder welder(soup, bytes.size() / 256);
  std::vector<std::int64_t> corners;
  bool inside = false;
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    if (word == "solid" || word == "endsolid") {
      inside = word == "solid";
      text.skip_line();  // a name, which may hold any word
    } else if (word == "vertex") {
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        const auto number = to_number<double>(text.word());
        if (!number) return Error{ErrorKind::kBadContent, "a vertex needs three numbers", here(), "", ""};
        p[i] = static_cast<float>(*number);
      }
      corners.push_back(welder.vertex(p));
    } else if (word == "endfacet") {
      soup.add_polygon(corners, here());
      corners.clear();
    }
  }
  if (inside || !corners.empty())
    return Error{ErrorKind::kBadContent, "the file ends before \"endsolid\"", here(), "", "it is cut off"};
  return {};
}

}  // namespace

Result<void> read_stl(std::string_view bytes, PolygonSoup& soup) {
  // Some binary files begin with "solid" too, so the size decides first.
  const bool exact = bytes.size() >= kHeader && bytes.size() == kHeader + kRecord * declared_triangles(bytes);
  const std::string_view start = bytes.substr(0, 5);
  return !exact && start == "solid" ? read_text(bytes, soup) : read_binary(bytes, soup);
}

}  // namespace luminist
