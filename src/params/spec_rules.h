#pragma once
// params/spec_rules.h -- what a valid parameter is; shared by manifests and by schemas made in C++.
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "params/param_schema.h"

namespace luminist {

/// A broken rule: which parameter, which of its manifest keys, what is wrong.
struct SpecFault {
  std::size_t index = 0;  ///< of the parameter in its list
  std::string param;
  std::string key;
  std::string what;
  std::string hint;
};

/// The first rule that one parameter breaks.
std::optional<SpecFault> find_fault(const ParamSpec& spec);

/// The first fault of the list: of one parameter, a name used twice, more than 1,000 of them.
std::optional<SpecFault> find_list_fault(const std::vector<ParamSpec>& specs);

}  // namespace luminist
