#include "app/ink_clock.h"

#include <cstdlib>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "studio/live_replay.h"

namespace luminist {
namespace {

constexpr std::size_t kMost = 100'000;  // of either

nlohmann::json to_json(const std::vector<double>& seconds) {
  const Latency latency = latency_of(seconds);
  return {{"count", seconds.size()}, {"median", latency.median}, {"p95", latency.p95}, {"max", latency.most}};
}

}  // namespace

InkClock::InkClock() {
  if (const char* path = std::getenv("LUMINIST_INK_TIMES")) path_ = path;
}

void InkClock::note(std::span<const HandEvent> events, bool drawing, double begin, double end) {
  if (path_.empty()) return;
  const bool ended = std::exchange(drawing_, drawing) && !drawing;
  for (const HandEvent& event : events) {
    const bool counts = drawing && event.kind == HandEvent::Kind::kMove && ink_.size() < kMost;
    if (counts) ink_.push_back(end - event.time);
  }
  if (drawing && frames_.size() < kMost) frames_.push_back(end - begin);
  if (ended) write();
}

void InkClock::write() const {
  const nlohmann::json line = {{"ink", to_json(ink_)}, {"frames", to_json(frames_)}};
  static_cast<void>(write_file_atomic(path_, line.dump()));  // a measurement is not worth a message
}

}  // namespace luminist
