#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "cli/shot_words.h"
#include "studio/carried_paint.h"

namespace luminist {
namespace {

struct CarryWords {
  ShotWords view;
  std::string strokes;
  std::optional<double> to_frame;
  std::optional<std::string> to_camera;
  std::string output;
  bool json = false;
};

Result<int> carry(const CarryWords& words, VerbContext& context) {
  LUM_TRY(const Shot from, shot_from(words.view));
  if (!words.to_frame && !words.to_camera) {
    return Error{ErrorKind::kUsage, "to which frame or camera", "", "--to-frame", "give --to-frame or --to-camera"};
  }
  if (std::filesystem::path(words.output).extension() != ".json") {
    return Error{ErrorKind::kUsage, "strokes are written as JSON", words.output, "--output", "name it x.json"};
  }
  Shot to = from;
  to.frame = words.to_frame.value_or(from.frame);
  to.camera = words.to_camera.value_or(from.camera);
  LUM_TRY(const std::string path, find_input(words.strokes, ".", context.roots));
  LUM_TRY(const StrokeFile strokes, load_strokes(path));
  if (strokes.strokes.empty()) {
    return Error{ErrorKind::kNothingToDo, "there are no strokes", path, "strokes", "paint first"};
  }
  Diagnostics diagnostics;
  auto carried = carry_paint(context.roots, strokes, from, to, ".", diagnostics);
  context.console.warn(diagnostics);
  if (!carried) {
    Error error = std::move(carried).error();
    if (error.where.empty() && error.field.rfind("strokes", 0) == 0) error.where = path;
    return error;
  }
  if (context.console.json()) {
    context.console.result(fates_to_json(carried->fates));
  } else {
    for (std::size_t i = 0; i < carried->fates.size(); ++i) {
      context.console.result(fate_line(carried->fates[i], i + 1));
    }
  }
  if (carried->strokes.strokes.empty()) {
    return Error{ErrorKind::kNothingToDo, "nothing of the paint is seen there", path, "",
                 "try another frame or camera"};
  }
  LUM_TRY_VOID(write_file_atomic(words.output, strokes_to_json(carried->strokes)));
  if (!context.console.json()) context.console.result(words.output);
  return 0;
}

}  // namespace

Verb declare_carry(CLI::App& app) {
  const auto words = std::make_shared<CarryWords>();  // the parser and the returned function both use it
  declare_view(app, words->view);
  app.add_option("--paint", words->strokes, "Stroke file (JSON), of this frame and camera")->required();
  app.add_option("--to-frame", words->to_frame, "The frame that the strokes are for (default: the same)");
  app.add_option("--to-camera", words->to_camera, "The camera that the strokes are for (default: the same)");
  app.add_option("-o,--output", words->output, "The strokes for there (JSON)")->required();
  app.add_flag("--json", words->json, "What became of each stroke as an object");
  app.footer(
      "Strokes lie on the surface and move with it; what is hidden there is left out. --size gives the shape of both\n"
      "pictures, nothing is drawn.\n"
      "Example:\n"
      "  luminist carry meshes/creature/creature.glb --paint f16.json --frame 16 --to-frame 26 -o f26.json");
  return [words](VerbContext& context) { return carry(*words, context); };
}

}  // namespace luminist
