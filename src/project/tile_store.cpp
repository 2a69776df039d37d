#include "project/tile_store.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

Error unwritable(const fs::path& path, const char* doing, int error_number) {
  return {ErrorKind::kUnwritable, fmt::format("cannot {} a tile: {}", doing, std::strerror(error_number)),
          path.string(), "", "free some space or save to another place"};
}

/// Whole or not at all, but not synced: sync() does that for many at once.
Result<void> write_tile(const fs::path& path, std::string_view bytes) {
  LUM_TRY_VOID(make_folder(path.parent_path()));
  const fs::path temporary = path.parent_path() / fmt::format(".lum-{}-{}", ::getpid(), path.filename().string());
  errno = 0;
  std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  std::error_code error;
  if (file) fs::rename(temporary, path, error);
  if (file && !error) return {};
  const int reason = error ? error.value() : errno;
  fs::remove(temporary, error);
  return unwritable(path, "write", reason);
}

Result<void> sync_path(const fs::path& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return unwritable(path, "open", errno);
  const int status = ::fsync(fd);
  const int reason = errno;
  ::close(fd);
  if (status != 0 && reason != EINVAL) return unwritable(path, "sync", reason);  // EINVAL: cannot sync this kind
  return {};
}

}  // namespace

fs::path TileStore::file_of(const std::string& name) const {
  return folder_ / name.substr(0, 2) / name.substr(std::min<std::size_t>(2, name.size()));
}

Result<std::string> TileStore::put(std::string_view bytes) {
  std::string name = content_hash(bytes);
  if (folder_.empty()) {
    memory_.try_emplace(name, bytes);
    return name;
  }
  const fs::path path = file_of(name);
  std::error_code error;
  // A power cut can leave a name with a short file behind it; such a tile is written again.
  if (fs::file_size(path, error) == bytes.size() && !error) return name;
  LUM_TRY_VOID(write_tile(path, bytes));
  unsynced_.push_back(path);
  return name;
}

Result<std::string> TileStore::get(const std::string& name) const {
  if (folder_.empty()) {
    const auto tile = memory_.find(name);
    if (tile != memory_.end()) return tile->second;
    return Error{ErrorKind::kMissing, "a tile of the paint is not there", name, "", ""};
  }
  LUM_TRY(std::string bytes, read_file(file_of(name)));
  if (content_hash(bytes) == name) return bytes;
  return Error{ErrorKind::kBadContent, "a tile of the paint is damaged", file_of(name).string(), "",
               "restore it from a copy, or undo the paint"};
}

Result<void> TileStore::sync() {
  std::set<fs::path> folders;
  for (const fs::path& path : unsynced_) {
    LUM_TRY_VOID(sync_path(path));
    folders.insert(path.parent_path());
  }
  if (!folders.empty()) folders.insert(folder_);
  for (const fs::path& folder : folders) LUM_TRY_VOID(sync_path(folder));
  unsynced_.clear();
  return {};
}

Result<void> TileStore::copy_to(const fs::path& folder) const {
  TileStore copy(folder);
  LUM_TRY_VOID(make_folder(folder));
  for (const auto& [name, bytes] : memory_) LUM_TRY_VOID(copy.put(bytes));
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder_, error), end; !folder_.empty() && !error && entry != end;
       entry.increment(error)) {
    if (!entry->is_regular_file() || entry->path().filename().string().starts_with('.')) continue;
    LUM_TRY(const std::string bytes, read_file(entry->path()));
    LUM_TRY_VOID(copy.put(bytes));
  }
  return copy.sync();
}

}  // namespace luminist
