#include "studio/painted_buffers.h"

#include <algorithm>
#include <atomic>

namespace luminist {
namespace {

void copy_box(const Target& from, PaintedPictures& to, const PixelBox& box) {
  for (int y = box.y0; y < box.y1; ++y) {
    const auto row = static_cast<std::ptrdiff_t>(from.color.index(box.x0, y));
    std::copy_n(from.color.data.begin() + 3 * row, 3 * box.width(), to.color.data.begin() + 3 * row);
    std::copy_n(from.importance.data.begin() + row, box.width(), to.importance.data.begin() + row);
    std::copy_n(from.stroke.begin() + row, box.width(), to.stroke.begin() + row);
  }
}

}  // namespace

void PaintedBuffers::note(const PixelBox& changed) {
  for (Buffer& buffer : buffers_) buffer.stale = joined(buffer.stale, changed);
}

void PaintedBuffers::note_all() {
  for (Buffer& buffer : buffers_) buffer.all_stale = true;
}

std::shared_ptr<const PaintedPictures> PaintedBuffers::show(const Target& target) {
  const auto free = [&](const Buffer& buffer) {
    return buffer.pictures && buffer.pictures.use_count() == 1 && buffer.pictures->color.same_size(target.color);
  };
  const auto fresher = [&](const Buffer& a, const Buffer& b) {
    if (free(a) != free(b)) return free(a);
    if (a.all_stale != b.all_stale) return b.all_stale;
    return a.stale.width() * a.stale.height() < b.stale.width() * b.stale.height();
  };
  std::atomic_thread_fence(std::memory_order_acquire);  // what others read of a buffer that they let go is read
  Buffer& buffer = *std::min_element(buffers_.begin(), buffers_.end(), fresher);
  if (!free(buffer) || buffer.all_stale) {
    buffer.pictures =
        std::make_shared<PaintedPictures>(PaintedPictures{target.color, target.importance, target.stroke});
  } else {
    copy_box(target, *buffer.pictures, buffer.stale);
  }
  buffer.stale = {};
  buffer.all_stale = false;
  return buffer.pictures;
}

}  // namespace luminist
