#pragma once
// studio/studio_thread.h -- a workbench on a thread of its own, so that a window never waits for a picture.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "studio/frame_strip.h"
#include "studio/workbench.h"

namespace luminist {

/// Something that the lighter should read.
struct StudioMessage {
  enum class Kind { kNote, kWarning, kError };
  Kind kind = Kind::kNote;
  std::string text;   ///< one sentence without a full stop
  std::string where;  ///< file:line:column, or empty
  std::string hint;   ///< what to do about it, or empty
};

/// Takes jobs in order, answers with snapshots. What a hand does meanwhile is gathered: points of one stroke become
/// one event, previews that were overtaken are left out. What goes on by itself (lights that follow, a solve) runs in
/// slices between the jobs.
///
/// A lost context, or an exception, ends the device; another one is made and the session is opened again from its log.
/// thread: all calls may come from the window's; tasks run on the other one.
class StudioThread {
 public:
  using Job = std::function<Result<void>(Workbench&)>;
  struct Options {
    AssetRoots roots;
    std::filesystem::path unsaved;         ///< below it are kept sessions without a name
    std::function<void()> on_change = {};  ///< called on the other thread: there is something new to look at
    std::function<Result<Device>()> make_device = {};  ///< called on the other thread; empty: Device::create_headless()
    std::chrono::milliseconds slice{30};
  };
  explicit StudioThread(Options options);
  /// Lets the job that runs come to its end; those that wait are dropped.
  ~StudioThread();
  StudioThread(const StudioThread&) = delete;
  StudioThread& operator=(const StudioThread&) = delete;

  /// label says what is done, for a line that tells what keeps the lighter waiting.
  void post(std::string label, Job job);
  /// What can wait, as what only the window wants to see: nothing that is under way is given up for it.
  void post_patiently(std::string label, Job job);
  void act(std::string label, Workbench::Task task, Workbench::After after = Workbench::After::kStay);
  void act_patiently(std::string label, Workbench::Task task);
  /// What a held key asks for faster than pictures are made: not every one between is shown.
  void act_in_series(std::string label, Workbench::Task task, Workbench::After after);
  void change(std::string label, Workbench::Task task, Workbench::After after = Workbench::After::kStay);
  void repaint(std::string label, Workbench::Task task);
  void begin_stroke(Stroke stroke, std::filesystem::path folder);
  void extend_stroke(std::vector<StrokePoint> points);
  void end_stroke();
  void preview(std::vector<std::string> assignments);
  /// Shows a quick picture of another frame while a hand drags through time; those that were overtaken are left out.
  void preview_frame(double frame);
  /// Goes there, in place of any preview that waits; lights of a proposal come in force first. The same frame: only the
  /// preview ends.
  void go_to(double frame);
  /// Small pictures around the present frame, made when there is nothing else to do. 0: none.
  void want_strip(int pictures, int step);
  /// Ends what runs: a solve keeps its best; a task that asks cancelled() comes to its end.
  void cancel();
  [[nodiscard]] bool cancelled() const { return cancels_ > 0; }
  /// What the job that runs is at, in place of its label. returns whether to go on.
  bool progress(std::string label);
  /// Nobody waits and nothing is cancelled: a job that may as well be done later goes on.
  [[nodiscard]] bool undisturbed() const;
  /// What the job that runs has found so far: picture and lights of the latest snapshot, until there is another.
  void show(std::shared_ptr<const Image> picture, std::shared_ptr<const ParamState> lights);

  /// Never null.
  [[nodiscard]] std::shared_ptr<const StudioSnapshot> latest() const;
  struct Activity {
    std::string label;     ///< of the job that runs; empty: none
    double seconds = 0.0;  ///< so long already
    std::size_t waiting = 0;
  };
  [[nodiscard]] Activity activity() const;
  [[nodiscard]] std::vector<StudioMessage> take_messages();
  void tell(StudioMessage message);
  /// Where the log of the present session is; "" while there is none.
  [[nodiscard]] std::filesystem::path folder() const { return latest()->history.folder; }

 private:
  struct Entry {
    enum class Kind { kJob, kExtend, kPreview, kFrame };
    Kind kind = Kind::kJob;
    std::string label = {};
    Job job = {};
    std::vector<StrokePoint> points = {};
    std::vector<std::string> assignments = {};
    double frame = 0.0;
    bool patient = false;
    bool in_series = false;
  };
  using Clock = std::chrono::steady_clock;

  void push(Entry entry);
  void run();
  bool open_device();
  void reopen(const std::string& why);
  bool take(Entry& entry, bool more);
  [[nodiscard]] bool series_goes_on() const;
  void work(Entry entry);
  void attend(const Result<void>& result);
  bool step();
  bool idle();
  Result<bool> draw_frame();
  void publish();

  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Entry> queue_;
  std::string doing_;
  Clock::time_point since_;
  std::vector<StudioMessage> messages_;
  std::shared_ptr<const StudioSnapshot> latest_;
  bool ending_ = false;
  std::atomic<int> cancels_ = 0;  ///< asked for and not carried out yet

  // Of the other thread.
  std::unique_ptr<Device> device_;
  std::unique_ptr<Workbench> bench_;
  std::unique_ptr<FrameStrip> frames_;
  int reopened_ = 0;  ///< times in a row without a job that went well
  Clock::time_point published_;
  Clock::time_point trimmed_;
  bool worked_ = false;  ///< since memory was given back
  std::thread thread_;
};

}  // namespace luminist
