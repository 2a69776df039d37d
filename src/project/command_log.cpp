#include "project/command_log.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {
namespace {

constexpr std::string_view kHead = R"({"hash":")";
constexpr std::string_view kMiddle = R"(","record":)";
constexpr std::size_t kSealDigits = 16;
constexpr std::size_t kRecordStart = kHead.size() + kSealDigits + kMiddle.size();
constexpr std::chrono::seconds kSyncInterval{2};

std::string seal_of(const std::string& previous, std::string_view record) {
  std::string sealed = previous;
  sealed.append(record);
  return content_hash(sealed).substr(0, kSealDigits);
}

Error unwritable(const std::filesystem::path& path, const char* doing) {
  return {ErrorKind::kUnwritable, fmt::format("cannot {}: {}", doing, std::strerror(errno)), path.string(), "",
          "free some space or save to another place; nothing recorded so far is lost"};
}

/// The record inside a line (without its line break), or nothing if the line is not one that follows `previous`.
std::string_view record_in(std::string_view line, const std::string& previous) {
  if (line.size() <= kRecordStart + 1 || !line.starts_with(kHead) || !line.ends_with('}')) return {};
  if (line.substr(kHead.size() + kSealDigits, kMiddle.size()) != kMiddle) return {};
  const std::string_view record = line.substr(kRecordStart, line.size() - kRecordStart - 1);
  return seal_of(previous, record) == line.substr(kHead.size(), kSealDigits) ? record : std::string_view{};
}

}  // namespace

CommandLog::CommandLog(CommandLog&& other) noexcept {
  *this = std::move(other);
}

CommandLog& CommandLog::operator=(CommandLog&& other) noexcept {
  if (this == &other) return *this;
  if (fd_ >= 0) ::close(fd_);
  path_ = std::move(other.path_);
  fd_ = std::exchange(other.fd_, -1);
  memory_ = std::move(other.memory_);
  end_ = other.end_;
  records_ = std::move(other.records_);
  seals_ = std::move(other.seals_);
  torn_bytes_ = other.torn_bytes_;
  unsynced_ = other.unsynced_;
  synced_ = other.synced_;
  return *this;
}

CommandLog::~CommandLog() {
  if (fd_ >= 0) ::close(fd_);
}

Result<CommandLog> CommandLog::open(const std::filesystem::path& path, Access access) {
  LUM_TRY(const std::string bytes, read_file(path));
  CommandLog log;
  log.path_ = path;
  LUM_TRY_VOID(log.load(bytes));
  const bool writing = access == Access::kWrite;
  log.fd_ = ::open(path.c_str(), (writing ? O_RDWR : O_RDONLY) | O_CLOEXEC);
  if (log.fd_ < 0) return unwritable(path, "open");
  if (writing && log.torn_bytes_ > 0 && ::ftruncate(log.fd_, static_cast<off_t>(log.end_)) != 0) {
    return unwritable(path, "cut off a torn line");
  }
  log.synced_ = std::chrono::steady_clock::now();
  return log;
}

Result<void> CommandLog::load(const std::string& bytes) {
  std::size_t start = 0;
  while (start < bytes.size()) {
    const std::size_t line_end = bytes.find('\n', start);
    const bool last = line_end == std::string::npos || line_end + 1 == bytes.size();
    const std::string_view line =
        std::string_view(bytes).substr(start, (line_end == std::string::npos ? bytes.size() : line_end) - start);
    const std::string_view record = line_end == std::string::npos ? "" : record_in(line, seal(size()));
    if (record.empty() && last) break;
    if (record.empty()) {
      return Error{ErrorKind::kBadContent, "a line does not match its hash: it was changed, dropped or moved",
                   fmt::format("{}:{}", path_.string(), size() + 1), "hash",
                   fmt::format("the {} lines before it are intact; restore the file from a copy", size())};
    }
    records_.push_back({start + kRecordStart, record.size()});
    seals_.emplace_back(line.substr(kHead.size(), kSealDigits));
    start = line_end + 1;
  }
  end_ = start;
  torn_bytes_ = bytes.size() - start;
  return {};
}

Result<void> CommandLog::check_unchanged() const {
  struct stat ours {};
  struct stat theirs {};
  const bool same = ::fstat(fd_, &ours) == 0 && ::stat(path_.c_str(), &theirs) == 0 && ours.st_ino == theirs.st_ino &&
                    ours.st_dev == theirs.st_dev && static_cast<std::uint64_t>(ours.st_size) == end_;
  if (same) return {};
  return Error{ErrorKind::kProject, "the log was changed by another program while it was open", path_.string(), "",
               "save under another name"};
}

Result<void> CommandLog::write_line(std::string_view line) {
  std::size_t done = 0;
  while (done < line.size()) {
    const ssize_t written = ::pwrite(fd_, line.data() + done, line.size() - done, static_cast<off_t>(end_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return unwritable(path_, "write");
    done += static_cast<std::size_t>(written);
  }
  return {};
}

Result<void> CommandLog::append(std::string_view record) {
  std::string line(kHead);
  const std::string sealed = seal_of(seal(size()), record);
  line.append(sealed).append(kMiddle).append(record).append("}\n");
  if (fd_ < 0) {
    memory_ += line;
  } else {
    LUM_TRY_VOID(check_unchanged());
    unsynced_ = true;
    auto written = write_line(line);
    if (written && sync_due()) written = sync_data();
    if (!written) {
      // If the cut fails too, a torn last line stays, which the next open drops.
      if (::ftruncate(fd_, static_cast<off_t>(end_)) != 0) return unwritable(path_, "take back a torn line");
      return written;
    }
  }
  records_.push_back({end_ + kRecordStart, record.size()});
  seals_.push_back(sealed);
  end_ += line.size();
  return {};
}

Result<void> CommandLog::sync_data() {
  if (::fdatasync(fd_) != 0) return unwritable(path_, "sync");
  unsynced_ = false;
  synced_ = std::chrono::steady_clock::now();
  return {};
}

Result<void> CommandLog::sync() {
  if (fd_ < 0) return {};
  LUM_TRY_VOID(check_unchanged());
  return sync_data();
}

bool CommandLog::sync_due() const {
  return std::chrono::steady_clock::now() - synced_ >= kSyncInterval;
}

Result<std::string> CommandLog::read(std::size_t record) const {
  const Span& span = records_[record];
  if (fd_ < 0) return memory_.substr(span.offset, span.length);
  std::string text(span.length, '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t got = ::pread(fd_, text.data() + done, text.size() - done, static_cast<off_t>(span.offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  if (done == text.size() && seal_of(seal(record), text) == seals_[record]) return text;
  return Error{ErrorKind::kBadContent, "a line was changed while the project was open",
               fmt::format("{}:{}", path_.string(), record + 1), "", "save under another name"};
}

Result<void> CommandLog::write_to(const std::filesystem::path& path) const {
  if (fd_ < 0) return write_file_atomic(path, memory_);
  LUM_TRY(std::string bytes, read_file(path_));
  bytes.resize(end_);
  return write_file_atomic(path, bytes);
}

}  // namespace luminist
