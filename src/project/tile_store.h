#pragma once
// project/tile_store.h -- pieces of images, named by their content, each written once.
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

/// In memory until it is given a folder. A tile never changes, so undo and redo need no copies and a crash between
/// writing a tile and recording it costs nothing but the file.
class TileStore {
 public:
  TileStore() = default;
  explicit TileStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Stores bytes, unless they are already there. returns their name. errors kUnwritable.
  Result<std::string> put(std::string_view bytes);
  /// The bytes of that name. errors kMissing; kBadContent if they are not what was stored.
  [[nodiscard]] Result<std::string> get(const std::string& name) const;

  /// What was put is on the disk when this returns. errors kUnwritable.
  Result<void> sync();
  /// Every tile also lies in that folder and is on the disk. errors kUnwritable, those of get().
  [[nodiscard]] Result<void> copy_to(const std::filesystem::path& folder) const;

 private:
  [[nodiscard]] std::filesystem::path file_of(const std::string& name) const;

  std::filesystem::path folder_;               ///< empty: in memory
  std::map<std::string, std::string> memory_;  ///< name -> bytes
  std::vector<std::filesystem::path> unsynced_;
};

}  // namespace luminist
