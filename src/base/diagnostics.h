#pragma once
// base/diagnostics.h -- what a reader noticed and went on: counted, kept, shown by whoever called it.
#include <string>
#include <utility>
#include <vector>

namespace luminist {

/// Collects warnings; passed by reference to what may have something to say.
class Diagnostics {
 public:
  void warn(std::string where, std::string what) { warnings_.push_back({std::move(where), std::move(what)}); }
  struct Warning {
    std::string where;  ///< path, or path:line
    std::string what;   ///< one sentence without a full stop
  };
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  std::vector<Warning> warnings_;
};

}  // namespace luminist
