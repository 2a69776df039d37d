#include "studio/golden.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "image_io/image_io.h"
#include "studio/heat_map.h"
#include "studio/stage.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

fs::path reference_path(const Style& style, const GoldenCase& golden) {
  return fs::path(style.folder) / "golden" / (golden.name + ".exr");
}

std::size_t count_not_finite(const Image& image) {
  return static_cast<std::size_t>(
      std::count_if(image.data.begin(), image.data.end(), [](float v) { return !std::isfinite(v); }));
}

double difference_of(float value, float reference) {
  return std::abs(static_cast<double>(value) - reference) / std::max(1.0, std::abs(static_cast<double>(reference)));
}

/// Per pixel the largest difference of its channels.
Image difference_map(const Image& picture, const Image& reference) {
  Image map(picture.width, picture.height, 1);
  for (std::size_t i = 0; i < picture.data.size(); ++i) {
    float& worst = map.data[i / static_cast<std::size_t>(picture.channels)];
    worst = std::max(worst, static_cast<float>(difference_of(picture.data[i], reference.data[i])));
  }
  return map;
}

void judge(GoldenOutcome& outcome) {
  const PictureDifference& d = outcome.difference;
  const GoldenCase& golden = outcome.golden;
  outcome.passed =
      d.fault.empty() && d.max_difference <= golden.max_difference && d.mean_difference <= golden.mean_difference;
  outcome.verdict = !d.fault.empty()
                        ? d.fault
                        : fmt::format("max {:.3g} (allowed {:.3g}), mean {:.3g} (allowed {:.3g})", d.max_difference,
                                      golden.max_difference, d.mean_difference, golden.mean_difference);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

PictureDifference compare_pictures(const Image& picture, const Image& reference) {
  PictureDifference difference;
  if (!picture.same_size(reference)) {
    difference.fault = fmt::format("{} x {} pixels, the reference has {} x {}", picture.width, picture.height,
                                   reference.width, reference.height);
    return difference;
  }
  if (picture.channels != reference.channels) {
    difference.fault = fmt::format("{} channels, the reference has {}", picture.channels, reference.channels);
    return difference;
  }
  if (const std::size_t count = count_not_finite(picture); count != 0 || count_not_finite(reference) != 0) {
    difference.fault = fmt::format("{} values are not finite, {} of the reference", count, count_not_finite(reference));
    return difference;
  }
  for (std::size_t i = 0; i < picture.data.size(); ++i) {
    const double d = difference_of(picture.data[i], reference.data[i]);
    difference.max_difference = std::max(difference.max_difference, d);
    difference.mean_difference += d / static_cast<double>(picture.data.size());
  }
  return difference;
}

Result<GoldenOutcome> run_golden(Device& device, const AssetRoots& roots, const Style& style, const GoldenCase& golden,
                                 const fs::path& output, Diagnostics& diagnostics) {
  Shot shot;
  shot.scene = golden.scene;
  shot.rig = golden.rig;
  shot.camera = golden.camera;
  shot.width = golden.width;
  shot.height = golden.height;
  shot.style = golden.style.empty() ? style.name : fmt::format("{}+{}", golden.style, style.name);
  shot.set = golden.set;
  LUM_TRY(const auto stage, open_stage(device, roots, shot, style.folder, diagnostics));
  LUM_TRY(const ParamState state, starting_state(*stage, roots, shot, style.folder));
  LUM_TRY(Image picture, stage->renderer->render(state));
  const auto in_output = [&](const char* ending) { return (output / (golden.name + ending)).string(); };
  const std::string file = in_output(".exr");
  const std::vector<ImageFile> candidate = {{file, &picture}, {in_output(".png"), &picture}};
  LUM_TRY_VOID(write_images(candidate));
  GoldenOutcome outcome{.golden = golden, .verdict = "", .difference = {}};
  const fs::path reference_file = reference_path(style, golden);
  auto reference = read_image(reference_file.string());
  if (!reference && reference.error().kind == ErrorKind::kMissing) {
    outcome.verdict = fmt::format("no reference {}; the candidate is {}", reference_file.string(), file);
    return outcome;
  }
  if (!reference) return std::move(reference).error();
  outcome.has_reference = true;
  LUM_TRY(picture, read_image(file));  // both went through the file's half floats
  outcome.difference = compare_pictures(picture, *reference);
  judge(outcome);
  Image map;
  std::vector<ImageFile> files = {{in_output(".reference.png"), &*reference}};
  if (picture.same_size(*reference) && picture.channels == reference->channels) {
    map = heat_map(difference_map(picture, *reference), static_cast<float>(std::max(golden.max_difference, 1e-3)));
    files.push_back({in_output(".difference.png"), &map});
  }
  LUM_TRY_VOID(write_images(files));
  return outcome;
}

Result<void> accept_golden(const Style& style, const GoldenCase& golden, const fs::path& output) {
  const fs::path folder = reference_path(style, golden).parent_path();
  LUM_TRY_VOID(make_folder(folder));
  for (const char* extension : {".exr", ".png"}) {
    LUM_TRY(const std::string bytes, read_file(output / (golden.name + extension)));
    LUM_TRY_VOID(write_file_atomic(folder / (golden.name + extension), bytes));
  }
  return {};
}

Result<void> write_golden_page(const std::string& style, const std::vector<GoldenOutcome>& outcomes,
                               const fs::path& output) {
  std::string page = fmt::format(
      "<!doctype html>\n<meta charset=\"utf-8\">\n<title>{0}: golden pictures</title>\n"
      "<style>body {{ background: #28282a; color: #ddd; font: 15px sans-serif }} td, th {{ padding: 6px; text-align: "
      "left; vertical-align: top }} .failed {{ color: #ff8a65 }} .passed {{ color: #9ccc65 }}</style>\n"
      "<h1>{0}</h1>\n<table>\n<tr><th>new<th>reference<th>difference</tr>\n",
      escaped(style));
  for (const GoldenOutcome& outcome : outcomes) {
    const std::string name = escaped(outcome.golden.name);
    page += fmt::format("<tr><td colspan=\"3\"><b>{}</b> <span class=\"{}\">{}</span>: {}. {}</tr>\n", name,
                        outcome.passed ? "passed" : "failed", outcome.passed ? "passed" : "failed",
                        escaped(outcome.verdict), escaped(outcome.golden.reason));
    page += fmt::format("<tr><td><img src=\"{}.png\">", name);
    page += outcome.has_reference
                ? fmt::format("<td><img src=\"{0}.reference.png\"><td><img src=\"{0}.difference.png\">", name)
                : "<td>none<td>";
    page += "</tr>\n";
  }
  return write_file_atomic(output / "index.html", page + "</table>\n");
}

}  // namespace luminist
