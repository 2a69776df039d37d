#pragma once
// cli/stop_signals.h -- Ctrl-C and SIGTERM.
#include <atomic>
#include <thread>

namespace luminist {

/// Waits for SIGINT and SIGTERM on a thread of its own. By default either ends the process at once with 128 + its
/// number; while somebody holds a Grace, the first one only sets stopped(), so that results can be written.
/// Made before any other thread, so that all of them leave these signals to it.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  class Grace {
   public:
    explicit Grace(StopSignals& signals) : signals_(&signals) { signals_->graceful_ = true; }
    ~Grace() { signals_->graceful_ = false; }
    Grace(const Grace&) = delete;
    Grace& operator=(const Grace&) = delete;

   private:
    StopSignals* signals_;
  };

  /// The signal that asked to stop, or 0.
  [[nodiscard]] int stopped() const { return stopped_; }

 private:
  void wait();
  std::atomic<bool> graceful_{false};
  std::atomic<bool> done_{false};
  std::atomic<int> stopped_{0};
  std::thread thread_;
};

}  // namespace luminist
