#include "cli/stop_signals.h"

#include <pthread.h>
#include <unistd.h>

#include <csignal>

namespace luminist {
namespace {

sigset_t stop_set() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

StopSignals::StopSignals() {
  const sigset_t set = stop_set();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  thread_ = std::thread([this] { wait(); });
}

StopSignals::~StopSignals() {
  done_ = true;
  pthread_kill(thread_.native_handle(), SIGTERM);  // wakes it
  thread_.join();
}

void StopSignals::wait() {
  const sigset_t set = stop_set();
  for (int signal = 0; ::sigwait(&set, &signal) == 0 && !done_;) {
    if (!graceful_ || stopped_ != 0) ::_exit(128 + signal);
    stopped_ = signal;
  }
}

}  // namespace luminist
