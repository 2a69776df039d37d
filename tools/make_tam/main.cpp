// make_tam -- draws tonal art maps for hatching: `make_tam ink -o styles/hatching/textures`.
#include <cstdio>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>

#include "base/files.h"
#include "image_io/image_io.h"
#include "make_tam/tonal_art_map.h"

namespace luminist {
namespace {

struct Words {
  std::string kind;
  std::string output;
  std::string sheet;
  std::uint64_t seed = 1;
};

/// Numbers as they are, without the transfer function of colours.
Result<void> write_numbers(const Image& image, const std::filesystem::path& path) {
  LUM_TRY(const std::string png, encode_png(image, Encoding::kLinear));
  LUM_TRY_VOID(write_file_atomic(path, png));
  std::printf("%s\n", path.string().c_str());
  return {};
}

Result<void> run(const Words& words) {
  LUM_TRY(const StrokeKind kind, stroke_kind(words.kind));
  const TonalArtMap map = make_tonal_art_map(kind, words.seed);
  const Image table = tone_table(map);
  const std::filesystem::path folder(words.output);
  LUM_TRY_VOID(make_folder(folder));
  LUM_TRY_VOID(write_numbers(map.strip(), folder / (kind.name + ".png")));
  LUM_TRY_VOID(write_numbers(table, folder / (kind.name + "_tone.png")));
  std::printf("%zu strokes\n", map.strokes.size());
  if (words.sheet.empty()) return {};
  return write_numbers(contact_sheet(map, table), words.sheet);
}

}  // namespace
}  // namespace luminist

int main(int argc, char** argv) {
  CLI::App app("Draws a tonal art map and the table that keeps its tones true; the same bytes every time.");
  luminist::Words words;
  app.add_option("KIND", words.kind, "pencil, ink or stipple")->required();
  app.add_option("-o,--output", words.output, "folder for KIND.png and KIND_tone.png")->required();
  app.add_option("--seed", words.seed, "of the strokes (default: 1)");
  app.add_option("--sheet", words.sheet, "a PNG with all tones at four levels of detail, to look at");
  CLI11_PARSE(app, argc, argv);
  const auto done = luminist::run(words);
  if (done) return 0;
  std::fprintf(stderr, "%s\n", done.error().message().c_str());
  return static_cast<int>(done.error().kind);
}
