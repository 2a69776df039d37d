#pragma once
// tests/monkey/gestures.h -- how much a monkey does, and which gestures.
#include <cstdlib>

namespace luminist {

inline int asked_for(const char* variable, int otherwise) {
  const char* wanted = std::getenv(variable);
  return wanted != nullptr ? std::atoi(wanted) : otherwise;
}

/// LUMINIST_MONKEY=100000 for as many gestures of each monkey, LUMINIST_MONKEY_SEED=2 for others.
inline int gestures_asked_for(int otherwise) {
  return asked_for("LUMINIST_MONKEY", otherwise);
}
inline unsigned seed_asked_for() {
  return static_cast<unsigned>(asked_for("LUMINIST_MONKEY_SEED", 1));
}

}  // namespace luminist
