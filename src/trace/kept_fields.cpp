#include "trace/kept_fields.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace luminist {
namespace {

constexpr std::size_t kPathBytes = 560;  // of a kept path in a closed room
constexpr std::size_t kChunk = 32;       // pixels that one task gathers
constexpr std::size_t kSetsAtOnce = 12;  // buffers of sets beside that of the picture; a solve has six

std::string key_of(const PixelSet& set, const RigLight& light) {
  std::string key = picture_key(light);
  key.append(reinterpret_cast<const char*>(&set.id), sizeof(set.id));
  return key;
}

}  // namespace

KeptFields::KeptFields(const PathTracer& tracer, std::size_t memory_bytes)
    : tracer_(&tracer), memory_bytes_(memory_bytes) {}

void KeptFields::use(const PathOptions& options, int paths) {
  if (options == options_ && paths == paths_) return;
  options_ = options;
  paths_ = paths;
  whole_.reset();
  of_sets_.clear();
  bases_.clear();
  entries_.clear();
  index_.clear();
  held_values_ = 0;
}

int KeptFields::picture_paths() const {
  const std::size_t pixels = static_cast<std::size_t>(tracer_->width()) * static_cast<std::size_t>(tracer_->height());
  return static_cast<int>(std::clamp<std::size_t>(memory_bytes_ / (pixels * kPathBytes), 1, std::max(1, paths_)));
}

bool KeptFields::shares_whole(const PixelSet& set) const {
  return set.picture || picture_paths() == paths_;
}

const PathBuffer& KeptFields::buffer_of(const PixelSet& set) {
  if (shares_whole(set)) {
    if (!whole_) {
      std::vector<std::uint32_t> all(static_cast<std::size_t>(tracer_->width()) *
                                     static_cast<std::size_t>(tracer_->height()));
      std::iota(all.begin(), all.end(), 0U);
      whole_ = std::make_unique<PathBuffer>(*tracer_, all, picture_paths(), options_);
    }
    return *whole_;
  }
  if (of_sets_.size() >= kSetsAtOnce && !of_sets_.contains(set.id)) of_sets_.clear();
  std::unique_ptr<PathBuffer>& buffer = of_sets_[set.id];
  if (!buffer) buffer = std::make_unique<PathBuffer>(*tracer_, set.pixels, paths_, options_);
  return *buffer;
}

std::vector<AskedPixel> KeptFields::asked_of(const PixelSet& set) const {
  const bool whole = shares_whole(set);
  std::vector<AskedPixel> asked;
  for (std::size_t i = 0; i < set.pixels.size(); ++i) {
    asked.push_back({whole ? set.pixels[i] : static_cast<std::uint32_t>(i), set.paths[i]});
  }
  return asked;
}

void KeptFields::make(const PixelSet& set, std::span<const RigLight> lights, std::span<PixelField> fields) {
  if (lights.empty()) return;
  const PathBuffer& buffer = buffer_of(set);
  const std::vector<AskedPixel> asked = asked_of(set);
  const std::size_t chunks = (asked.size() + kChunk - 1) / kChunk;
  for (PixelField& field : fields) field.resize(asked.size());
  std::vector<std::size_t> rays(chunks * lights.size(), 0);
  tbb::parallel_for(std::size_t{0}, rays.size(), [&](std::size_t task) {
    const std::size_t light = task / chunks;
    const std::size_t first = task % chunks * kChunk;
    const std::size_t count = std::min(kChunk, asked.size() - first);
    rays[task] = buffer.gather(lights[light], std::span(asked).subspan(first, count),
                               std::span(fields[light]).subspan(first, count));
  });
  for (const std::size_t each : rays) queries_ += static_cast<double>(each);
  const double paths = std::accumulate(set.paths.begin(), set.paths.end(), 0.0);
  shades_ += static_cast<double>(lights.size()) * paths / buffer.paths();
}

void KeptFields::keep(std::string key, SharedField field) {
  held_values_ += field->size();
  entries_.push_front({key, std::move(field)});
  index_[std::move(key)] = entries_.begin();
  const std::size_t budget = memory_bytes_ / 4 / sizeof(Vec3);
  while (held_values_ > budget && entries_.size() > 1) {
    held_values_ -= entries_.back().field->size();
    index_.erase(entries_.back().key);
    entries_.pop_back();
  }
}

std::vector<SharedField> KeptFields::of_lights(const PixelSet& set, std::span<const RigLight> lights) {
  std::vector<std::string> keys;
  std::vector<SharedField> result(lights.size());
  std::vector<RigLight> missing;
  std::unordered_map<std::string, std::size_t> place;  // in missing
  for (std::size_t i = 0; i < lights.size(); ++i) {
    keys.push_back(key_of(set, lights[i]));
    if (const auto known = index_.find(keys[i]); known != index_.end()) {
      entries_.splice(entries_.begin(), entries_, known->second);
      result[i] = known->second->field;
    } else if (place.try_emplace(keys[i], missing.size()).second) {
      missing.push_back(lights[i]);
    }
  }
  std::vector<PixelField> fields(missing.size());
  make(set, missing, fields);
  std::vector<SharedField> made;
  for (PixelField& field : fields) made.push_back(std::make_shared<const PixelField>(std::move(field)));
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (!result[i]) result[i] = made[place.at(keys[i])];
  }
  for (const auto& [key, index] : place) keep(key, made[index]);
  return result;
}

std::shared_ptr<const KeptFields::Base> KeptFields::base(const PixelSet& set) {
  if (const auto known = bases_.find(set.id); known != bases_.end()) return known->second;
  if (bases_.size() >= kSetsAtOnce) bases_.clear();
  auto base = std::make_shared<Base>();
  base->emitted.resize(set.pixels.size());
  base->escaped.resize(set.pixels.size());
  const PathBuffer& buffer = buffer_of(set);
  buffer.base(asked_of(set), base->emitted, base->escaped);
  bases_[set.id] = base;
  return base;
}

}  // namespace luminist
