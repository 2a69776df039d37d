#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "scene/polygon_soup.h"
#include "scene/text_cursor.h"

namespace luminist {
namespace {

enum class Type { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

std::optional<Type> type_named(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, Type>, 16> kTypes{{
      {"char", Type::kInt8},
      {"int8", Type::kInt8},
      {"uchar", Type::kUint8},
      {"uint8", Type::kUint8},
      {"short", Type::kInt16},
      {"int16", Type::kInt16},
      {"ushort", Type::kUint16},
      {"uint16", Type::kUint16},
      {"int", Type::kInt32},
      {"int32", Type::kInt32},
      {"uint", Type::kUint32},
      {"uint32", Type::kUint32},
      {"float", Type::kFloat},
      {"float32", Type::kFloat},
      {"double", Type::kDouble},
      {"float64", Type::kDouble},
  }};
  for (const auto& [known, type] : kTypes) {
    if (known == name) return type;
  }
  return std::nullopt;
}

std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

struct Property {
  std::string name;
  Type type = Type::kFloat;
  std::optional<Type> count_type;  ///< of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Format { kText, kLittleEndian, kBigEndian };

struct Header {
  Format format = Format::kText;
  std::vector<Element> elements;
  std::size_t size = 0;   ///< bytes up to the body
  std::size_t lines = 0;  ///< up to the body
};

Result<Property> parse_property(TextCursor& text, const Error& bad) {
  Property property;
  std::string_view type = text.word_in_line();
  if (type == "list") {
    property.count_type = type_named(text.word_in_line());
    if (!property.count_type) return bad;
    type = text.word_in_line();
  }
  const auto known = type_named(type);
  property.name = text.word_in_line();
  if (!known || property.name.empty()) return bad;
  property.type = *known;
  return property;
}

Result<Header> parse_header(std::string_view bytes, const std::string& path) {
  constexpr std::size_t kMostProperties = 256;
  TextCursor text(bytes, false);
  const auto bad = [&](std::string what) {
    return Error{ErrorKind::kBadContent, std::move(what), fmt::format("{}:{}", path, text.line()), "", ""};
  };
  Header header;
  if (text.word() != "ply") return bad("not a PLY file");
  bool has_format = false;
  for (;;) {
    const std::string_view keyword = text.word();
    if (keyword == "end_header") break;
    if (keyword == "format") {
      const std::string_view name = text.word_in_line();
      has_format = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
      header.format =
          name == "ascii" ? Format::kText : (name == "binary_big_endian" ? Format::kBigEndian : Format::kLittleEndian);
      if (!has_format) return bad(fmt::format("unknown format \"{}\"", name));
    } else if (keyword == "element") {
      const std::string name(text.word_in_line());
      const auto count = to_number<std::size_t>(text.word_in_line());
      if (!count) return bad("an element needs a name and a count");
      header.elements.push_back({name, *count, {}});
    } else if (keyword == "property") {
      if (header.elements.empty() || header.elements.back().properties.size() == kMostProperties)
        return bad("a property without an element");
      LUM_TRY(Property property, parse_property(text, bad("unknown type of property")));
      header.elements.back().properties.push_back(std::move(property));
    } else if (keyword != "comment" && keyword != "obj_info") {
      return bad(keyword.empty() ? "the header does not end" : fmt::format("unknown word \"{}\"", keyword));
    }
    text.skip_line();
  }
  if (!has_format) return bad("the format is missing");
  text.skip_line();
  header.size = std::min(text.offset() + 1, bytes.size());
  header.lines = text.line();
  return header;
}

/// The body as a sequence of numbers, whatever the format.
class Body {
 public:
  Body(std::string_view bytes, const Header& header)
      : format_(header.format), bytes_(bytes.substr(header.size)), text_(bytes_, false), lines_(header.lines) {}

  std::optional<double> number(Type type) {
    if (format_ == Format::kText) return to_number<double>(text_.word());
    const std::size_t size = size_of(type);
    if (size > bytes_.size()) return std::nullopt;
    std::array<char, 8> raw{};
    std::copy_n(bytes_.begin(), size, raw.begin());
    if (format_ == Format::kBigEndian) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
    bytes_.remove_prefix(size);
    switch (type) {
      case Type::kInt8:
        return load<std::int8_t>(raw);
      case Type::kUint8:
        return load<std::uint8_t>(raw);
      case Type::kInt16:
        return load<std::int16_t>(raw);
      case Type::kUint16:
        return load<std::uint16_t>(raw);
      case Type::kInt32:
        return load<std::int32_t>(raw);
      case Type::kUint32:
        return load<std::uint32_t>(raw);
      case Type::kFloat:
        return load<float>(raw);
      case Type::kDouble:
        return load<double>(raw);
    }
    return std::nullopt;
  }
  /// Whether so many numbers can still be there.
  [[nodiscard]] bool can_hold(std::size_t count, Type type) const {
    if (format_ == Format::kText) return count <= text_.remaining() / 2 + 1;  // a digit and a space
    return count <= bytes_.size() / size_of(type);
  }
  /// Where the next number stands, for messages.
  [[nodiscard]] std::string place(const std::string& path) const {
    return format_ == Format::kText ? fmt::format("{}:{}", path, lines_ + text_.line()) : path;
  }

