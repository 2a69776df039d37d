// tests/bench/main.cpp -- luminist-bench: measures the solver on real scenes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "bench/recover.h"

namespace {

using luminist::BenchOptions;
using luminist::BenchReport;

/// "256x256". returns false if it is no size.
bool read_size(const std::string& text, int& width, int& height) {
  int end = 0;
  return std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &end) == 2 && end == static_cast<int>(text.size()) &&
         width > 0 && height > 0;
}

struct Words {
  BenchOptions options;
  std::string size = "256x256";
  std::string simplex_size = "128x128";
};

void add_recover(CLI::App& app, Words& words) {
  CLI::App* recover =
      app.add_subcommand("recover", "a hidden 18-DOF light is asked for by its picture and found again");
  BenchOptions& options = words.options;
  recover->add_flag("--json", options.json, "one JSON object a line");
  recover->add_flag("--verbose", options.verbose, "a line a run on stderr");
  recover->add_flag("--no-simplex", options.no_simplex, "only the fast solver");
  recover->add_option("--scene", options.scene, "a folder of meshes/, or a scene file (which gets a floor and a wall)");
  recover->add_option("--meshes", options.meshes, "a folder: every mesh in it");
  recover->add_option("--size", words.size, "of the fast solver's picture")->capture_default_str();
  recover->add_option("--seeds", options.seeds, "hidden lights")->capture_default_str();
  recover->add_option("--simplex-size", words.simplex_size, "of the simplex's picture: smaller, because it takes long")
      ->capture_default_str();
  recover->add_option("--simplex-seeds", options.simplex_seeds, "at most this many for the simplex")
      ->capture_default_str();
  recover->add_option("--simplex-evals", options.simplex_evals, "the simplex's cap")->capture_default_str();
}

int fail(const luminist::Error& error) {
  std::fprintf(stderr, "luminist-bench: %s\n", error.message().c_str());
  return static_cast<int>(error.kind);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures the solver: success, work in full-picture render equivalents, time.", "luminist-bench");
  app.require_subcommand(1);
  Words words;
  add_recover(app, words);
  CLI11_PARSE(app, argc, argv);
  BenchOptions& options = words.options;
  if (!read_size(words.size, options.width, options.height) ||
      !read_size(words.simplex_size, options.simplex_width, options.simplex_height)) {
    return fail({luminist::ErrorKind::kUsage, "a size is two numbers", "", "size", "for example --size 256x256"});
  }
  auto device = luminist::Device::create_headless();
  if (!device) return fail(device.error());
  const auto print = [&](const BenchReport& report) {
    const std::string line = options.json ? to_json_line(report) : to_table_line(report);
    std::printf("%s\n", line.c_str());
    std::fflush(stdout);
  };
  const auto done = run_recover(*device, options, print);
  return done ? 0 : fail(done.error());
}
