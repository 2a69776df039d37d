#include "app/timeline.h"

#include <algorithm>
#include <cmath>

namespace luminist {

std::vector<KeyRow> key_rows(const LightRig& rig, const std::string& selected) {
  std::vector<KeyRow> rows;
  for (const KeyTrack& track : rig.keys) {
    const std::string name = track_name(rig, track);
    if (name.empty()) continue;
    if (!selected.empty()) {
      if (track.light != (selected == "ambient" ? "" : selected)) continue;
      rows.push_back({name, light_path(track.light) + "/" + name, track.keys});
      continue;
    }
    const std::string pattern = light_path(track.light);
    auto row = std::find_if(rows.begin(), rows.end(), [&](const KeyRow& each) { return each.pattern == pattern; });
    if (row == rows.end()) {
      row = rows.insert(rows.end(), {track.light.empty() ? "ambient" : track.light, pattern, {}});
    }
    for (const Key& key : track.keys) {
      const bool there =
          std::any_of(row->keys.begin(), row->keys.end(), [&](const Key& each) { return each.frame == key.frame; });
      if (!there) row->keys.push_back(key);
    }
  }
  return rows;
}

float TimeScale::x_of(double frame) const {
  const double range = std::max(last - first, 1);
  return left + static_cast<float>((frame - first) / range) * (right - left);
}

double TimeScale::frame_at(float x) const {
  const double share = (x - left) / std::max(right - left, 1.0F);
  return std::clamp(std::round(first + share * std::max(last - first, 1)), static_cast<double>(first),
                    static_cast<double>(last));
}

int TimeScale::step(float least_px) const {
  const double frames = least_px * std::max(last - first, 1) / std::max(right - left, 1.0F);
  for (int decade = 1;; decade *= 10) {
    for (const int factor : {1, 2, 5}) {
      if (factor * decade >= frames) return factor * decade;
    }
  }
}

}  // namespace luminist
