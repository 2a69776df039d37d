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

bool same_row(const Target& a, const Target& b, int y) {
  const auto row = static_cast<std::ptrdiff_t>(a.color.index(0, y));
  const std::ptrdiff_t width = a.color.width;
  const auto same = [&](const auto& one, const auto& other, std::ptrdiff_t channels) {
    const auto first = one.begin() + channels * row;
    return std::equal(first, first + channels * width, other.begin() + channels * row);
  };
  return same(a.color.data, b.color.data, 3) && same(a.importance.data, b.importance.data, 1) &&
         same(a.stroke, b.stroke, 1);
}

}  // namespace

void PaintedBuffers::note(const PixelBox& changed) {
  for (Buffer& buffer : buffers_) buffer.stale = joined(buffer.stale, changed);
}

void PaintedBuffers::note_all() {
  for (Buffer& buffer : buffers_) buffer.all_stale = true;
}

void PaintedBuffers::note_change(const Target* before, const Target& now) {
  if (before == nullptr || !before->color.same_size(now.color)) return note_all();
  PixelBox rows{0, 0, now.color.width, now.color.height};
  while (rows.y0 < rows.y1 && same_row(*before, now, rows.y0)) ++rows.y0;
  while (rows.y0 < rows.y1 && same_row(*before, now, rows.y1 - 1)) --rows.y1;
  if (!rows.empty()) note(rows);
}

std::shared_ptr<const PaintedPictures> PaintedBuffers::show(const Target& target) {
  const auto free = [&](const Buffer& buffer) {
    return buffer.pictures && buffer.pictures.use_count() == 1 && buffer.pictures->color.same_size(target.color);
  };
  const auto rank = [&](const Buffer& buffer) { return free(buffer) ? 0 : buffer.pictures ? 2 : 1; };
  const auto fresher = [&](const Buffer& a, const Buffer& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (a.all_stale != b.all_stale) return b.all_stale;
    return a.stale.width() * a.stale.height() < b.stale.width() * b.stale.height();
  };
  Buffer& buffer = *std::min_element(buffers_.begin(), buffers_.end(), fresher);
  if (!free(buffer)) {
    buffer.pictures =
        std::make_shared<PaintedPictures>(PaintedPictures{target.color, target.importance, target.stroke});
  } else {  // into the memory that it has: new memory costs more than the copy
    std::atomic_thread_fence(std::memory_order_acquire);  // what others read of a buffer that they let go is read
    const PixelBox all{0, 0, target.color.width, target.color.height};
    copy_box(target, *buffer.pictures, buffer.all_stale ? all : buffer.stale);
  }
  buffer.stale = {};
  buffer.all_stale = false;
  return buffer.pictures;
}

}  // namespace luminist
