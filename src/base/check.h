#pragma once
// base/check.h -- what must hold if our own code is right. A failure is our bug: it prints the place and aborts.

namespace luminist {

[[noreturn]] void check_failed(const char* condition, const char* why, const char* file, int line);

}  // namespace luminist

/// LUM_CHECK(index < size, "the caller clips"); the second argument says why it holds.
#define LUM_CHECK(condition, why) \
  (static_cast<bool>(condition) ? void(0) : ::luminist::check_failed(#condition, why, __FILE__, __LINE__))
