#pragma once
// cli/task_words.h -- what is wanted and who may change for it: [--paint P | --target T [--importance I]]
// [--add-light N] [--unlock PATTERN]... [--lock PATTERN]... [--seconds S]
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/shot_words.h"
#include "cli/verb.h"
#include "studio/session.h"

namespace CLI {
class Option;
}

namespace luminist {

/// What is to be seen, as it was typed.
struct PaintWords {
  std::string strokes;
  std::string target;
  std::string importance;
  int new_lights = 0;
  NewLight light;
  bool shares_lights = false;  ///< of another session: none are added, and words about those it adds are passed over
};
void declare_paint_words(CLI::App& app, PaintWords& words);
/// errors kUsage for words that do not go together. Costs nothing, so it comes before anything is loaded.
Result<void> check_paint_words(const PaintWords& words);
/// Paints, or takes the picture as target. errors those of the files and of Session.
Result<void> put_target(Session& session, const PaintWords& words, const AssetRoots& roots);
/// Adds the lights that were asked for; where their kind is to be found, says what each came to.
Result<void> add_new_lights(Session& session, const PaintWords& words, VerbContext& context);

/// --lock and --unlock, as they were typed and in the order in which they were mixed:
/// "--lock '*' --unlock lights/key/color" frees that colour only.
struct LockWords {
  std::vector<std::string> unlock;
  std::vector<std::string> lock;
  std::vector<std::pair<std::string, bool>> ordered;
};
void declare_lock_words(CLI::App& app, LockWords& words);
/// Fills `ordered` once the words were parsed.
void note_lock_order(const CLI::App& app, LockWords& words);
Result<void> apply_locks(Session& session, const LockWords& words);

/// Links lights as --link says.
Result<void> link_all(Session& session, const std::vector<std::string>& words);

/// A session on a shot with the paint, new lights, links, constraints and locks that were typed; paint may be null.
/// Warnings are shown also where something goes wrong. device and diagnostics outlive the session. errors those of all
/// these.
Result<std::unique_ptr<Session>> open_task(Device& device, const Shot& shot, const PaintWords* paint,
                                           const ShotWords& words, const LockWords& locks, VerbContext& context,
                                           Diagnostics& diagnostics);

CLI::Option* declare_seconds(CLI::App& app, std::optional<double>& seconds, const std::string& doc);
/// The checks of CLI11 let "nan" and "inf" through, and "-1" wrap around to a large whole number.
void require_above_zero(CLI::Option& option);
void require_from_zero(CLI::Option& option);

/// Whether to go on: false after a stop signal, or after so many seconds from its making.
class Deadline {
 public:
  Deadline(const StopSignals& signals, std::optional<double> seconds) : signals_(&signals), seconds_(seconds) {}
  [[nodiscard]] bool go_on() const;

 private:
  const StopSignals* signals_;
  std::optional<double> seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace luminist
