#include "project/frame_paint.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "params/param_text.h"
#include "project/paint_document.h"

namespace luminist {
namespace {

constexpr std::string_view kFrames = "frames/";
constexpr std::string_view kCameras = "cameras/";
constexpr std::string_view kPaint = "paint/";
constexpr std::string_view kStrokes = "paint/strokes";

/// A camera's name as a part of a path, which has no "/".
std::string escaped(std::string_view name) {
  std::string text;
  for (const char c : name) text += c == '/' ? "%2F" : c == '%' ? "%25" : std::string(1, c);
  return text;
}

std::string unescaped(std::string_view text) {
  std::string name;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view code = text.substr(i, 3);
    const char c = code == "%2F" ? '/' : text[i];
    name += c;
    if (code == "%2F" || code == "%25") i += 2;
  }
  return name;
}

std::string folder_of(const Vantage& vantage) {
  return fmt::format("{}{}/{}{}/", kCameras, escaped(vantage.camera), kFrames, number_text(vantage.frame + 0.0));
}

/// What lies below one prefix lies below another one.
void move(Document& document, const std::string& from, const std::string& to) {
  std::vector<std::pair<std::string, std::string>> moved;
  const Document::Entries& entries = document.entries();
  for (auto entry = entries.lower_bound(from); entry != entries.end() && entry->first.starts_with(from); ++entry) {
    moved.emplace_back(to + entry->first.substr(from.size()), entry->second);
  }
  document.erase_below(from);
  document.erase_below(to);
  for (auto& [path, value] : moved) document.set(path, std::move(value));
}

/// A path of paint that is put away, taken apart; `camera` is that of paths that name none.
struct AwayPath {
  Vantage at;
  std::string_view rest;  ///< "paint/..."
};

std::optional<AwayPath> take_apart(std::string_view path, const std::string& camera) {
  AwayPath away{{camera, 0.0}, {}};
  if (path.starts_with(kCameras)) {
    path.remove_prefix(kCameras.size());
    const std::size_t end = std::min(path.find('/'), path.size());
    away.at.camera = unescaped(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  if (!path.starts_with(kFrames)) return std::nullopt;
  path.remove_prefix(kFrames.size());
  const auto [end, status] = std::from_chars(path.data(), path.data() + path.size(), away.at.frame);
  path.remove_prefix(static_cast<std::size_t>(end - path.data()));
  if (status != std::errc() || !path.starts_with("/paint/")) return std::nullopt;
  away.rest = path.substr(1);
  return away;
}

/// Paint at "frames/FRAME/paint/...", the older form, is that of the camera that is looked through.
void adopt_frames(Document& document, const std::string& camera) {
  std::set<double> frames;
  const Document::Entries& entries = document.entries();
  for (auto entry = entries.lower_bound(kFrames); entry != entries.end() && entry->first.starts_with(kFrames);
       ++entry) {
    if (const auto away = take_apart(entry->first, camera)) frames.insert(away->at.frame);
  }
  for (const double frame : frames) {
    const std::string text = number_text(frame + 0.0);
    const std::string old = fmt::format("{}{}/", kFrames, text);
    const std::string folder = folder_of({camera, frame});
    if (document.has(folder + std::string(kStrokes))) {
      document.erase_below(old);
    } else {
      move(document, old, folder);
    }
  }
}

std::uint32_t count_of(std::string_view text) {
  std::uint32_t strokes = 0;
  std::from_chars(text.data(), text.data() + text.size(), strokes);
  return std::max(strokes, 1U);
}

}  // namespace

std::vector<PaintedFrame> painted_frames(const Document& document, const Vantage& present) {
  std::vector<PaintedFrame> painted;
  for (const std::string_view folder : {kCameras, kFrames}) {
    const Document::Entries& entries = document.entries();
    for (auto entry = entries.lower_bound(folder); entry != entries.end() && entry->first.starts_with(folder);
         ++entry) {
      if (!entry->first.ends_with(kStrokes)) continue;
      const auto away = take_apart(entry->first, present.camera);
      if (away && away->rest == kStrokes && away->at != present) painted.push_back({away->at, count_of(entry->second)});
    }
  }
  if (has_paint(document)) painted.push_back({present, count_of(document.get(kStrokes))});
  std::ranges::stable_sort(painted, {}, &PaintedFrame::at);
  const auto twice = std::ranges::unique(painted, {}, &PaintedFrame::at);
  painted.erase(twice.begin(), twice.end());
  return painted;
}

void turn_paint(Document& document, const Vantage& from, const Vantage& to) {
  adopt_frames(document, from.camera);
  const std::string nu(document.get("paint/nu")), delta(document.get("paint/delta"));
  move(document, std::string(kPaint), folder_of(from) + std::string(kPaint));
  move(document, folder_of(to) + std::string(kPaint), std::string(kPaint));
  // What was never painted counts unpainted pixels as the lighter last wanted.
  if (!document.has("paint/nu")) document.set("paint/nu", nu);
  if (!document.has("paint/delta")) document.set("paint/delta", delta);
}

Document at_vantage(const Document& document, const Vantage& present, const Vantage& vantage) {
  Document turned = document;
  if (vantage != present) turn_paint(turned, present, vantage);
  return turned;
}

void put_frame_paint(Document& document, const Vantage& present, const Vantage& vantage, const Document& paint) {
  adopt_frames(document, present.camera);
  const std::string folder = folder_of(vantage);
  document.erase_below(folder + std::string(kPaint));
  for (const auto& [path, value] : paint.entries()) {
    if (path.starts_with(kPaint)) document.set(folder + path, value);
  }
}

bool clear_frame_paint(Document& document, const Vantage& present, const Vantage& vantage) {
  Document cleared = document;
  adopt_frames(cleared, present.camera);
  const std::string folder = folder_of(vantage);
  if (!cleared.has(folder + std::string(kStrokes))) return false;
  std::map<std::string, std::string> kept;
  const Document::Entries& entries = cleared.entries();
  for (auto entry = entries.lower_bound(folder); entry != entries.end() && entry->first.starts_with(folder); ++entry) {
    const std::string_view rest = std::string_view(entry->first).substr(folder.size());
    if (rest == "paint/nu" || rest == "paint/delta" || rest.starts_with("paint/previous/")) kept.insert(*entry);
  }
  cleared.erase_below(folder);
  for (auto& [path, value] : kept) cleared.set(path, std::move(value));
  document = std::move(cleared);
  return true;
}

void forget_paint(Document& document) {
  std::map<std::string, std::string> kept;
  for (const char* path : {"paint/nu", "paint/delta"}) {
    if (const std::string_view value = document.get(path); !value.empty()) kept[path] = value;
  }
  document.erase_below(kPaint);
  for (const auto& [path, value] : kept) document.set(path, value);
  std::vector<std::string> gone;
  for (const auto& [path, value] : document.entries()) {
    if (take_apart(path, {})) gone.push_back(path);
  }
  for (const std::string& path : gone) document.set(path, "");
}

}  // namespace luminist
