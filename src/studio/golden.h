#pragma once
// studio/golden.h -- a style's golden pictures: rendered again and compared.
#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/files.h"
#include "base/image.h"
#include "gpu/device.h"
#include "style/style.h"

namespace luminist {

/// How a picture differs from its reference.
struct PictureDifference {
  std::string fault;            ///< "" or why the two cannot be compared: size, channels, pixels that are not finite
  double max_difference = 0.0;  ///< of any channel of any pixel: |a - b| / max(1, |b|)
  double mean_difference = 0.0;
};

/// A pixel that differs, and more than those around it.
struct WorstPixel {
  int x = 0;
  int y = 0;
  double difference = 0.0;
  std::vector<float> picture;  ///< [channels]
  std::vector<float> reference;
};

/// In this order: size, channels, number of values that are not finite, then the two numbers.
PictureDifference compare_pictures(const Image& picture, const Image& reference);

/// The pixels that differ most, at most `count`, none within 8 pixels of another. Sizes and channels are equal.
std::vector<WorstPixel> worst_pixels(const Image& picture, const Image& reference, int count);

struct GoldenOutcome {
  GoldenCase golden;
  bool passed = false;
  std::string verdict;  ///< one sentence without a full stop
  bool has_reference = false;
  PictureDifference difference;
  std::vector<WorstPixel> worst;
};

/// A case as it is judged on a device: a graphics processor may differ as much as the style allows it, too.
GoldenCase golden_on(const DeviceInfo& device, const Style& style, GoldenCase golden);

/// Renders a case to output/NAME.exr (and .png), compares it with the style's golden/NAME.exr and writes
/// NAME.reference.png and NAME.difference.png beside it. A missing reference fails; the candidate stays.
/// errors those of rendering and writing: a picture that differs is an outcome.
Result<GoldenOutcome> run_golden(Device& device, const AssetRoots& roots, const Style& style, const GoldenCase& golden,
                                 const std::filesystem::path& output, Diagnostics& diagnostics);

/// Makes the candidate of a case the style's reference: the EXR that is compared and a PNG to look at.
/// errors kMissing, kUnwritable.
Result<void> accept_golden(const Style& style, const GoldenCase& golden, const std::filesystem::path& output);

/// output/outcomes.json, of which tools/golden.py makes a page: for each case its verdict, reason, both differences and
/// what is allowed, the files of the pictures and the worst pixels. errors kUnwritable.
Result<void> write_outcomes(const Style& style, const std::vector<GoldenOutcome>& outcomes,
                            const std::filesystem::path& output);

}  // namespace luminist
