#pragma once
// raster/metric_pass.h -- how far a picture in graphics memory is from a target; agrees with render/metric.h.
#include "base/files.h"
#include "gpu/device.h"
#include "gpu/gl_buffer.h"
#include "gpu/program.h"
#include "render/target.h"

namespace luminist {

class MetricPass {
 public:
  /// For pictures of this many pixels. errors kMissing, kStyle if the shader is damaged, kLimit.
  static Result<MetricPass> create(Device& device, const AssetRoots& roots, std::size_t pixels);

  /// picture_error() with the plain metric. picture: vec4 [pixels]. Same picture, same bits. The target stays in
  /// graphics memory until another comes. cost one pass over the picture, 8 bytes a lane read back.
  Result<double> error(const GlBuffer& picture, const Target& target);

 private:
  explicit MetricPass(Device& device) : device_(&device) {}
  void upload(const Target& target);

  Device* device_;
  std::size_t pixels_ = 0;
  Program program_;
  GlBuffer wanted_;  ///< vec4 [pixels] target colour, importance
  GlBuffer sums_;
  std::vector<double> partial_;
  // What wanted_ holds. Comparing is cheaper than uploading, and a target has no name.
  std::vector<float> color_;
  std::vector<float> importance_;
  double importance_sum_ = 0.0;
};

}  // namespace luminist
