#pragma once
// tests/support/held_memory.h -- what a part of the program keeps.
#include <malloc.h>

#include <cstddef>

namespace luminist {

/// Bytes that the process holds by malloc, a software driver's among them.
inline std::size_t held_bytes() {
  const struct mallinfo2 info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace luminist
