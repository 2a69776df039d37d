#include "cli/solve_words.h"

#include <fmt/format.h>

#include "studio/results.h"

namespace luminist {
namespace {

/// " name=value" of every parameter that was free, to be read: the rig file has all digits.
std::string free_values(const ParamBlock& block) {
  std::string text;
  for (int param = 0; param < block.schema().size(); ++param) {
    const ParamSpec& spec = block.schema()[param];
    bool free = false;
    for (int dof = 0; dof < spec.dofs(); ++dof) free = free || !block.locked(spec.first_dof + dof);
    if (!free) continue;
    text += fmt::format(" {}=", spec.name);
    for (int c = 0; c < spec.components(); ++c) text += fmt::format("{}{:.4g}", c == 0 ? "" : ",", block.get(param, c));
  }
  return text;
}

}  // namespace

std::string report_line(const SolveReport& report) {
  const std::string ranges =
      report.outside() ? fmt::format("; numbers outside their ranges count {:.4g} besides", report.penalty) : "";
  return fmt::format("{}: error {:.5f}, was {:.5f}{}; {} pictures compared, {:.3g} render equivalents, {:.1f} s; {}",
                     report.solver, report.error(), report.error_start(), ranges, report.evals,
                     report.render_equivalents, report.seconds, to_string(report.termination));
}

void print_free_values(Console& console, const ParamState& state, bool without_style) {
  const std::vector<const ParamBlock*> blocks = state.blocks();
  const std::vector<std::string> paths = state.block_paths();
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    if (without_style && blocks[b] == &state.style) continue;
    const std::string found = free_values(*blocks[b]);
    if (!found.empty()) console.result(paths[b] + ":" + found);
  }
}

void print_solved(Console& console, const Solved& solved, const ParamState& state) {
  if (console.json()) return;
  console.result(report_line(solved.report));
  print_free_values(console, state, false);
  if (solved.verdict) console.result(*solved.verdict);
}

Result<void> write_proposal(Session& session, const std::string& folder, Result<void> solved) {
  if (!solved && (!session.has_proposal() || session.solved()->report.evals == 0)) return solved;
  auto results = collect_results(session);
  auto written = results ? write_results(*results, folder) : Result<void>(std::move(results).error());
  if (solved) return written;
  Error error = std::move(solved).error();
  if (written) error.hint += fmt::format("{}the best so far is in {}", error.hint.empty() ? "" : "; ", folder);
  return error;
}

Result<void> solve_into(Session& session, const SolveWords& words, const std::string& folder, VerbContext& context) {
  const Deadline deadline(context.signals, words.seconds);
  auto solved = session.solve(words.options, [&](const SolveReport& report) {
    context.console.progress(report);
    return deadline.go_on();
  });
  if (solved && context.signals.stopped() == 0) {
    context.console.progress("judging the strokes");
    // Lights that were found are written whether or not there is time for a verdict.
    const auto judged = session.judge([&] { return context.signals.stopped() == 0; });
    if (!judged && judged.error().kind != ErrorKind::kCancelled) return judged.error();
  }
  return write_proposal(session, folder, std::move(solved));
}

}  // namespace luminist
