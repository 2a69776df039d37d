#pragma once
// cli/solve_shared.h -- one rig for several pictures at once: in several styles, from several cameras, at several
// frames.
#include <memory>
#include <string>
#include <vector>

#include "cli/solve_words.h"

namespace luminist {

/// One of the pictures. The rig, its locks and constraints are those of the first.
struct SharedView {
  std::string name;  ///< of its folder and in what is printed
  std::unique_ptr<Session> session;
  double weight = 1.0;  ///< of its error
};

/// Solves, judges each picture's strokes unless a signal came, writes OUT/rig.toml and OUT/NAME/ and prints.
/// noun: what --json calls the pictures. returns the exit status: 1 if --until was not reached. errors SharedSolve's.
Result<int> solve_shared(const std::vector<SharedView>& views, const std::string& noun, const SolveWords& words,
                         VerbContext& context);

/// `solve --view camera=C,frame=F,paint=P,weight=W --view ...`: one rig for several cameras and frames of a scene, with
/// paint on each. What a view does not say is as in the other words. errors kUsage for words of another form.
Result<int> solve_views(const SolveWords& words, VerbContext& context);

}  // namespace luminist
