#pragma once
// scene/face_faults.h -- faces that a reader drops: counted, the first one named, reported in one warning each.
#include <cstddef>
#include <string>

#include "base/diagnostics.h"

namespace luminist {

/// Faults of one kind.
class FaceFaults {
 public:
  explicit FaceFaults(std::string what) : what_(std::move(what)) {}
  /// where: path or path:line; detail names the first culprit ("vertex 12").
  void add(const std::string& where, const std::string& detail) {
    if (count_++ == 0) where_ = where, detail_ = detail;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  /// "12 faces dropped: a corner is not finite (first: vertex 12)".
  void report(Diagnostics& diagnostics) const;

 private:
  std::string what_;
  std::string where_;
  std::string detail_;
  std::size_t count_ = 0;
};

}  // namespace luminist
