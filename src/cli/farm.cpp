#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/shot_words.h"
#include "params/param_text.h"
#include "studio/farm.h"
#include "studio/sequence.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

struct FarmWords {
  ShotWords shot;
  std::string frames;
  std::string output;
  std::string job;
  std::string program;
  int chunk = 8;
};

/// The words of `render` again, with paths that hold on other machines of the same file system.
Result<std::vector<std::string>> render_words(const FarmWords& words, const Shot& shot, const AssetRoots& roots) {
  LUM_TRY(const std::string scene, find_input(shot.scene, ".", roots));
  std::vector<std::string> list{fs::absolute(scene).string()};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) list.insert(list.end(), {option, value});
  };
  add("--camera", shot.camera);
  add("--size", words.shot.size);
  if (!shot.rig.empty()) {
    LUM_TRY(const std::string rig, find_input(shot.rig, ".", roots));
    add("--rig", fs::absolute(rig).string());
  }
  add("--style", words.shot.style);
  for (const std::string& each : shot.set) add("--set", each);
  for (const std::string& each : words.shot.link) add("--link", each);
  for (const std::string& each : words.shot.constrain) add("--constrain", each);
  if (shot.scene_options.floor) list.emplace_back("--floor");
  if (shot.scene_options.wall) list.emplace_back("--wall");
  add("--fps", number_text(shot.fps));
  add("-o", fs::absolute(words.output).string());
  return list;
}

Result<int> farm(const FarmWords& words, VerbContext& context) {
  LUM_TRY(const Shot shot, shot_from(words.shot));
  FarmJob job;
  LUM_TRY(job.range, FrameRange::parse(words.frames));
  LUM_TRY_VOID(check_image_output(words.output));
  LUM_TRY(job.arguments, render_words(words, shot, context.roots));
  // A wrong word is told here rather than by every task.
  LUM_TRY(Device device, Device::create_headless());
  const std::vector<int> frames = job.range.frames();
  const Sequence sequence{shot, {frames.front()}, words.output, words.shot.link, words.shot.constrain, false};
  Diagnostics diagnostics;
  LUM_TRY_VOID(check_sequence(device, context.roots, sequence, diagnostics));
  context.console.warn(diagnostics);
  std::error_code error;
  job.program = words.program.empty() ? fs::read_symlink("/proc/self/exe", error).string() : words.program;
  job.chunk = words.chunk;
  LUM_TRY_VOID(write_farm_job(job, words.job));
  const fs::path folder(words.job);
  context.console.result((folder / "commands.txt").string() + ": for instance parallel < commands.txt");
  context.console.result((folder / "job.sh").string() + ": sbatch job.sh");
  return 0;
}

}  // namespace

Verb declare_farm(CLI::App& app) {
  const auto words = std::make_shared<FarmWords>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  app.add_option("--frames", words->frames, "The sequence, as 0-47 or 0-47x2")->required();
  app.add_option("-o,--output", words->output, "Pictures: .exr or .png, the number for ####")->required();
  app.add_option("--job", words->job, "Folder for job.sh (Slurm) and commands.txt (a command a line)")->required();
  app.add_option("--chunk", words->chunk, "Frames a task (default: 8)")->check(CLI::Range(1, 100000));
  app.add_option("--program", words->program, "The program on the farm's machines (default: this one)");
  app.footer(
      "Examples:\n"
      "  luminist farm scene.glb --rig keyed.toml --frames 0-239 -o /shared/f.####.exr --job job && (cd job && sbatch "
      "job.sh)\n"
      "  luminist farm scene.glb --rig keyed.toml --frames 0-239 -o f.####.exr --job job && parallel < "
      "job/commands.txt");
  return [words](VerbContext& context) { return farm(*words, context); };
}

}  // namespace luminist
