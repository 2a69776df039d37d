#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "base/descriptor.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

Error unwritable(const fs::path& path, const char* doing, int error_number) {
  return {ErrorKind::kUnwritable, fmt::format("cannot {}: {}", doing, std::strerror(error_number)), path.string(), "",
          "choose another place, or free some space"};
}

Result<void> write_all(Descriptor& file, std::string_view bytes, const fs::path& path) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return unwritable(path, "write", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fsync(file.get()) != 0) return unwritable(path, "sync", errno);
  if (file.close_now() != 0) return unwritable(path, "close", errno);
  return {};
}

}  // namespace

Result<std::string> read_file(const fs::path& path) {
  // O_NONBLOCK lets a FIFO be opened without waiting for a writer, so that it can be refused.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!file.open()) {
    return Error{ErrorKind::kMissing, fmt::format("cannot read: {}", std::strerror(errno)), path.string(), "", ""};
  }
  struct stat status {};
  if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) {
    return Error{ErrorKind::kBadContent, "not a regular file", path.string(), "", "give the path of a file"};
  }
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::read(file.get(), bytes.data() + done, bytes.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      return Error{ErrorKind::kBadContent, fmt::format("cannot read: {}", std::strerror(errno)), path.string(), "", ""};
    }
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

Result<void> write_file_atomic(const fs::path& path, std::string_view bytes) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  // The name is short so that a 255-byte file name still has a temporary neighbour.
  const fs::path temporary = folder / fmt::format(".lum-{}-{}", ::getpid(), content_hash(path.string()).substr(0, 8));
  Result<void> written;
  {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
    if (!file.open()) return unwritable(path, "create", errno);
    written = write_all(file, bytes, path);
  }
  if (written && ::rename(temporary.c_str(), path.c_str()) != 0) written = unwritable(path, "rename", errno);
  if (!written) {
    ::unlink(temporary.c_str());
    return written;
  }
  Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.open()) ::fsync(directory.get());  // some file systems refuse to sync a folder; the rename stands
  return {};
}

Result<void> make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) return unwritable(path, "create the folder", error.value());
  return {};
}

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

fs::path cache_folder() {
  if (const char* chosen = std::getenv("LUMINIST_CACHE")) return chosen;
  if (const char* caches = std::getenv("XDG_CACHE_HOME"); caches != nullptr && *caches == '/') {
    return fs::path(caches) / "luminist";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".cache/luminist";
  return {};
}

AssetRoots AssetRoots::standard() {
  std::vector<fs::path> roots;
  if (const char* root = std::getenv("LUMINIST_ROOT")) roots.emplace_back(root);
  roots.emplace_back(LUMINIST_SOURCE_DIR);
  return AssetRoots(std::move(roots));
}

Result<fs::path> AssetRoots::find(const fs::path& relative) const {
  std::string tried;
  for (const fs::path& root : roots_) {
    std::error_code error;
    if (fs::exists(root / relative, error)) return root / relative;
    tried += (tried.empty() ? "" : ", ") + root.string();
  }
  return Error{ErrorKind::kMissing, "not found below " + tried, relative.string(), "", "set LUMINIST_ROOT"};
}

std::vector<std::string> AssetRoots::list(const fs::path& relative, std::string_view extension) const {
  std::set<std::string> names;
  for (const fs::path& root : roots_) {
    std::error_code error;
    for (fs::directory_iterator entry(root / relative, error), end; !error && entry != end; entry.increment(error)) {
      const bool wanted = extension.empty() ? entry->is_directory() : entry->path().extension() == extension;
      if (wanted) names.insert(entry->path().filename().string());
    }
  }
  return {names.begin(), names.end()};
}

Result<fs::path> resolve_beside(const fs::path& file, std::string_view reference) {
  const Error outside{ErrorKind::kBadContent, fmt::format("the reference \"{}\" leaves the file's folder", reference),
                      file.string(), "", "copy what it names beside the file"};
  const fs::path relative(reference);
  if (relative.empty() || relative.is_absolute() || reference.find(':') != std::string_view::npos) return outside;
  for (const fs::path& part : relative) {
    if (part == "..") return outside;
  }
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(file.has_parent_path() ? file.parent_path() : fs::path("."), error);
  const fs::path target = fs::canonical(folder / relative, error);
  if (error) {
    return Error{ErrorKind::kMissing, fmt::format("it refers to \"{}\", which is not there", reference), file.string(),
                 "", "restore the file or remove the reference"};
  }
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), target.begin(), target.end());
  if (end != folder.end()) return outside;
  return target;
}

std::string nearest_name(std::string_view word, std::span<const std::string> names) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(1, (word.size() + 2) / 3) + 1;
  for (const std::string& name : names) {
    std::vector<std::size_t> row(name.size() + 1);
    for (std::size_t j = 0; j <= name.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= word.size(); ++i) {
      std::size_t diagonal = row[0];
      row[0] = i;
      for (std::size_t j = 1; j <= name.size(); ++j) {
        const std::size_t substitute = diagonal + (word[i - 1] == name[j - 1] ? 0 : 1);
        diagonal = row[j];
        row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
      }
    }
    if (row.back() < best_distance) best_distance = row.back(), best = name;
  }
  return best;
}

}  // namespace luminist
