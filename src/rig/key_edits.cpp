// How keys are set, moved and taken away (rig/keyframes.h).
#include <algorithm>
#include <array>
#include <iterator>

#include "base/check.h"
#include "rig/keyframes.h"
#include "rig/light_rig.h"

namespace luminist {
namespace {

using Values = std::array<double, 3>;

/// The numbers that a key of a track holds, as they are now.
Values stored(const ParamBlock& block, int param, int component) {
  if (component >= 0) return {block.get(param, component), 0.0, 0.0};
  Values value{};
  for (int c = 0; c < block.schema()[param].components(); ++c) {
    value[static_cast<std::size_t>(c)] = block.get(param, c);
  }
  return value;
}

void put_key(KeyTrack& track, const Key& key) {
  const auto at = std::lower_bound(track.keys.begin(), track.keys.end(), key.frame,
                                   [](const Key& each, double frame) { return each.frame < frame; });
  if (at != track.keys.end() && at->frame == key.frame) {
    *at = key;
  } else {
    track.keys.insert(at, key);
  }
}

/// Of the last key up to a frame, or else of the first.
KeyInterpolation interpolation_at(const KeyTrack& track, double frame) {
  KeyInterpolation interpolation = track.keys.front().interpolation;
  for (const Key& key : track.keys) {
    if (key.frame <= frame) interpolation = key.interpolation;
  }
  return interpolation;
}

const ParamSpec& spec_of(LightRig& rig, const KeyPlace& place) {
  const ParamBlock* block = keyed_block(rig, place.light);
  LUM_CHECK(block != nullptr && place.param >= 0 && place.param < block->schema().size(),
            "a key is of a parameter that is there");
  const ParamSpec& spec = block->schema()[place.param];
  LUM_CHECK(place.component < 0 || (keys_by_component(spec) && place.component < spec.components()),
            "a key is of a number that can have one");
  return spec;
}

/// A track of all of a parameter becomes one for each of its numbers.
void split(LightRig& rig, const std::string& light, const ParamSpec& spec) {
  const auto whole = std::find_if(rig.keys.begin(), rig.keys.end(), [&](const KeyTrack& track) {
    return track.light == light && track.param == spec.name && track.component < 0;
  });
  if (whole == rig.keys.end()) return;
  const KeyTrack before = *whole;
  std::vector<KeyTrack> parts;
  for (int c = 0; c < spec.components(); ++c) {
    KeyTrack part{light, spec.name, before.keys, c};
    for (Key& key : part.keys) key.value = {key.value[static_cast<std::size_t>(c)], 0.0, 0.0};
    parts.push_back(std::move(part));
  }
  const auto at = rig.keys.erase(whole);
  rig.keys.insert(at, std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
}

/// The tracks that a place means, valid until the rig's keys change.
std::vector<KeyTrack*> tracks_at(LightRig& rig, const KeyPlace& place) {
  const ParamSpec& spec = spec_of(rig, place);
  if (place.component >= 0) split(rig, place.light, spec);
  std::vector<KeyTrack*> tracks;
  for (KeyTrack& track : rig.keys) {
    if (track.light != place.light || track.param != spec.name) continue;
    if (place.component < 0 || track.component == place.component) tracks.push_back(&track);
  }
  return tracks;
}

Key* key_at(KeyTrack& track, double frame) {
  const auto key =
      std::find_if(track.keys.begin(), track.keys.end(), [&](const Key& each) { return each.frame == frame; });
  return key != track.keys.end() ? &*key : nullptr;
}

}  // namespace

void set_key(LightRig& rig, const KeyPlace& place, double frame, KeyInterpolation interpolation) {
  const ParamSpec& spec = spec_of(rig, place);
  bool in_parts = place.component >= 0;
  for (const KeyTrack* track : tracks_at(rig, place)) in_parts |= track->component >= 0;
  const int first = in_parts ? std::max(place.component, 0) : -1;
  const int last = in_parts && place.component < 0 ? spec.components() - 1 : first;
  for (int c = first; c <= last; ++c) {
    auto track = std::find_if(rig.keys.begin(), rig.keys.end(), [&](const KeyTrack& each) {
      return each.light == place.light && each.param == spec.name && each.component == c;
    });
    if (track == rig.keys.end()) track = rig.keys.insert(rig.keys.end(), {place.light, spec.name, {}, c});
    put_key(*track, {frame, interpolation, stored(*keyed_block(rig, place.light), place.param, c)});
  }
}

bool remove_key(LightRig& rig, const KeyPlace& place, double frame) {
  std::size_t removed = 0;
  for (KeyTrack* track : tracks_at(rig, place)) {
    removed += std::erase_if(track->keys, [&](const Key& key) { return key.frame == frame; });
  }
  std::erase_if(rig.keys, [](const KeyTrack& track) { return track.keys.empty(); });
  return removed > 0;
}

bool move_key(LightRig& rig, const KeyPlace& place, double from, double to) {
  bool moved = false;
  for (KeyTrack* track : tracks_at(rig, place)) {
    const Key* found = key_at(*track, from);
    if (found == nullptr) continue;
    Key key = *found;
    std::erase_if(track->keys, [&](const Key& each) { return each.frame == from; });
    key.frame = to;
    put_key(*track, key);
    moved = true;
  }
  return moved;
}

bool set_interpolation(LightRig& rig, const KeyPlace& place, double frame, KeyInterpolation interpolation) {
  bool found = false;
  for (KeyTrack* track : tracks_at(rig, place)) {
    Key* key = key_at(*track, frame);
    if (key == nullptr) continue;
    key->interpolation = interpolation;
    found = true;
  }
  return found;
}

int follow_with_keys(LightRig& rig, double frame) {
  if (rig.keys.empty()) return 0;
  LightRig posed = rig;  // with its constraints: what they move is no change
  pose(posed, frame);
  int count = 0;
  for (KeyTrack& track : rig.keys) {
    const ParamBlock* block = keyed_block(rig, track.light);
    const auto param = block != nullptr ? block->schema().find(track.param) : std::nullopt;
    if (!param) continue;
    const Values now = stored(*block, *param, track.component);
    if (stored(*keyed_block(posed, track.light), *param, track.component) == now) continue;
    put_key(track, {frame, interpolation_at(track, frame), now});
    ++count;
  }
  return count;
}

}  // namespace luminist
