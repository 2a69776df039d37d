#include "app/ink_clock.h"

#include <cstdlib>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "studio/live_replay.h"

namespace luminist {
namespace {

constexpr std::size_t kMost = 100'000;  // points

}  // namespace

InkClock::InkClock() {
  if (const char* path = std::getenv("LUMINIST_INK_TIMES")) path_ = path;
}

void InkClock::note(std::span<const HandEvent> events, bool drawing, double now) {
  if (path_.empty()) return;
  const bool ended = std::exchange(drawing_, drawing) && !drawing;
  for (const HandEvent& event : events) {
    const bool counts = drawing && event.kind == HandEvent::Kind::kMove && seconds_.size() < kMost;
    if (counts) seconds_.push_back(now - event.time);
  }
  if (ended) write();
}

void InkClock::write() const {
  const Latency latency = latency_of(seconds_);
  const nlohmann::json line = {
      {"events", seconds_.size()}, {"median", latency.median}, {"p95", latency.p95}, {"max", latency.most}};
  static_cast<void>(write_file_atomic(path_, line.dump()));  // a measurement is not worth a message
}

}  // namespace luminist
