#pragma once
// cli/verb.h -- what the verbs of the command line have in common.
#include <functional>

#include "base/files.h"
#include "cli/console.h"
#include "cli/stop_signals.h"

namespace CLI {
class App;
}

namespace luminist {

struct VerbContext {
  Console& console;
  StopSignals& signals;
  AssetRoots roots;
};

/// Does the work after the words were understood. returns the exit status.
using Verb = std::function<Result<int>(VerbContext&)>;

/// Each declares a verb's words and returns what runs it. The returned object owns what the words are read into.
Verb declare_render(CLI::App& app);
Verb declare_paint(CLI::App& app);
Verb declare_carry(CLI::App& app);
Verb declare_solve(CLI::App& app);
Verb declare_alternatives(CLI::App& app);
Verb declare_remove(CLI::App& app);
Verb declare_diet(CLI::App& app);
Verb declare_replay(CLI::App& app);
Verb declare_golden(CLI::App& app);
Verb declare_prep(CLI::App& app);
Verb declare_farm(CLI::App& app);
Verb declare_doc(CLI::App& app);
Verb declare_info(CLI::App& app);

}  // namespace luminist
