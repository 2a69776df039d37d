#pragma once
// project/document.h -- everything that a shot is, as a flat map from path to value.
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

/// One path that changes. Values are compact JSON text; "" means that the path is not there.
struct Edit {
  std::string path;
  std::string before;
  std::string after;
};

/// "lights/key/color" -> "[1.0,0.9,0.8]". Paths that this version does not know are kept like any other.
class Document {
 public:
  using Entries = std::map<std::string, std::string, std::less<>>;

  /// The value's JSON text, or "". Valid until the path is set again.
  [[nodiscard]] std::string_view get(std::string_view path) const;
  [[nodiscard]] bool has(std::string_view path) const { return entries_.contains(path); }
  /// value is compact JSON text; "" erases.
  void set(std::string_view path, std::string value);
  /// Erases every path that starts with the prefix.
  void erase_below(std::string_view prefix);
  [[nodiscard]] const Entries& entries() const { return entries_; }

  /// All or nothing. errors kBadContent naming the path whose present value is not the edit's `before`.
  Result<void> apply(std::span<const Edit> edits);

  /// Equal documents, equal hashes (content_hash of all entries in order).
  [[nodiscard]] std::string hash() const;

 private:
  Entries entries_;
};

/// What turns one document into the other, in path order. cost O(entries).
std::vector<Edit> difference(const Document& from, const Document& to);

/// The edits that undo these.
std::vector<Edit> reversed(std::span<const Edit> edits);

}  // namespace luminist
