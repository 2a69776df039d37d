#pragma once
// studio/sequence.h -- a shot frame by frame: names of files, and what a frame that is there already was made from.
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "studio/stage.h"

namespace luminist {

/// "12", "0-47", "0-47x2": frames from the first to the last, every so many.
struct FrameRange {
  int first = 0;
  int last = 0;
  int step = 1;

  /// errors kUsage with the wanted form; kLimit for more than 100,000 frames.
  static Result<FrameRange> parse(const std::string& text);
  [[nodiscard]] std::vector<int> frames() const;
};

/// "out/a.####.png" -> "out/a.0012.png": the last run of # holds the number, as many digits at least. Without any it
/// goes before the ending, with four digits.
std::string frame_path(const std::string& pattern, int frame);

/// What every frame of a sequence is made from.
struct Sequence {
  Shot shot;
  std::vector<int> frames;
  std::string pattern;                   ///< of frame_path()
  std::vector<std::string> links;        ///< in words, as link_lights() takes them
  std::vector<std::string> constraints;  ///< in words, as add_constraints() takes them
  bool again = false;                    ///< also where a valid frame is there
};

/// What became of a frame.
struct FrameDone {
  int frame = 0;
  std::string path;
  bool skipped = false;  ///< it was there, whole and of the same signature
};

/// Names what a frame follows from: made_from (the scene's file, the shaders), the style's files and values, lights,
/// camera, size, time. It is stored in the picture (attribute kSignature). Files beside a .gltf or .obj are not looked
/// at, nor is the program itself.
std::string frame_signature(const Stage& stage, const Shot& shot, const ParamState& state,
                            const std::string& made_from);
inline constexpr const char* kSignature = "luminist:frame";

/// Whether its first frame could be rendered: every word of it is tried, no picture is made. errors and cost those of
/// open_stage().
Result<void> check_sequence(Device& device, const AssetRoots& roots, const Sequence& sequence,
                            Diagnostics& diagnostics);

/// Renders what is not there yet, each frame whole or not at all (temporary file, then renamed), and tells watch after
/// each; watch says false to end there. The scene is read once. What is there is judged by reading all of it.
/// errors those of open_stage(), the renderer and write_image(). cost a stage and a picture a frame.
Result<void> render_sequence(Device& device, const AssetRoots& roots, const Sequence& sequence,
                             const std::function<bool(const FrameDone&)>& watch, Diagnostics& diagnostics);

/// Frames that are there side by side, each at most so many pixels wide, two pixels apart. errors those of reading and
/// writing them.
Result<void> make_strip(const std::vector<std::string>& frames, int column_width, const std::string& path);

/// A film of frames that are there, by ffmpeg: H.264 in 4:2:0 at the rate of the shot, an even number of pixels each
/// way. errors kMissing without ffmpeg on the PATH, kChild with what it said.
Result<void> make_film(const std::vector<std::string>& frames, double fps, const std::string& path);

}  // namespace luminist
