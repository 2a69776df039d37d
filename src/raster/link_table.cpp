#include "raster/link_table.h"

#include <algorithm>

#include "rig/light_links.h"

namespace luminist {

void LinkTable::clear() {
  words_.clear();
  signature_.clear();
}

std::span<const std::uint32_t> LinkTable::entries(const LightRig& rig) {
  if (std::ranges::any_of(rig.lights, [](const Light& light) { return !light.objects.empty(); })) {
    std::string signature = link_signature(rig);
    if (signature != signature_) {
      add_rows(rig);
      signature_ = std::move(signature);
    }
    return entries_;
  }
  signature_.clear();
  entries_.assign(rig.lights.size(), kEverything);
  const int key = key_light(rig, "");
  if (key >= 0) entries_[static_cast<std::size_t>(key)] = kKeyOfAll;
  return entries_;
}

void LinkTable::add_rows(const LightRig& rig) {
  const std::size_t row = 2 * row_words();
  const std::size_t first = words_.size();
  words_.resize(first + row * rig.lights.size(), 0);
  entries_.clear();
  for (std::size_t i = 0; i < rig.lights.size(); ++i) {
    entries_.push_back(static_cast<std::uint32_t>(first + row * i));
  }
  for (std::size_t object = 1; object < object_names_.size(); ++object) {
    const std::uint32_t bit = 1U << (object % 32);
    const auto key = static_cast<std::size_t>(key_light(rig, object_names_[object]));
    for (std::size_t i = 0; i < rig.lights.size(); ++i) {
      std::uint32_t* words = &words_[first + row * i];
      if (lights_object(rig.lights[i], object_names_[object])) words[object / 32] |= bit;
      if (i == key) words[row_words() + object / 32] |= bit;
    }
  }
}

}  // namespace luminist
