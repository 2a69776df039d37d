#include "trace/kept_fields.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace luminist {
namespace {

constexpr std::size_t kPathBytes = 560;  // of a kept path in a closed room
constexpr std::size_t kChunk = 32;       // pixels that one task gathers
constexpr std::size_t kSetsAtOnce = 16;  // whose emission is kept; a solve has eight

std::string key_of(const PixelSet& set, const RigLight& light) {
  std::string key = picture_key(light);
  key.append(reinterpret_cast<const char*>(&set.id), sizeof(set.id));
  return key;
}

}  // namespace

KeptFields::KeptFields(const PathTracer& tracer, std::size_t memory_bytes)
    : tracer_(&tracer), memory_bytes_(memory_bytes) {}

void KeptFields::use(const PathOptions& options) {
  if (options == options_) return;
  options_ = options;
  drop();
}

void KeptFields::drop() {
  paths_.reset();
  bases_.clear();
  entries_.clear();
  index_.clear();
  held_values_ = 0;
}

int KeptFields::picture_paths(int paths) const {
  const std::size_t pixels = static_cast<std::size_t>(tracer_->width()) * static_cast<std::size_t>(tracer_->height());
  return static_cast<int>(std::clamp<std::size_t>(memory_bytes_ / (pixels * kPathBytes), 1, std::max(1, paths)));
}

const PathBuffer& KeptFields::buffer_with(const PixelSet& set) {
  // Samples of one solve after another pile up; what is asked now is traced again.
  if (paths_ && paths_->held() > 2 * memory_bytes_ / kPathBytes) paths_.reset();
  if (!paths_) paths_.emplace(*tracer_, options_);
  paths_->want(set.pixels);
  return *paths_;
}

void KeptFields::make(const PixelSet& set, std::span<const RigLight> lights, std::span<PixelField> fields) {
  if (lights.empty()) return;
  const PathBuffer& buffer = buffer_with(set);
  const std::span<const AskedPixel> asked(set.pixels);
  const std::size_t chunks = (asked.size() + kChunk - 1) / kChunk;
  for (PixelField& field : fields) field.resize(asked.size());
  std::vector<std::size_t> rays(chunks * lights.size(), 0);
  tbb::parallel_for(std::size_t{0}, rays.size(), [&](std::size_t task) {
    const std::size_t light = task / chunks;
    const std::size_t first = task % chunks * kChunk;
    const std::size_t count = std::min(kChunk, asked.size() - first);
    rays[task] =
        buffer.gather(lights[light], asked.subspan(first, count), std::span(fields[light]).subspan(first, count));
  });
  for (const std::size_t each : rays) queries_ += static_cast<double>(each);
  double paths = 0.0;
  for (const AskedPixel& each : asked) paths += each.paths;
  shades_ += static_cast<double>(lights.size()) * paths;
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
  buffer_with(set).base(set.pixels, base->emitted, base->escaped);
  bases_[set.id] = base;
  return base;
}

}  // namespace luminist
