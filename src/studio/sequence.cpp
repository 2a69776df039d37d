#include "studio/sequence.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/process.h"
#include "image_io/image_io.h"
#include "params/param_text.h"
#include "rig/light_links.h"
#include "studio/constraint_words.h"
#include "studio/drawing.h"
#include "studio/style_reload.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int kMostFrames = 100'000;

/// An int at the start of a text, and what follows it.
std::optional<int> take_number(std::string_view& text) {
  int value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// The first file of that name in a folder of PATH.
std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / name;
    std::error_code error;
    if (fs::is_regular_file(file, error)) return file.string();
  }
  return "";
}

/// Whether a picture is there that reads to its last pixel, of this size and signature.
bool is_done(const std::string& path, const Shot& shot, const std::string& signature) {
  std::error_code error;
  if (!fs::exists(path, error)) return false;
  const auto stored = read_attribute(path, kSignature);
  return stored && stored->value == signature && stored->width == shot.width && stored->height == shot.height;
}

}  // namespace

Result<FrameRange> FrameRange::parse(const std::string& text) {
  std::string_view rest = text;
  FrameRange range;
  bool fine = true;
  if (const auto first = take_number(rest)) {
    range.first = range.last = *first;
    if (rest.starts_with('-')) {
      rest.remove_prefix(1);
      const auto last = take_number(rest);
      fine = last.has_value();
      range.last = last.value_or(range.first);
      if (fine && rest.starts_with('x')) {
        rest.remove_prefix(1);
        const auto step = take_number(rest);
        fine = step && *step > 0;
        range.step = fine ? *step : 1;
      }
    }
  } else {
    fine = false;
  }
  if (!fine || !rest.empty() || range.last < range.first) {
    return Error{ErrorKind::kUsage, fmt::format("\"{}\" is no range of frames", text), "", "--frames",
                 "write it as 0-47, or 0-47x2 for every second one"};
  }
  if (std::int64_t{range.last} - range.first >= std::int64_t{kMostFrames} * range.step) {
    return Error{ErrorKind::kLimit, fmt::format("\"{}\" is more than {} frames", text, kMostFrames), "", "--frames",
                 "render it in parts"};
  }
  return range;
}

std::vector<int> FrameRange::frames() const {
  std::vector<int> list;
  for (std::int64_t frame = first; frame <= last; frame += step) list.push_back(static_cast<int>(frame));
  return list;
}

std::string frame_path(const std::string& pattern, int frame) {
  constexpr std::size_t kDigits = 4;
  const std::size_t end = pattern.rfind('#');
  if (end == std::string::npos) {
    const fs::path path(pattern);
    const std::string name =
        fmt::format("{}.{:0{}}{}", path.stem().string(), frame, kDigits, path.extension().string());
    return (path.parent_path() / name).string();
  }
  std::size_t begin = end;
  while (begin > 0 && pattern[begin - 1] == '#') --begin;
  return pattern.substr(0, begin) + fmt::format("{:0{}}", frame, end + 1 - begin) + pattern.substr(end + 1);
}

namespace {

/// Content of all that is drawn with: shaders/ of every root.
std::string shader_hash(const AssetRoots& roots) {
  std::vector<fs::path> files;
  for (const fs::path& root : roots.folders()) {
    std::error_code error;
    for (fs::recursive_directory_iterator it(root / "shaders", error), end; !error && it != end; it.increment(error)) {
      if (it->is_regular_file()) files.push_back(it->path());
    }
  }
  std::sort(files.begin(), files.end());
  std::string text;
  for (const fs::path& file : files) {
    const auto bytes = read_file(file);
    text += fmt::format("{} {}\n", file.filename().string(), bytes ? content_hash(*bytes) : "");
  }
  return content_hash(text);
}

Result<ParamState> state_of(const Stage& stage, const AssetRoots& roots, const Sequence& sequence, const Shot& shot) {
  LUM_TRY(ParamState state, starting_state(stage, roots, shot, "."));
  LUM_TRY_VOID(link_lights(state.rig, sequence.links, stage.object_names()));
  LUM_TRY_VOID(add_constraints(state.rig, sequence.constraints, stage.renderer->surface(), stage.bounds));
  return state;
}

}  // namespace

std::string frame_signature(const Stage& stage, const Shot& shot, const ParamState& state,
                            const std::string& made_from) {
  LightRig rig = state.rig;
  rig.keys.clear();  // their values at this frame are what counts
  std::string text =
      fmt::format("{}\n{} {} {} {}x{} {}\n{}\n{}\n", made_from, shot.scene_options.floor, shot.scene_options.wall,
                  shot.camera, shot.width, shot.height, stage.moving ? number_text(shot.seconds()) : "still",
                  rig_to_toml(rig), block_to_json(state.style).dump()) +
      material_bytes(state);
  for (const auto& file : StyleFiles(stage.style).files()) {
    const auto bytes = read_file(file);
    text += fmt::format("{} {}\n", file.filename().string(), bytes ? content_hash(*bytes) : "");
  }
  return content_hash(text);
}

