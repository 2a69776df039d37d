#pragma once
// explore/alternatives.h -- paint is ambiguous: good solutions that light the picture in different ways.
#include <cstdint>
#include <vector>

#include "explore/watched_solve.h"

namespace luminist {

struct AlternativesOptions {
  int count = 4;            ///< wanted, the best one included
  double factor = 1.25;     ///< good: epsilon at most so many times the best one...
  double allowance = 0.01;  ///< ...or this share of a black picture's epsilon above it, if that is more
  double distinct = 0.15;   ///< least look_distance() between any two
  int tries = 0;            ///< starts besides the given one; 0: eight for each that is wanted
  std::uint64_t seed = 1;
};

struct Alternative {
  ParamState state;
  SolveReport report;
  double distance = 0.0;  ///< to the nearest one before it in the list; 0 for the first
};

struct Alternatives {
  std::vector<Alternative> list;  ///< the best first, then always the one that is most different from those before it
  double limit = 0.0;             ///< epsilon of what counts as good
  int tried = 0;                  ///< other starts
  int good = 0;                   ///< solutions within the limit, the first one included
  bool stopped = false;           ///< by the watch: what was found until then
};

/// Solves from the given start, then from lights elsewhere (OtherStarts): first with the moved lights held in place,
/// and where that is not good enough freed. Of what is good, greedily the most different are taken; there may be fewer
/// than wanted. Deterministic by seed. errors those of SolveSession.
/// cost one whole solve, and up to two without restarts for each try.
Result<Alternatives> find_alternatives(Renderer& renderer, const ParamState& start, const Target& target,
                                       const AlternativesOptions& options, const ExploreWatch& watch);

}  // namespace luminist
