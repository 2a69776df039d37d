#pragma once
// paint/located_json.h -- JSON whose every value knows where it stands, for files that people write.
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

struct JsonNode {
  enum class Kind { kNull, kBool, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  bool boolean = false;
  double number = 0.0;
  std::string text;
  std::vector<JsonNode> items;  ///< of an array; of an object, in the file's order
  std::string key;              ///< of an object's item
  std::size_t key_at = 0;       ///< byte offset of the key's quote
  std::size_t at = 0;           ///< byte offset of the value's first character

  [[nodiscard]] const JsonNode* find(std::string_view name) const;  ///< the item with that key, or null
};

/// errors kBadContent at path:line:column: not JSON, a key twice in one object, nesting deeper than 32.
Result<JsonNode> parse_located_json(const std::string& text, const std::string& path);

/// "path:line:column" of a byte offset; columns count characters.
std::string located(const std::string& text, const std::string& path, std::size_t offset);

}  // namespace luminist
