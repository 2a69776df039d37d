#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace luminist {

void check_failed(const char* condition, const char* why, const char* file, int line) {
  std::fprintf(stderr, "luminist: internal error at %s:%d: %s does not hold (%s)\n", file, line, condition, why);
  std::abort();
}

}  // namespace luminist