 private:
  template <class T>
  static double load(const std::array<char, 8>& raw) {
    T value;
    std::memcpy(&value, raw.data(), sizeof(T));
    return static_cast<double>(value);
  }
  Format format_;
  std::string_view bytes_;
  TextCursor text_;
  std::size_t lines_;
};

/// Reads one element after another; what is not a vertex or a face is stepped over.
class PlyReader {
 public:
  PlyReader(std::string_view bytes, const Header& header, PolygonSoup& soup) : body_(bytes, header), soup_(&soup) {}

  Result<void> read(const Element& element) {
    if (element.properties.empty()) return {};
    const Property& first = element.properties.front();
    if (!body_.can_hold(element.count, first.count_type.value_or(first.type))) {
      return Error{ErrorKind::kBadContent,
                   fmt::format("{} of \"{}\" do not fit into the file", element.count, element.name),
                   body_.place(soup_->path()), element.name, "the file is cut off"};
    }
    if (element.name == "vertex") return read_vertices(element);
    const bool faces = element.name == "face";
    for (std::size_t i = 0; i < element.count; ++i) {
      corners_.clear();
      for (const Property& property : element.properties) {
        const bool wanted =
            faces && property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
        LUM_TRY_VOID(read_property(property, element, i, [&](double value) {
          if (wanted) corners_.push_back(value >= 0.0 && value < 4294967296.0 ? static_cast<std::int64_t>(value) : -1);
        }));
      }
      if (faces) soup_->add_polygon(corners_, body_.place(soup_->path()));
    }
    return {};
  }

 private:
  Error cut_off(const Element& element, std::size_t item, const Property& property) const {
    return {ErrorKind::kBadContent, fmt::format("{} {} has no sound \"{}\"", element.name, item, property.name),
            body_.place(soup_->path()), element.name, "the file is cut off or damaged"};
  }

  template <class Sink>
  Result<void> read_property(const Property& property, const Element& element, std::size_t item, Sink sink) {
    std::size_t count = 1;
    if (property.count_type) {
      const auto number = body_.number(*property.count_type);
      if (!number || !(*number >= 0.0 && *number < 4294967296.0)) return cut_off(element, item, property);
      count = static_cast<std::size_t>(*number);
      if (!body_.can_hold(count, property.type)) return cut_off(element, item, property);
    }
    for (std::size_t k = 0; k < count; ++k) {
      const auto number = body_.number(property.type);
      if (!number) return cut_off(element, item, property);
      sink(*number);
    }
    return {};
  }

  Result<void> read_vertices(const Element& element) {
    constexpr std::array<std::string_view, 6> kNames{"x", "y", "z", "nx", "ny", "nz"};
    std::vector<std::size_t> role(element.properties.size(), kNames.size());
    std::size_t found = 0;
    for (std::size_t p = 0; p < role.size(); ++p) {
      const auto name = std::find(kNames.begin(), kNames.end(), element.properties[p].name);
      if (name == kNames.end() || element.properties[p].count_type) continue;
      role[p] = static_cast<std::size_t>(name - kNames.begin());
      found |= std::size_t{1} << role[p];
    }
    constexpr std::size_t kPosition = 0b111, kNormal = 0b111000;
    if ((found & kPosition) != kPosition) {
      return Error{ErrorKind::kBadContent, "a vertex needs x, y and z", soup_->path(), element.name, ""};
    }
    soup_->reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      std::array<float, 7> values{};  // the last takes what has no role
      for (std::size_t p = 0; p < role.size(); ++p) {
        LUM_TRY_VOID(read_property(element.properties[p], element, i,
                                   [&](double value) { values[role[p]] = static_cast<float>(value); }));
      }
      soup_->add_vertex({values[0], values[1], values[2]});
      if ((found & kNormal) == kNormal) soup_->add_normal({values[3], values[4], values[5]});
    }
    return {};
  }

  Body body_;
  PolygonSoup* soup_;
  std::vector<std::int64_t> corners_;
};

}  // namespace

Result<void> read_ply(std::string_view bytes, PolygonSoup& soup) {
  LUM_TRY(const Header header, parse_header(bytes, soup.path()));
  PlyReader reader(bytes, header, soup);
  for (const Element& element : header.elements) LUM_TRY_VOID(reader.read(element));
  return {};
}

}  // namespace luminist
