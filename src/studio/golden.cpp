#include "studio/golden.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "image_io/image_io.h"
#include "render/metric.h"
#include "rig/light_links.h"
#include "studio/heat_map.h"
#include "studio/stage.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr int kWorstPixels = 8;

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

using OrderedJson = nlohmann::ordered_json;

OrderedJson to_json(const GoldenOutcome& outcome) {
  const GoldenCase& golden = outcome.golden;
  OrderedJson worst = OrderedJson::array();
  for (const WorstPixel& pixel : outcome.worst) {
    worst.push_back({{"x", pixel.x},
                     {"y", pixel.y},
                     {"difference", pixel.difference},
                     {"new", pixel.picture},
                     {"reference", pixel.reference}});
  }
  OrderedJson json{{"name", golden.name},
                   {"passed", outcome.passed},
                   {"verdict", outcome.verdict},
                   {"reason", golden.reason},
                   {"max_difference", outcome.difference.max_difference},
                   {"max_allowed", golden.max_difference},
                   {"mean_difference", outcome.difference.mean_difference},
                   {"mean_allowed", golden.mean_difference},
                   {"new", golden.name + ".png"},
                   {"worst", std::move(worst)}};
  if (outcome.has_reference) json["reference"] = golden.name + ".reference.png";
  if (outcome.has_reference && outcome.difference.fault.empty()) json["difference"] = golden.name + ".difference.png";
  return json;
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

std::vector<WorstPixel> worst_pixels(const Image& picture, const Image& reference, int count) {
  constexpr int kApart = 8;
  const Image map = difference_map(picture, reference);
  std::vector<std::size_t> order(map.pixels());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&map](std::size_t i) { return !(map.data[i] > 0.0F); });
  std::ranges::stable_sort(order, [&map](std::size_t a, std::size_t b) { return map.data[a] > map.data[b]; });
  std::vector<WorstPixel> worst;
  for (const std::size_t i : order) {
    if (std::ssize(worst) >= count) break;
    const int x = static_cast<int>(i % static_cast<std::size_t>(map.width));
    const int y = static_cast<int>(i / static_cast<std::size_t>(map.width));
    const bool near = std::ranges::any_of(worst, [&](const WorstPixel& other) {
      return std::abs(other.x - x) < kApart && std::abs(other.y - y) < kApart;
    });
    if (near) continue;
    WorstPixel pixel{x, y, map.data[i], {}, {}};
    for (int c = 0; c < picture.channels; ++c) {
      pixel.picture.push_back(picture.at(x, y, c));
      pixel.reference.push_back(reference.at(x, y, c));
    }
    worst.push_back(std::move(pixel));
  }
  return worst;
}

GoldenCase golden_on(const DeviceInfo& device, const Style& style, GoldenCase golden) {
  if (device.software || !style.golden_gpu) return golden;
  const GoldenAllowance& there = *style.golden_gpu;
  if (there.max_difference <= golden.max_difference && there.mean_difference <= golden.mean_difference) return golden;
  golden.max_difference = std::max(golden.max_difference, there.max_difference);
  golden.mean_difference = std::max(golden.mean_difference, there.mean_difference);
  golden.reason += " " + there.reason;
  return golden;
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
  LUM_TRY(ParamState state, starting_state(*stage, roots, shot, style.folder));
  LUM_TRY_VOID(link_lights(state.rig, golden.link, stage->object_names()));
  LUM_TRY(Image picture, stage->renderer->render(state));
  const auto in_output = [&](const char* ending) { return (output / (golden.name + ending)).string(); };
  const std::string file = in_output(".exr");
  const std::vector<ImageFile> candidate = {{file, &picture}, {in_output(".png"), &picture}};
  LUM_TRY_VOID(write_images(candidate));
  GoldenOutcome outcome{
      .golden = golden_on(device.info(), style, golden), .verdict = "", .difference = {}, .worst = {}};
  const fs::path reference_file = reference_path(style, golden);
  auto reference = read_image(reference_file.string());
  if (!reference && reference.error().kind == ErrorKind::kMissing) {
    outcome.verdict = fmt::format("no reference {}; the candidate is {}", reference_file.string(), file);
    return outcome;
  }
  if (!reference) return std::move(reference).error();
  outcome.has_reference = true;
  LUM_TRY(picture, read_image(file));  // both went through the file's half floats
  const StyleMetric metric = golden.blurred ? stage->style.metric : StyleMetric{};
  const Image seen = as_compared(picture, metric);
  const Image wanted = as_compared(*reference, metric);
  outcome.difference = compare_pictures(seen, wanted);
  judge(outcome);
  Image map;
  std::vector<ImageFile> files = {{in_output(".reference.png"), &*reference}};
  if (picture.same_size(*reference) && picture.channels == reference->channels) {
    outcome.worst = worst_pixels(seen, wanted, kWorstPixels);
    map = heat_map(difference_map(seen, wanted), static_cast<float>(std::max(golden.max_difference, 1e-3)));
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

Result<void> write_outcomes(const Style& style, const std::vector<GoldenOutcome>& outcomes, const fs::path& output) {
  OrderedJson cases = OrderedJson::array();
  for (const GoldenOutcome& outcome : outcomes) cases.push_back(to_json(outcome));
  const OrderedJson json{{"style", style.name}, {"folder", style.folder}, {"cases", std::move(cases)}};
  return write_file_atomic(output / "outcomes.json",
                           json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace luminist
