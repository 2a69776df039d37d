#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "cli/shot_words.h"
#include "image_io/image_io.h"
#include "rig/light_links.h"
#include "studio/constraint_words.h"
#include "studio/scene_export.h"
#include "studio/sequence.h"
#include "studio/stage.h"
#include "studio/style_reload.h"
#include "trace/path_renderer.h"

namespace luminist {
namespace {

struct RenderWords {
  ShotWords shot;
  std::string output;
  bool watch = false;
  std::string frames;
  std::string film;
  std::string strip;
  bool again = false;
  std::string scene_output;
};

/// Renders again whenever a file of the style is written, until a signal ends it; a version with a mistake is reported,
/// and the last good picture stays.
int watch(const RenderWords& words, Stage& stage, ParamState state, StyleFiles files, VerbContext& context) {
  const StopSignals::Grace grace(context.signals);
  context.console.progress("watching " + stage.style.folder);
  while (context.signals.stopped() == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (!files.changed()) continue;
    const auto draw = [&]() -> Result<void> {
      LUM_TRY(ParamState next, reload_style(stage, context.roots, state));
      files.follow(stage.style);
      LUM_TRY(const Image picture, stage.renderer->render(next));
      state = std::move(next);
      return write_image(words.output, picture);
    };
    if (const Result<void> drawn = draw(); drawn) {
      context.console.result(words.output);
    } else {
      context.console.error(drawn.error());
    }
  }
  return 0;
}

/// Frame after frame; what is there already, whole and of the same lights, is left as it is.
Result<int> render_frames(const RenderWords& words, const Shot& shot, VerbContext& context) {
  LUM_TRY(const FrameRange range, FrameRange::parse(words.frames));
  const Sequence sequence{shot, range.frames(), words.output, words.shot.link, words.shot.constrain, words.again};
  LUM_TRY(Device device, Device::create_headless());
  const StopSignals::Grace grace(context.signals);
  Diagnostics diagnostics;
  std::vector<std::string> files;
  const auto watch = [&](const FrameDone& done) {
    files.push_back(done.path);
    context.console.result(done.skipped ? done.path + " (was there)" : done.path);
    return context.signals.stopped() == 0;
  };
  const auto rendered = render_sequence(device, context.roots, sequence, watch, diagnostics);
  context.console.warn(diagnostics);
  if (!rendered) return rendered.error();
  if (context.signals.stopped() != 0) return 128 + context.signals.stopped();
  if (!words.strip.empty()) {
    constexpr int kStripColumn = 480;
    LUM_TRY_VOID(make_strip(files, kStripColumn, words.strip));
    context.console.result(words.strip);
  }
  if (words.film.empty()) return 0;
  LUM_TRY_VOID(make_film(files, shot.fps, words.film));
  context.console.result(words.film);
  return 0;
}

Result<int> render(const RenderWords& words, VerbContext& context) {
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_image_output(words.output));
  if (words.watch && !words.frames.empty()) {
    return Error{ErrorKind::kUsage, "a sequence is not watched", "", "--watch", "leave out --frames"};
  }
  if (!words.scene_output.empty() && !words.scene_output.ends_with(".glb")) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no place for a scene", words.scene_output), "", "--scene",
                 "give a file that ends in .glb"};
  }
  if (!words.frames.empty()) return render_frames(words, shot, context);
  LUM_TRY(Device device, Device::create_headless());
  Diagnostics diagnostics;
  auto stage = open_stage(device, context.roots, shot, ".", diagnostics);
  context.console.warn(diagnostics);
  if (!stage) return std::move(stage).error();
  LUM_TRY(ParamState state, starting_state(**stage, context.roots, shot, "."));
  LUM_TRY_VOID(link_lights(state.rig, words.shot.link, (*stage)->object_names()));
  LUM_TRY_VOID(add_constraints(state.rig, words.shot.constrain, (*stage)->renderer->surface(), (*stage)->bounds));
  Diagnostics doubts;
  warn_of_ranges(state, shot.set, (*stage)->frame, doubts);
  if (state.rig.lights.empty()) {
    doubts.warn(shot.scene, "no lights, so only the dim ambient shows; give --rig, or paint and solve");
  }
  context.console.warn(doubts);
  StyleFiles files((*stage)->style);
  if (PathRenderer* paths = (*stage)->paths; paths != nullptr) {
    paths->set_watch([&](const PathProgress& progress) {
      context.console.progress(fmt::format("{} of {} samples", progress.samples, progress.of));
      return true;
    });
  }
  LUM_TRY(const Image picture, (*stage)->renderer->render(state));
  LUM_TRY_VOID(write_image(words.output, picture));
  context.console.result(words.output);
  if (!words.scene_output.empty()) {
    LUM_TRY_VOID(export_scene(**stage, shot, state, words.scene_output));
    context.console.result(words.scene_output);
  }
  return words.watch ? watch(words, **stage, std::move(state), std::move(files), context) : 0;
}

}  // namespace

Verb declare_render(CLI::App& app) {
  const auto words = std::make_shared<RenderWords>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  app.add_option("-o,--output", words->output, "Picture: .exr (linear) or .png")->required();
  app.add_flag("--watch", words->watch, "Renders again whenever the style's files are written, until Ctrl-C");
  CLI::Option* frames =
      app.add_option("--frames", words->frames,
                     "A sequence, as 0-47 or 0-47x2; -o has the number for #### before its "
                     "ending. Frames that are there, whole and from the same scene, style and lights, stay");
  app.add_option("--film", words->film, "A film of the frames, .mp4, by ffmpeg")->needs(frames);
  app.add_option("--strip", words->strip, "The frames side by side: .png or .exr")->needs(frames);
  app.add_option("--scene", words->scene_output, "The scene with its materials as --set has them, .glb")
      ->excludes(frames);
  app.add_flag("--again", words->again, "Renders frames also where they are there")->needs(frames);
  app.footer(
      "Examples:\n"
      "  luminist render meshes/still_life/still_life.glb -o dim.png\n"
      "  luminist render meshes/room/room.glb --rig meshes/room/rig.toml --style path --samples 256 -o room.exr\n"
      "  luminist render model.obj --floor --wall --style toon --set style/threshold=0.4 --size 1280x720 -o model.exr\n"
      "  luminist render meshes/still_life/still_life.glb --set materials/jug_glaze/roughness=0.6 --scene dull.glb -o "
      "dull.png\n"
      "  luminist render meshes/creature/creature.glb --rig keyed.toml --frames 0-47 -o out/f.####.exr --film f.mp4");
  return [words](VerbContext& context) { return render(*words, context); };
}

}  // namespace luminist
