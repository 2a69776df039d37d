#pragma once
// project/command_log.h -- an append-only file of JSON records, one a line, each sealed by a hash.
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace luminist {

/// {"hash":"0123456789abcdef","record":{...}}
///
/// The hash covers the record's text and the hash of the line before it, so a line that was changed, dropped or moved
/// is found. A crash can only tear the last line; it is dropped when the log is opened. Damage further up is refused.
/// The same class keeps the log of a shot that was never saved, in memory.
class CommandLog {
 public:
  enum class Access { kRead, kWrite };
  /// Where a record's text lies.
  struct Span {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
  };

  /// A log in memory; it becomes a file by write_to().
  CommandLog() = default;
  /// Reads and checks the whole file; with kWrite a torn last line is cut off.
  /// errors kMissing, kBadContent at path:line for damage before the last line, kUnwritable.
  static Result<CommandLog> open(const std::filesystem::path& path, Access access);

  CommandLog(CommandLog&& other) noexcept;
  CommandLog& operator=(CommandLog&& other) noexcept;
  ~CommandLog();

  /// Adds a record (one JSON value without line breaks) and hands it to the system; synced at the latest by the first
  /// append two seconds after the last sync. errors kUnwritable: nothing was added then. kProject: changed by others.
  Result<void> append(std::string_view record);
  /// What was appended is on the disk when this returns. errors kUnwritable, kProject.
  Result<void> sync();
  /// Whether the last sync is two seconds ago: the next append would sync.
  [[nodiscard]] bool sync_due() const;
  [[nodiscard]] bool unsynced() const { return unsynced_; }

  [[nodiscard]] std::size_t size() const { return records_.size(); }
  /// A record's text. errors kBadContent if the file changed under us.
  [[nodiscard]] Result<std::string> read(std::size_t record) const;
  /// The hash of the first count records; "" of none.
  [[nodiscard]] std::string seal(std::size_t count) const { return count == 0 ? "" : seals_[count - 1]; }
  /// Bytes of a torn last line that was found when the log was opened.
  [[nodiscard]] std::size_t torn_bytes() const { return torn_bytes_; }

  /// The whole log as one file, old or new, never half. errors kUnwritable.
  [[nodiscard]] Result<void> write_to(const std::filesystem::path& path) const;

 private:
  Result<void> load(const std::string& bytes);
  [[nodiscard]] Result<void> check_unchanged() const;
  Result<void> write_line(std::string_view line);
  Result<void> sync_data();

  std::filesystem::path path_;
  int fd_ = -1;            ///< -1: in memory
  std::string memory_;     ///< the bytes, if there is no file
  std::uint64_t end_ = 0;  ///< length of the intact lines
  std::vector<Span> records_;
  std::vector<std::string> seals_;
  std::size_t torn_bytes_ = 0;
  bool unsynced_ = false;
  std::chrono::steady_clock::time_point synced_;
};

}  // namespace luminist
