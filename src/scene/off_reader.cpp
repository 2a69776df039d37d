#include <fmt/format.h>

#include "scene/polygon_soup.h"
#include "scene/text_cursor.h"

namespace luminist {
namespace {

/// OFF as geomview has it: "[ST][C][N]OFF", counts, a line for each vertex (x y z, the normal if N, then what we do not
/// need), a line for each face (n, n indices, then a colour).
class OffReader {
 public:
  OffReader(std::string_view bytes, PolygonSoup& soup) : text_(bytes, true), soup_(&soup) {}

  Result<void> read() {
    LUM_TRY_VOID(read_header());
    for (std::size_t i = 0; i < vertices_; ++i) LUM_TRY_VOID(read_vertex(i));
    for (std::size_t i = 0; i < faces_; ++i) LUM_TRY_VOID(read_face(i));
    return {};
  }

 private:
  [[nodiscard]] std::string here() const { return fmt::format("{}:{}", soup_->path(), text_.line()); }
  [[nodiscard]] Error bad(std::string what) const { return {ErrorKind::kBadContent, std::move(what), here(), "", ""}; }

  Result<void> read_header() {
    std::string_view keyword = text_.word();
    if (keyword.substr(0, 2) == "ST") keyword.remove_prefix(2);
    if (keyword.substr(0, 1) == "C") keyword.remove_prefix(1);
    if (keyword.substr(0, 1) == "N") keyword.remove_prefix(1), has_normals_ = true;
    if (keyword != "OFF") return bad("not an OFF file of three dimensions");
    const auto vertices = to_number<std::size_t>(text_.word());
    const auto faces = to_number<std::size_t>(text_.word());
    if (!vertices || !faces) return bad("the counts of vertices and faces are missing");
    text_.skip_line();  // the count of edges, which nobody needs
    // The shortest vertex line is "0 0 0\n" and the shortest face "3 0 0 0\n": more cannot be there.
    if (*vertices > text_.remaining() / 5 || *faces > text_.remaining() / 2) {
      return bad(fmt::format("{} vertices and {} faces do not fit into the file", *vertices, *faces));
    }
    vertices_ = *vertices, faces_ = *faces;
    soup_->reserve(vertices_);
    return {};
  }

  /// Three numbers, the first from any line, the others from the same line.
  Result<Vec3> read_three(std::string_view first, std::size_t vertex) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const auto number = to_number<double>(i == 0 ? first : text_.word_in_line());
      if (!number) return bad(fmt::format("vertex {} needs three numbers", vertex));
      p[i] = static_cast<float>(*number);
    }
    return p;
  }
  Result<void> read_vertex(std::size_t i) {
    LUM_TRY(const Vec3 position, read_three(text_.word(), i));
    soup_->add_vertex(position);
    if (has_normals_) {
      LUM_TRY(const Vec3 normal, read_three(text_.word_in_line(), i));
      soup_->add_normal(normal);
    }
    text_.skip_line();
    return {};
  }
  Result<void> read_face(std::size_t i) {
    const auto count = to_number<std::size_t>(text_.word());
    if (!count || *count > text_.remaining()) return bad(fmt::format("face {} has no count of corners", i));
    corners_.clear();
    for (std::size_t k = 0; k < *count; ++k) {
      const auto index = to_number<std::int64_t>(text_.word_in_line());
      if (!index) return bad(fmt::format("face {} ends after {} of {} corners", i, k, *count));
      corners_.push_back(*index);
    }
    soup_->add_polygon(corners_, here());
    text_.skip_line();
    return {};
  }

  TextCursor text_;
  PolygonSoup* soup_;
  bool has_normals_ = false;
  std::size_t vertices_ = 0, faces_ = 0;
  std::vector<std::int64_t> corners_;
};

}  // namespace

Result<void> read_off(std::string_view bytes, PolygonSoup& soup) {
  return OffReader(bytes, soup).read();
}

}  // namespace luminist
