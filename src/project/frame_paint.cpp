#include "project/frame_paint.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <string>

#include <fmt/format.h>

#include "params/param_text.h"
#include "project/paint_document.h"

namespace luminist {
namespace {

constexpr std::string_view kFrames = "frames/";
constexpr std::string_view kPaint = "paint/";

std::string folder_of(double frame) {
  return fmt::format("{}{}/", kFrames, number_text(frame + 0.0));
}

std::uint32_t strokes_of(const Document& document) {
  const std::string_view text = document.get("paint/strokes");
  std::uint32_t strokes = 0;
  std::from_chars(text.data(), text.data() + text.size(), strokes);
  return has_paint(document) ? std::max(strokes, 1U) : 0;
}

/// The paint below each "frames/FRAME/", as documents of their own.
std::map<double, Document> put_away(const Document& document) {
  std::map<double, Document> frames;
  const Document::Entries& entries = document.entries();
  for (auto entry = entries.lower_bound(kFrames); entry != entries.end() && entry->first.starts_with(kFrames);
       ++entry) {
    const std::string_view rest = std::string_view(entry->first).substr(kFrames.size());
    double frame = 0.0;
    const auto [end, status] = std::from_chars(rest.data(), rest.data() + rest.size(), frame);
    const auto length = static_cast<std::size_t>(end - rest.data());
    if (status != std::errc() || !rest.substr(length).starts_with("/paint/")) continue;
    frames[frame].set(rest.substr(length + 1), entry->second);
  }
  return frames;
}

}  // namespace

std::vector<PaintedFrame> painted_frames(const Document& document, double present) {
  std::vector<PaintedFrame> frames;
  for (const auto& [frame, paint] : put_away(document)) {
    if (has_paint(paint) && frame != present) frames.push_back({frame, strokes_of(paint)});
  }
  if (has_paint(document)) frames.push_back({present, strokes_of(document)});
  std::sort(frames.begin(), frames.end(), [](const auto& a, const auto& b) { return a.frame < b.frame; });
  return frames;
}

Document at_frame(const Document& document, double present, double frame) {
  Document turned = document;
  if (frame != present) turn_paint(turned, present, frame);
  return turned;
}

void put_frame_paint(Document& document, double frame, const Document& paint) {
  document.erase_below(folder_of(frame) + std::string(kPaint));
  for (const auto& [path, value] : paint.entries()) {
    if (path.starts_with(kPaint)) document.set(folder_of(frame) + path, value);
  }
}

bool clear_frame_paint(Document& document, double frame) {
  const auto frames = put_away(document);
  const auto found = frames.find(frame);
  if (found == frames.end() || !has_paint(found->second)) return false;
  Document kept;
  for (const auto& [path, value] : found->second.entries()) {
    if (path == "paint/nu" || path == "paint/delta" || path.starts_with("paint/previous/")) kept.set(path, value);
  }
  put_frame_paint(document, frame, kept);
  return true;
}

}  // namespace luminist
