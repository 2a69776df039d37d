#pragma once
// base/files.h -- reading whole files, writing them so that a crash leaves the old or the new one, finding assets.
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

/// The whole file. errors kMissing if it is not there, kBadContent if it is not a regular file (a FIFO, a device).
Result<std::string> read_file(const std::filesystem::path& path);

/// Written beside the file, synced, renamed over it, folder synced: an observer sees the old or the new file, whole.
/// errors kUnwritable with the system's reason; the old file is untouched and no temporary stays.
Result<void> write_file_atomic(const std::filesystem::path& path, std::string_view bytes);

/// Makes a folder and its parents. errors kUnwritable.
Result<void> make_folder(const std::filesystem::path& path);

/// 32 hexadecimal digits of XXH3-128: names content, is not cryptographic.
std::string content_hash(std::string_view bytes);

/// Folders in which shaders/, styles/ and meshes/ are looked for, first hit wins: LUMINIST_ROOT, the source tree.
class AssetRoots {
 public:
  static AssetRoots standard();
  explicit AssetRoots(std::vector<std::filesystem::path> roots) : roots_(std::move(roots)) {}
  [[nodiscard]] const std::vector<std::filesystem::path>& folders() const { return roots_; }

  /// The first root that holds the relative path. errors kMissing, naming the roots that were tried.
  [[nodiscard]] Result<std::filesystem::path> find(const std::filesystem::path& relative) const;
  /// Names of the folders or files (with the extension) below a relative folder, sorted, duplicates dropped.
  [[nodiscard]] std::vector<std::string> list(const std::filesystem::path& relative, std::string_view extension) const;

 private:
  std::vector<std::filesystem::path> roots_;
};

/// Where what can be made again is kept: LUMINIST_CACHE if it is set (empty: nothing is kept), else luminist/ below
/// XDG_CACHE_HOME or ~/.cache. It need not exist.
std::filesystem::path cache_folder();

/// Turns a relative reference found inside a file into a path below that file's folder.
/// errors kBadContent for absolute paths, URLs, "..", links that leave the folder; kMissing if nothing is there.
Result<std::filesystem::path> resolve_beside(const std::filesystem::path& file, std::string_view reference);

/// The entry of names that is nearest to word by edit distance, or "" if none is near (at most a third of its length).
std::string nearest_name(std::string_view word, std::span<const std::string> names);

}  // namespace luminist
