// tests/bench/main.cpp -- luminist-bench: measures the solver on real scenes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "bench/coherence.h"
#include "bench/figure6.h"
#include "bench/gi.h"
#include "bench/latency.h"
#include "bench/prep.h"
#include "bench/recover.h"
#include "bench/removal.h"
#include "bench/scaling.h"
#include "bench/shadow.h"
#include "bench/styles.h"
#include "bench/table1.h"

namespace luminist {
namespace {

using Run = std::function<Result<void>(Device&)>;

/// The words that every benchmark has.
void add_suite(CLI::App& bench, SuiteOptions& options) {
  bench.add_flag("--json", options.json, "one JSON object a line");
  bench.add_flag("--verbose", options.verbose, "a line a run on stderr");
  bench.add_option("--out", options.out, "folder of finished runs and plots; runs found there are not run again")
      ->capture_default_str();
  bench.add_flag("--fresh", options.fresh, "forget finished runs, as after a change of the solver");
  bench.add_option("--max-evals", options.caps.max_evals, "cap of the methods that compare whole pictures")
      ->capture_default_str();
  bench.add_option("--max-re", options.caps.max_equivalents, "cap of the fast solver, in render equivalents")
      ->capture_default_str();
}

/// The words by which a developer runs a part.
void add_filters(CLI::App& bench, SuiteOptions& options) {
  bench.add_option("--scenes", options.scenes, "only these")->delimiter(',');
  bench.add_option("--rows", options.tasks, "only these tasks")->delimiter(',');
  bench.add_option("--methods", options.methods, "only these of fast, simplex, nlopt_nelder_mead, nlopt_bobyqa")
      ->delimiter(',');
  bench.add_option("--seeds", options.seeds, "at most so many a method");
  bench.add_option("--size", options.size, "all methods at this size, as 256x256");
}

void add_latency(CLI::App& app, Run& run) {
  CLI::App* bench = app.add_subcommand("latency", "strokes are painted in real time: how soon their picture is there");
  auto options = std::make_shared<LatencyOptions>();
  auto size = std::make_shared<std::string>("1280x720");
  bench->add_flag("--json", options->json, "one JSON object");
  bench->add_option("--scene", options->scene, "a scene file")->capture_default_str();
  bench->add_option("--strokes", options->strokes, "a stroke file")->capture_default_str();
  bench->add_option("--size", *size, "of the picture")->capture_default_str();
  bench->callback([options, size, &run] {
    run = [options, size](Device&) -> Result<void> {
      LUM_TRY(const PictureSize wanted, parse_size(*size));
      options->width = wanted.width;
      options->height = wanted.height;
      return run_latency(*options);
    };
  });
}

void add_recover(CLI::App& app, Run& run) {
  CLI::App* bench = app.add_subcommand("recover", "a hidden 18-DOF light is asked for by its picture and found again");
  auto options = std::make_shared<RecoverOptions>();
  auto size = std::make_shared<std::string>(options->size.text());
  auto simplex_size = std::make_shared<std::string>(options->simplex_size.text());
  add_suite(*bench, options->suite);
  bench->add_flag("--no-simplex", options->no_simplex, "only the fast solver");
  bench->add_option("--scene", options->scene, "a folder of meshes/, or a scene file (which gets a floor and a wall)");
  bench->add_option("--meshes", options->meshes, "a folder: every mesh in it");
  bench->add_option("--size", *size, "of the fast solver's picture")->capture_default_str();
  bench->add_option("--seeds", options->seeds, "hidden lights")->capture_default_str();
  bench->add_option("--simplex-size", *simplex_size, "of the simplex's picture: smaller, because it takes long")
      ->capture_default_str();
  bench->add_option("--simplex-seeds", options->simplex_seeds, "at most this many for the simplex")
      ->capture_default_str();
  bench->add_option("--simplex-evals", options->suite.caps.max_evals, "the simplex's cap")->capture_default_str();
  bench->callback([options, size, simplex_size, &run] {
    run = [options, size, simplex_size](Device& device) -> Result<void> {
      LUM_TRY(options->size, parse_size(*size));
      LUM_TRY(options->simplex_size, parse_size(*simplex_size));
      return run_recover(device, *options);
    };
  });
}

void add_table1(CLI::App& app, Run& run) {
  CLI::App* bench = app.add_subcommand("table1", "lights of a rig are moved away and found again (paper, Table I)");
  auto options = std::make_shared<Table1Options>();
  add_suite(*bench, options->suite);
  add_filters(*bench, options->suite);
  bench
      ->add_option("--perturb", options->perturb,
                   "full: by 10-50 % of every useful range; small: a quarter of that; manifest: of the whole range")
      ->capture_default_str();
  bench->callback([options, &run] { run = [options](Device& device) { return run_table1(device, *options); }; });
}

/// A benchmark without words of its own. `evals` is its own cap.
using RunSuite = Result<void> (*)(Device&, const SuiteOptions&);
void add_plain(CLI::App& app, Run& run, const char* name, const char* doc, RunSuite run_suite, int evals) {
  CLI::App* bench = app.add_subcommand(name, doc);
  auto options = std::make_shared<SuiteOptions>();
  options->caps.max_evals = evals;
  add_suite(*bench, *options);
  add_filters(*bench, *options);
  bench->callback([options, run_suite, &run] {
    run = [options, run_suite](Device& device) { return run_suite(device, *options); };
  });
}

void add_painted(CLI::App& app, Run& run) {
  constexpr int kEvals = 1000;  // nobody knows the goal: baselines always run that far
  add_plain(app, run, "figure6", "a new light from crude paint, 7 DOFs, and refined, 12 (paper, Figures 2 and 6)",
            run_figure6, kEvals);
  add_plain(app, run, "shadow", "a light moved by erasing its shadow and painting it elsewhere, 3 and 7 DOFs",
            run_shadow, kEvals);
  add_plain(app, run, "removal", "the strongest of seven lights removed, the others make up for it, 36 and 48 DOFs",
            run_removal, kEvals);
  add_plain(app, run, "styles",
            "one or three lights and the style's colours from paint, in every style but the cinematic one", run_styles,
            kEvals);
}

void add_scaling(CLI::App& app, Run& run) {
  add_plain(app, run, "scaling", "work and time against degrees of freedom, lights, triangles and pixels", run_scaling,
            0);
}

void add_coherence(CLI::App& app, Run& run) {
  CLI::App* bench = app.add_subcommand("coherence", "whether ink holds still while the creature moves, in some styles");
  auto options = std::make_shared<CoherenceOptions>();
  bench->add_flag("--json", options->json, "one JSON object a line");
  bench->add_option("--styles", options->styles, "styles or stacks of styles")->delimiter(',')->capture_default_str();
  bench->add_option("--first", options->first, "first frame")->capture_default_str();
  bench->add_option("--count", options->count, "pairs of frames")->capture_default_str();
  bench->callback(
      [options, &run] { run = [options](Device& device) -> Result<void> { return run_coherence(device, *options); }; });
}

void add_gi(CLI::App& app, Run& run) {
  CLI::App* bench =
      app.add_subcommand("gi", "a ceiling light found from paint under global illumination (paper, Figure 10)");
  auto options = std::make_shared<GiOptions>();
  auto size = std::make_shared<std::string>(options->size.text());
  bench->add_flag("--json", options->json, "one JSON object a line");
  bench->add_option("--size", *size, "of the picture")->capture_default_str();
  bench->add_option("--seeds", options->seeds, "starts of the light, and paths")->capture_default_str();
  bench->add_option("--max-evals", options->max_evals, "pictures that a simplex compares at most")
      ->capture_default_str();
  bench->add_option("--samples", options->samples, "paths a pixel of the simplexes' pictures")->capture_default_str();
  bench->add_option("--reference", options->reference, "paths a pixel of the picture that judges")
      ->capture_default_str();
  bench->add_option("--methods", options->methods, "only these of full, multiresolution, kept, searched")
      ->delimiter(',');
  bench->callback([options, size, &run] {
    run = [options, size](Device& device) -> Result<void> {
      LUM_TRY(options->size, parse_size(*size));
      return run_gi(device, *options);
    };
  });
}

/// Needs no device. returns whether it was asked for, once the words are parsed.
std::function<bool()> add_prep(CLI::App& app, PrepOptions& options) {
  CLI::App* bench = app.add_subcommand("prep", "meshes are repaired and unwrapped: charts, distortion, time");
  bench->add_flag("--json", options.json, "one JSON object a line");
  bench->add_option("--meshes", options.meshes, "a folder, searched with those below; without it, generated meshes");
  return [bench] { return bench->parsed(); };
}

int fail(const Error& error) {
  std::fprintf(stderr, "luminist-bench: %s\n", error.message().c_str());
  return static_cast<int>(error.kind);
}

}  // namespace
}  // namespace luminist

int main(int argc, char** argv) {
  CLI::App app("Measures the solver: success, work in full-picture render equivalents, time.", "luminist-bench");
  app.require_subcommand(1);
  luminist::Run run;
  luminist::add_table1(app, run);
  luminist::add_painted(app, run);
  luminist::add_scaling(app, run);
  luminist::add_recover(app, run);
  luminist::add_coherence(app, run);
  luminist::add_latency(app, run);
  luminist::add_gi(app, run);
  luminist::PrepOptions prep;
  const auto wants_prep = luminist::add_prep(app, prep);
  CLI11_PARSE(app, argc, argv);
  if (wants_prep()) {
    const auto done = luminist::run_prep(prep);
    return done ? 0 : luminist::fail(done.error());
  }
  auto device = luminist::Device::create_headless();
  if (!device) return luminist::fail(device.error());
  const auto done = run(*device);
  return done ? 0 : luminist::fail(done.error());
}
