#include "studio/picture_export.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "image_io/image_io.h"
#include "studio/heat_map.h"
#include "studio/results.h"
#include "studio/scene_export.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSheetColumns = 3;  // of a sheet
constexpr int kColumnWidth_px = 420;

/// A picture that is to come.
struct Planned {
  std::string name;
  std::string title;
  std::function<Result<Image>()> make;      ///< the numbers
  std::function<Image(const Image&)> look;  ///< what is seen of them; empty: they themselves
};

ParamState alone(const ParamState& state, const std::string& name) {
  ParamState result = state;
  for (Light& light : result.rig.lights) light.muted = light.muted || light.name != name;
  return result;
}

Image seen_residual(const Image& residual) {
  // A few bright pixels must not darken the rest of the map.
  return heat_map_with_scale(residual, std::max(quantile(residual, 0.995), 1e-6F));
}

std::vector<Planned> plan(Session& session, const PictureChoice& choice, const Results& results) {
  std::vector<Planned> all;
  const auto have = [&](const char* name, const char* title, const Image& image,
                        std::function<Image(const Image&)> look = {}) {
    all.push_back({name, title, [&image]() -> Result<Image> { return image; }, std::move(look)});
  };
  if (choice.light) have("picture", "light", results.picture);
  if (choice.paint) have("target", "paint", results.target);
  if (choice.importance) have("importance", "importance (black counts)", results.importance, importance_picture);
  if (choice.residual) have("residual", "residual", results.residual, seen_residual);
  if (!choice.each_light) return all;
  const auto rendered = [&](const std::string& name, const std::string& title, ParamState state) {
    all.push_back(
        {name, title, [&session, state = std::move(state)] { return session.stage().renderer->render(state); }, {}});
  };
  for (const Light& light : session.shown().rig.lights) {
    if (!light.muted) rendered("light_" + light.name, light.name + " alone", alone(session.shown(), light.name));
  }
  rendered("no_lights", "without lights", alone(session.shown(), ""));
  return all;
}

Result<void> write_one(const Planned& planned, const Image& numbers, const Image& seen, const PictureChoice& choice,
                       const fs::path& folder, std::vector<fs::path>& written) {
  std::vector<ImageFile> files;
  if (choice.exr) files.push_back({(folder / (planned.name + ".exr")).string(), &numbers});
  if (choice.png) files.push_back({(folder / (planned.name + ".png")).string(), &seen});
  LUM_TRY_VOID(write_images(files));
  for (const ImageFile& file : files) written.emplace_back(file.path);
  return {};
}

/// Rows of pictures, each under its title, one below the other.
Result<void> write_sheet(const std::vector<std::string>& titles, std::vector<Image> pictures, const fs::path& path) {
  std::vector<Image> rows;
  int height = 0;
  for (std::size_t first = 0; first < pictures.size(); first += kSheetColumns) {
    const std::size_t end = std::min(first + kSheetColumns, pictures.size());
    std::vector<std::string> columns(titles.begin() + static_cast<std::ptrdiff_t>(first),
                                     titles.begin() + static_cast<std::ptrdiff_t>(end));
    columns.resize(std::min(kSheetColumns, titles.size()));  // all rows are equally wide
    SheetRow row;
    for (std::size_t i = first; i < end; ++i) row.pictures.push_back(std::move(pictures[i]));
    rows.push_back(contact_sheet(columns, {row}, kColumnWidth_px));
    height += rows.back().height;
  }
  Image sheet(rows.front().width, height, 3);
  auto at = sheet.data.begin();
  for (const Image& row : rows) at = std::copy(row.data.begin(), row.data.end(), at);
  return write_image(path.string(), sheet);
}

}  // namespace

std::span<const std::string> picture_words() {
  static const std::array<std::string, 5> words = {"light", "paint", "importance", "residual", "each_light"};
  return words;
}

Result<std::vector<fs::path>> export_pictures(Session& session, const PictureChoice& choice, const fs::path& folder,
                                              const ExportWatch& watch) {
  LUM_TRY(const Results results, collect_results(session));
  const bool files = choice.png || choice.exr || choice.sheet;
  const std::vector<Planned> all = files ? plan(session, choice, results) : std::vector<Planned>{};
  if (all.empty() && !choice.rig && !choice.scene) {
    return Error{ErrorKind::kNothingToDo, "nothing is chosen to be exported", "", "pictures",
                 "choose a picture and a format"};
  }
  LUM_TRY_VOID(make_folder(folder));
  std::vector<fs::path> written;
  std::vector<std::string> titles;
  std::vector<Image> small;
  const int count = static_cast<int>(all.size()) + (choice.sheet ? 1 : 0);
  for (const Planned& planned : all) {
    if (watch && !watch(planned.title, static_cast<int>(titles.size()), count)) {
      return Error{ErrorKind::kCancelled, "the export was stopped", folder.string(), "", ""};
    }
    LUM_TRY(const Image numbers, planned.make());
    const Image seen = planned.look ? planned.look(numbers) : numbers;
    LUM_TRY_VOID(write_one(planned, numbers, seen, choice, folder, written));
    titles.push_back(planned.title);
    if (choice.sheet)
      small.push_back(resized(seen, kColumnWidth_px, std::max(1, kColumnWidth_px * seen.height / seen.width)));
  }
  if (choice.sheet && !all.empty()) {
    LUM_TRY_VOID(write_sheet(titles, std::move(small), folder / "sheet.png"));
    written.push_back(folder / "sheet.png");
  }
  if (choice.rig) {
    LUM_TRY_VOID(write_file_atomic(folder / "rig.toml", results.rig));
    LUM_TRY_VOID(write_file_atomic(folder / "style.json", results.style_params));
    written.push_back(folder / "rig.toml");
    written.push_back(folder / "style.json");
    if (!results.materials.empty()) {
      LUM_TRY_VOID(write_file_atomic(folder / "materials.json", results.materials));
      written.push_back(folder / "materials.json");
    }
  }
  if (choice.scene) {
    const fs::path file = folder / "scene.glb";
    LUM_TRY_VOID(export_scene(session.stage(), session.shot(), session.shown(), file.string()));
    written.push_back(file);
  }
  return written;
}

}  // namespace luminist
