#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/shot_words.h"
#include "cli/task_words.h"
#include "image_io/image_io.h"
#include "studio/session.h"

namespace luminist {
namespace {

struct PaintingWords {
  ShotWords shot;
  std::string strokes;
  std::string output;
};

/// target.exr -> target.importance.exr
std::string importance_path(const std::string& target) {
  const std::filesystem::path path(target);
  return (path.parent_path() / (path.stem().string() + ".importance.exr")).string();
}

Result<int> paint(const PaintingWords& words, VerbContext& context) {
  LUM_TRY(const Shot shot, shot_from(words.shot));
  LUM_TRY_VOID(check_image_output(words.output));
  LUM_TRY(const std::string path, find_input(words.strokes, ".", context.roots));
  LUM_TRY(const StrokeFile strokes, load_strokes(path));
  LUM_TRY(Device device, Device::create_headless());
  Diagnostics diagnostics;
  auto session = Session::open(device, context.roots, shot, ".", diagnostics);
  context.console.warn(diagnostics);
  if (!session) return std::move(session).error();
  LUM_TRY_VOID(link_all(**session, words.shot.link));
  LUM_TRY_VOID((*session)->constrain(words.shot.constrain));
  LUM_TRY_VOID((*session)->paint(strokes, path));
  LUM_TRY(const Target* target, (*session)->target());
  const std::string importance = importance_path(words.output);
  const std::vector<ImageFile> files = {{words.output, &target->color}, {importance, &target->importance}};
  LUM_TRY_VOID(write_images(files));
  context.console.result(words.output);
  context.console.result(importance);
  return 0;
}

}  // namespace

Verb declare_paint(CLI::App& app) {
  const auto words = std::make_shared<PaintingWords>();  // the parser and the returned function both use it
  declare_shot(app, words->shot);
  app.add_option("STROKES", words->strokes, "Stroke file (JSON)")->required();
  app.add_option("-o,--output", words->output, "Target: .exr or .png; the importance map is written beside it, as EXR")
      ->required();
  app.footer(
      "Example:\n"
      "  luminist paint meshes/still_life/still_life.glb strokes.json -o target.exr    also target.importance.exr");
  return [words](VerbContext& context) { return paint(*words, context); };
}

}  // namespace luminist
