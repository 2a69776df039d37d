#include "prep/stroke_mesh.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "base/files.h"
#include "prep/unwrap.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

// Counts changes of what unwrap() makes of a mesh and of the file: files of others are not found.
constexpr std::string_view kVersion = "luminist strokes 3\n";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30U;
constexpr std::size_t kHashLength = 32;

template <class T>
void append(std::string& bytes, const std::vector<T>& values) {
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

std::string bytes_of(const Mesh& mesh) {
  std::string bytes;
  append(bytes, mesh.positions);
  append(bytes, mesh.normals);
  append(bytes, mesh.uvs);
  append(bytes, mesh.tangents);
  append(bytes, mesh.line_widths);
  append(bytes, mesh.triangles);
  return bytes;
}

/// Takes a list off the front. returns false if there are too few bytes.
template <class T>
bool take(std::string_view& bytes, std::vector<T>& values) {
  std::uint64_t count = 0;
  if (bytes.size() < sizeof count) return false;
  std::memcpy(&count, bytes.data(), sizeof count);
  bytes.remove_prefix(sizeof count);
  if (count > bytes.size() / sizeof(T)) return false;
  values.resize(count);
  if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T));
  bytes.remove_prefix(count * sizeof(T));
  return true;
}

/// "version, hash of the rest, the rest".
std::string file_of(const StrokeMesh& made) {
  std::string body = bytes_of(made.mesh);
  append(body, made.strokes);
  return std::string(kVersion) + content_hash(body) + body;
}

bool read_into(std::string_view file, StrokeMesh& made) {
  if (!file.starts_with(kVersion) || file.size() < kVersion.size() + kHashLength) return false;
  file.remove_prefix(kVersion.size());
  const std::string_view hash = file.substr(0, kHashLength);
  file.remove_prefix(kHashLength);
  if (content_hash(file) != hash) return false;
  Mesh& mesh = made.mesh;
  return take(file, mesh.positions) && take(file, mesh.normals) && take(file, mesh.uvs) && take(file, mesh.tangents) &&
         take(file, mesh.line_widths) && take(file, mesh.triangles) && take(file, made.strokes) && file.empty();
}

/// Removes what was made longest ago until the cache is small enough.
void trim(const fs::path& cache) {
  std::error_code error;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::uintmax_t total = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(cache, error)) {
    if (entry.path().extension() != ".strokes") continue;
    total += entry.file_size(error);
    files.emplace_back(entry.last_write_time(error), entry.path());
  }
  std::ranges::sort(files);
  for (const auto& [time, path] : files) {
    if (total <= kMostBytes) return;
    total -= std::min(total, fs::file_size(path, error));
    fs::remove(path, error);
  }
}

}  // namespace

StrokeMesh stroke_mesh(const Mesh& mesh, const fs::path& cache) {
  const fs::path path = cache / (content_hash(std::string(kVersion) + bytes_of(mesh)) + ".strokes");
  StrokeMesh made;
  if (!cache.empty()) {
    const Result<std::string> file = read_file(path);
    if (file && read_into(*file, made)) return made;
  }
  Unwrapped unwrapped = unwrap(mesh);
  made = {std::move(unwrapped.mesh), std::move(unwrapped.strokes)};
  if (!cache.empty() && make_folder(cache) && write_file_atomic(path, file_of(made))) trim(cache);
  return made;
}

}  // namespace luminist
