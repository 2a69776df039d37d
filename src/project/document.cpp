#include "project/document.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {

std::string_view Document::get(std::string_view path) const {
  const auto entry = entries_.find(path);
  return entry == entries_.end() ? std::string_view{} : std::string_view(entry->second);
}

void Document::set(std::string_view path, std::string value) {
  const auto entry = entries_.lower_bound(path);
  const bool there = entry != entries_.end() && entry->first == path;
  if (value.empty()) {
    if (there) entries_.erase(entry);
  } else if (there) {
    entry->second = std::move(value);
  } else {
    entries_.emplace_hint(entry, path, std::move(value));
  }
}

void Document::erase_below(std::string_view prefix) {
  const auto first = entries_.lower_bound(prefix);
  auto last = first;
  while (last != entries_.end() && last->first.starts_with(prefix)) ++last;
  entries_.erase(first, last);
}

Result<void> Document::apply(std::span<const Edit> edits) {
  for (const Edit& edit : edits) {
    if (get(edit.path) == edit.before) continue;
    return Error{ErrorKind::kBadContent, "the recorded value before an edit is not the document's", "", edit.path,
                 fmt::format("recorded {}, found {}", edit.before.empty() ? "nothing" : edit.before,
                             has(edit.path) ? get(edit.path) : "nothing")};
  }
  for (const Edit& edit : edits) set(edit.path, edit.after);
  return {};
}

std::string Document::hash() const {
  std::string all;
  for (const auto& [path, value] : entries_) {
    all.append(path).push_back('\0');
    all.append(value).push_back('\0');
  }
  return content_hash(all);
}

std::vector<Edit> difference(const Document& from, const Document& to) {
  std::vector<Edit> edits;
  auto old_entry = from.entries().begin();
  auto new_entry = to.entries().begin();
  const auto old_end = from.entries().end();
  const auto new_end = to.entries().end();
  while (old_entry != old_end || new_entry != new_end) {
    if (new_entry == new_end || (old_entry != old_end && old_entry->first < new_entry->first)) {
      edits.push_back({old_entry->first, old_entry->second, ""});
      ++old_entry;
    } else if (old_entry == old_end || new_entry->first < old_entry->first) {
      edits.push_back({new_entry->first, "", new_entry->second});
      ++new_entry;
    } else {
      if (old_entry->second != new_entry->second) {
        edits.push_back({old_entry->first, old_entry->second, new_entry->second});
      }
      ++old_entry, ++new_entry;
    }
  }
  return edits;
}

std::vector<Edit> reversed(std::span<const Edit> edits) {
  std::vector<Edit> result;
  result.reserve(edits.size());
  for (const Edit& edit : edits) result.push_back({edit.path, edit.after, edit.before});
  std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace luminist
