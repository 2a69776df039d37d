#pragma once
// cli/solve_styles.h -- `solve --style a,b,c`: the same paint in several styles, each for itself or with one rig.
#include "cli/solve_words.h"

namespace luminist {

/// Whether --style names more than one.
bool several_styles(const SolveWords& words);

/// Without --together each style is solved from the same start into OUT/<style>/. With it, all styles share one rig,
/// OUT/rig.toml, and OUT/<style>/ has each one's picture and own parameters. Words about "style/x" go to the styles
/// that have x. returns the exit status: 1 if --until was not reached, by any. errors as for one style.
Result<int> solve_styles(const SolveWords& words, VerbContext& context);

}  // namespace luminist
