#include "image_io/dialogue.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

namespace luminist {
namespace {

namespace fs = std::filesystem;

/// LUMINIST_IMAGE_HELPER, or the helper beside the running executable. errors kChild.
Result<std::string> helper_path() {
  if (const char* given = std::getenv("LUMINIST_IMAGE_HELPER")) return std::string(given);
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path() / "luminist-image";
  if (fs::exists(beside, error)) return beside.string();
  return Error{ErrorKind::kChild, "the helper that reads and writes images is missing", beside.string(), "",
               "reinstall, or set LUMINIST_IMAGE_HELPER"};
}

/// Assembles answers from the helper's output as it arrives, in pieces of any size. Sizes are checked before memory is
/// taken: the helper may have been taken over by the file it read.
class AnswerStream {
 public:
  void take(std::string_view bytes) {
    while (!bytes.empty() && !broken_) {
      if (filled_ < sizeof(PacketHeader)) {
        copy(bytes, reinterpret_cast<char*>(&answer_.header), sizeof(PacketHeader), 0);
        if (filled_ == sizeof(PacketHeader)) begin();
      } else if (filled_ < sizeof(PacketHeader) + answer_.text.size()) {
        copy(bytes, answer_.text.data(), answer_.text.size(), sizeof(PacketHeader));
      } else {
        copy(bytes, answer_.data.data(), answer_.data.size(), sizeof(PacketHeader) + answer_.text.size());
      }
      finish_if_complete();
    }
  }
  [[nodiscard]] std::vector<Answer>& complete() { return complete_; }
  /// Between two answers, and what came made sense.
  [[nodiscard]] bool clean() const { return !broken_ && filled_ == 0; }
  [[nodiscard]] bool broken() const { return broken_; }

 private:
  void copy(std::string_view& bytes, char* to, std::size_t size, std::size_t start) {
    const std::size_t count = std::min(bytes.size(), start + size - filled_);
    std::memcpy(to + (filled_ - start), bytes.data(), count);
    filled_ += count;
    bytes.remove_prefix(count);
  }
  void begin() {
    const PacketHeader& h = answer_.header;
    constexpr std::uint64_t kMostText = 1U << 16U;
    broken_ = h.magic != kPacketMagic || h.text_size > kMostText || h.data_size > kMostFileBytes;
    if (broken_) return;
    answer_.text.resize(h.text_size);
    answer_.data.resize(h.data_size);
  }
  void finish_if_complete() {
    if (broken_ || filled_ < sizeof(PacketHeader)) return;
    if (filled_ < sizeof(PacketHeader) + answer_.text.size() + answer_.data.size()) return;
    complete_.push_back(std::move(answer_));
    answer_ = {};
    filled_ = 0;
  }

  Answer answer_;
  std::size_t filled_ = 0;
  bool broken_ = false;
  std::vector<Answer> complete_;
};

/// A helper that was started from a path.
struct Helper {
  std::string path;
  ChildProcess process;
};

/// Helpers between two runs. They end by themselves if they wait for long; the one that waited least is taken first.
class IdleHelpers {
 public:
  std::optional<Helper> take(const std::string& path) {
    std::vector<Helper> gone;  // their end is waited for without the lock
    const std::lock_guard lock(mutex_);
    put_away_dead(gone);
    for (auto each = helpers_.rbegin(); each != helpers_.rend(); ++each) {
      if (each->path != path) continue;
      std::optional<Helper> helper(std::move(*each));
      helpers_.erase(std::next(each).base());
      return helper;
    }
    return std::nullopt;
  }
  void give(Helper helper) {
    std::vector<Helper> gone;
    const std::lock_guard lock(mutex_);
    put_away_dead(gone);
    helpers_.push_back(std::move(helper));
    if (helpers_.size() <= kMostIdle) return;
    gone.push_back(std::move(helpers_.front()));
    helpers_.erase(helpers_.begin());
  }

 private:
  static constexpr std::size_t kMostIdle = 2;

  void put_away_dead(std::vector<Helper>& gone) {
    const auto dead = std::stable_partition(helpers_.begin(), helpers_.end(),
                                            [](const Helper& each) { return each.process.waits(); });
    std::move(dead, helpers_.end(), std::back_inserter(gone));
    helpers_.erase(dead, helpers_.end());
  }

  std::mutex mutex_;
  std::vector<Helper> helpers_;
};

IdleHelpers& idle_helpers() {
  static IdleHelpers helpers;
  return helpers;
}

/// One run with this helper, which waits for another one if it answered everything.
Dialogue talk(Helper helper, const std::vector<std::string_view>& input, std::size_t questions) {
  AnswerStream stream;
  const auto enough = [&](std::string_view bytes) {
    stream.take(bytes);
    return stream.broken() || stream.complete().size() >= questions;
  };
  constexpr std::chrono::seconds kSilence{kSecondsEach};
  const bool all =
      helper.process.ask(input, enough, kSilence) && stream.clean() && stream.complete().size() == questions;
  Dialogue dialogue{std::move(stream.complete())};
  if (all) {
    idle_helpers().give(std::move(helper));
  } else {
    constexpr std::chrono::seconds kToLeave{1};  // from one that talks nonsense there is nothing more to learn
    dialogue.end = helper.process.end(stream.broken() ? kToLeave : kSilence);
  }
  return dialogue;
}

}  // namespace

Result<Dialogue> ask_helper(std::span<Question> questions) {
  LUM_TRY(const std::string path, helper_path());
  std::vector<std::string_view> input;
  const auto add_header = [&](const PacketHeader& header) {
    input.emplace_back(reinterpret_cast<const char*>(&header), sizeof(header));
  };
  for (Question& each : questions) {
    each.header.status = static_cast<std::uint32_t>(each.task);
    each.header.text_size = each.text.size(), each.header.data_size = each.data.size();
    add_header(each.header);
    input.push_back(each.text);
    input.push_back(each.data);
  }
  PacketHeader last;
  last.status = static_cast<std::uint32_t>(HelperTask::kEndOfRun);
  add_header(last);
  if (std::optional<Helper> waiting = idle_helpers().take(path)) {
    Dialogue dialogue = talk(std::move(*waiting), input, questions.size());
    const bool too_slow = dialogue.end.timed_out || dialogue.end.signal == SIGALRM;
    if (!dialogue.answers.empty() || too_slow) return dialogue;
  }  // it may have ended just now, for want of work
  LUM_TRY(ChildProcess process, ChildProcess::start({path, kServeWord}));
  return talk({path, std::move(process)}, input, questions.size());
}

}  // namespace luminist
