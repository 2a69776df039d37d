#pragma once
// raster/link_table.h -- rig/light_links.h as bits that the relight program reads. No GL.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rig/light_rig.h"

namespace luminist {

/// A light that is not linked has no bits: its entry says it all, and the shader tests a number.
class LinkTable {
 public:
  static constexpr std::uint32_t kEverything = 0xFFFFFFFFU;  ///< LUM_NONE: lights every object, is the key of none
  static constexpr std::uint32_t kKeyOfAll = 0xFFFFFFFEU;    ///< LUM_KEY_OF_ALL: lights every object, is their key

  /// object_names[id], entry 0 for what is no object, as SurfaceBuffer has them.
  explicit LinkTable(std::vector<std::string> object_names) : object_names_(std::move(object_names)) {}

  /// Forgets the bits of all rigs.
  void clear();

  /// For every light of the rig what lum_lights.w holds: one of the above, or the first of 2 * row_words() words, a bit
  /// for each object that it lights, then a bit for each object whose key it is. Valid until the next call.
  /// cost one pass over the lights; for a rig that is linked otherwise than the last one O(lights * objects).
  std::span<const std::uint32_t> entries(const LightRig& rig);

  [[nodiscard]] std::size_t row_words() const { return (object_names_.size() + 31) / 32; }
  [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }

 private:
  void add_rows(const LightRig& rig);

  std::vector<std::string> object_names_;
  std::vector<std::uint32_t> words_;
  std::vector<std::uint32_t> entries_;  ///< of the last rig
  std::string signature_;               ///< of the rig whose rows were added last; empty: none
};

}  // namespace luminist
