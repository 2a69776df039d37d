#include "raster/metric_pass.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/check.h"

namespace luminist {
namespace {

constexpr std::size_t kLanes = 4096;  // partial sums; enough to fill a GPU, few enough to read back

/// Bits, not values: NaN equals itself.
bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

}  // namespace

Result<MetricPass> MetricPass::create(Device& device, const AssetRoots& roots, std::size_t pixels) {
  MetricPass pass(device);
  pass.pixels_ = pixels;
  std::vector<SourceChunk> chunks;
  for (const char* file : {"shaders/raster/dispatch.glsl", "shaders/raster/metric.comp"}) {
    LUM_TRY(SourceChunk chunk, load_chunk(roots, file));
    chunks.push_back(std::move(chunk));
  }
  LUM_TRY(pass.program_, Program::compute(device, chunks, "metric"));
  pass.program_.set("pixels", static_cast<unsigned>(pixels));
  pass.program_.set("lanes", static_cast<unsigned>(kLanes));
  LUM_TRY(pass.wanted_, GlBuffer::create(device, BufferUse::kStorage, pixels * sizeof(Vec4), "target"));
  LUM_TRY(pass.sums_, GlBuffer::create(device, BufferUse::kStorage, kLanes * sizeof(double), "metric sums"));
  pass.partial_.resize(kLanes);
  return pass;
}

void MetricPass::upload(const Target& target) {
  if (same_bits(color_, target.color.data) && same_bits(importance_, target.importance.data)) return;
  color_ = target.color.data;
  importance_ = target.importance.data;
  std::vector<Vec4> wanted(pixels_);
  importance_sum_ = 0.0;
  for (std::size_t i = 0; i < pixels_; ++i) {
    wanted[i] = Vec4(target.color.rgb(i), importance_[i]);
    importance_sum_ += static_cast<double>(importance_[i]);
  }
  wanted_.write(0, std::span<const Vec4>(wanted));
}

Result<double> MetricPass::error(const GlBuffer& picture, const Target& target) {
  LUM_CHECK(target.color.pixels() == pixels_ && target.color.channels == 3, "a target has the picture's size");
  LUM_CHECK(target.importance.pixels() == pixels_ && target.importance.channels == 1, "so has its importance");
  upload(target);
  if (!(importance_sum_ > 0.0)) return 0.0;
  picture.bind_storage(0);
  wanted_.bind_storage(1);
  sums_.bind_storage(2);
  program_.use();
  program_.dispatch(*device_, kLanes);
  sums_.read(0, std::span<double>(partial_));
  double sum = 0.0;
  for (const double lane : partial_) sum += lane;
  return sum / importance_sum_;
}

}  // namespace luminist