Result<void> check_sequence(Device& device, const AssetRoots& roots, const Sequence& sequence,
                            Diagnostics& diagnostics) {
  if (sequence.frames.empty()) return {};
  Shot shot = sequence.shot;
  shot.frame = sequence.frames.front();
  LUM_TRY(const std::unique_ptr<Stage> stage, open_stage(device, roots, shot, ".", diagnostics));
  LUM_TRY_VOID(state_of(*stage, roots, sequence, shot));
  return {};
}

Result<void> render_sequence(Device& device, const AssetRoots& roots, const Sequence& sequence,
                             const std::function<bool(const FrameDone&)>& watch, Diagnostics& diagnostics) {
  LUM_TRY(const std::string scene, find_input(sequence.shot.scene, ".", roots));
  LUM_TRY(const std::string bytes, read_file(scene));
  const std::string made_from = content_hash(bytes) + shader_hash(roots);
  std::unique_ptr<Stage> stage;
  for (const int frame : sequence.frames) {
    Shot shot = sequence.shot;
    shot.frame = frame;
    if (!stage || stage->moving) {
      LUM_TRY(stage, open_stage(device, roots, shot, ".", diagnostics, stage ? stage->moving : nullptr));
    }
    LUM_TRY(const ParamState state, state_of(*stage, roots, sequence, shot));
    const std::string signature = frame_signature(*stage, shot, state, made_from);
    FrameDone done{frame, frame_path(sequence.pattern, frame), false};
    done.skipped = !sequence.again && is_done(done.path, shot, signature);
    if (!done.skipped) {
      LUM_TRY(const Image picture, stage->renderer->render(state));
      LUM_TRY_VOID(write_image(done.path, picture, {{kSignature, signature}}));
    }
    if (watch && !watch(done)) return {};
  }
  return {};
}

Result<void> make_strip(const std::vector<std::string>& frames, int column_width, const std::string& path) {
  constexpr int kGap = 2;
  std::vector<ImageSource> sources;
  for (const std::string& frame : frames) sources.push_back({frame, {}});
  std::vector<Image> pictures;
  Image strip(0, 0, 3);
  for (Result<Image>& read : read_images(sources)) {
    if (!read) return std::move(read).error();
    Image picture = std::move(*read);
    const int width = std::min(column_width, picture.width);
    const int height = std::max(1, width * picture.height / picture.width);
    pictures.push_back(width < picture.width ? resized(picture, width, height) : std::move(picture));
    strip.width += width + (strip.width > 0 ? kGap : 0);
    strip.height = std::max(strip.height, height);
  }
  strip = Image(strip.width, strip.height, 3, 1.0F);
  Drawing drawing(strip);
  int x = 0;
  for (const Image& picture : pictures) {
    drawing.picture(x, 0, picture);
    x += picture.width + kGap;
  }
  return write_image(path, strip);
}

Result<void> make_film(const std::vector<std::string>& frames, double fps, const std::string& path) {
  const std::string ffmpeg = find_program("ffmpeg");
  if (ffmpeg.empty()) {
    return Error{ErrorKind::kMissing, "ffmpeg, which makes films, is not installed", path, "--film",
                 "install the package ffmpeg; the frames are there"};
  }
  std::vector<std::string> files;
  for (const std::string& frame : frames) {
    LUM_TRY(const Image picture, read_image(frame));
    LUM_TRY(std::string png, encode_png(picture, Encoding::kSrgb));
    files.push_back(std::move(png));
  }
  const fs::path film(path);
  const std::string part =
      (film.parent_path() / fmt::format(".{}.part{}", film.stem().string(), film.extension().string())).string();
  ProcessRequest request;
  request.arguments = {ffmpeg,       "-loglevel",      "error", "-y", "-f",  "image2pipe",
                       "-framerate", number_text(fps), "-i",    "-",  "-vf", "crop=trunc(iw/2)*2:trunc(ih/2)*2",
                       "-pix_fmt",   "yuv420p",        part};
  for (const std::string& file : files) request.input.emplace_back(file);
  LUM_TRY(const ProcessEnd end, run_process(request));
  std::error_code error;
  if (!end.ok()) {
    fs::remove(part, error);
    return Error{ErrorKind::kChild, "ffmpeg " + end.description(), path, "--film", "the frames are there"};
  }
  fs::rename(part, film, error);
  if (error) return Error{ErrorKind::kUnwritable, error.message(), path, "--film", ""};
  return {};
}

}  // namespace luminist
