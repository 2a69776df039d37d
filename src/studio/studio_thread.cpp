#include "studio/studio_thread.h"

#include <malloc.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr int kTriesToReopen = 3;
constexpr std::chrono::milliseconds kBetweenSnapshots{40};  // of what goes on by itself
constexpr std::chrono::milliseconds kBetweenSights{100};    // of a series that goes on
constexpr std::chrono::seconds kBetweenTrims{10};

/// Pictures come and go by the dozen; what they leave between what stays goes back to the system. cost milliseconds.
void give_memory_back() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

StudioThread::Job with_session(StudioThread::Job job) {
  return [job = std::move(job)](Workbench& bench) { return bench.has_session() ? job(bench) : Result<void>(); };
}

StudioThread::Job action(Workbench::Task task, Workbench::After after) {
  return with_session([task = std::move(task), after](Workbench& bench) { return bench.act(task, after); });
}

StudioMessage message_of(const Error& error) {
  StudioMessage message;
  message.kind = error.kind == ErrorKind::kNothingToDo || error.kind == ErrorKind::kCancelled
                     ? StudioMessage::Kind::kNote
                     : StudioMessage::Kind::kError;
  message.text = error.field.empty() ? error.what : error.what + " (" + error.field + ")";
  message.where = error.where;
  message.hint = error.hint;
  return message;
}

}  // namespace

StudioThread::StudioThread(Options options)
    : options_(std::move(options)), latest_(std::make_shared<const StudioSnapshot>()) {
  thread_ = std::thread([this] { run(); });
}

StudioThread::~StudioThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  ++cancels_;
  wake_.notify_one();
  thread_.join();
}

void StudioThread::push(Entry entry) {
  {
    const std::lock_guard lock(mutex_);
    if (entry.kind != Entry::Kind::kJob && !queue_.empty() && queue_.back().kind == entry.kind) {
      Entry& last = queue_.back();  // overtaken, but for what the hand drew
      last.assignments = std::move(entry.assignments);
      last.frame = entry.frame;
      last.points.insert(last.points.end(), entry.points.begin(), entry.points.end());
      return;
    }
    queue_.push_back(std::move(entry));
  }
  wake_.notify_one();
}

void StudioThread::post(std::string label, Job job) {
  push({.label = std::move(label), .job = std::move(job)});
}

void StudioThread::post_patiently(std::string label, Job job) {
  push({.label = std::move(label), .job = std::move(job), .patient = true});
}

void StudioThread::act(std::string label, Workbench::Task task, Workbench::After after) {
  post(std::move(label), action(std::move(task), after));
}

void StudioThread::act_patiently(std::string label, Workbench::Task task) {
  post_patiently(std::move(label), action(std::move(task), Workbench::After::kStay));
}

void StudioThread::act_in_series(std::string label, Workbench::Task task, Workbench::After after) {
  push({.label = std::move(label), .job = action(std::move(task), after), .in_series = true});
}

void StudioThread::change(std::string label, Workbench::Task task, Workbench::After after) {
  post(std::move(label),
       with_session([task = std::move(task), after](Workbench& bench) { return bench.change(task, after); }));
}

void StudioThread::repaint(std::string label, Workbench::Task task) {
  post(std::move(label), with_session([task = std::move(task)](Workbench& bench) { return bench.repaint(task); }));
}

void StudioThread::begin_stroke(Stroke stroke, fs::path folder) {
  post("paint", [stroke = std::move(stroke), folder = std::move(folder)](Workbench& bench) -> Result<void> {
    if (!bench.has_session()) return {};
    return stroke.brush.bucket ? bench.lay(stroke, folder) : bench.begin_stroke(stroke, folder);
  });
}

void StudioThread::extend_stroke(std::vector<StrokePoint> points) {
  push({.kind = Entry::Kind::kExtend, .label = "paint", .points = std::move(points)});
}

void StudioThread::end_stroke() {
  post("paint", [](Workbench& bench) { return bench.end_stroke(); });
}

void StudioThread::preview(std::vector<std::string> assignments) {
  push({.kind = Entry::Kind::kPreview, .label = "preview", .assignments = std::move(assignments)});
}

void StudioThread::preview_frame(double frame) {
  push({.kind = Entry::Kind::kFrame, .label = "look at another frame", .frame = frame});
}

void StudioThread::go_to(double frame) {
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(queue_, [](const Entry& entry) { return entry.kind == Entry::Kind::kFrame; });
  }
  post("go to another frame", [this, frame](Workbench& bench) -> Result<void> {
    frames_->leave_preview();
    if (!bench.has_session() || bench.session().shot().frame == frame) return {};
    return bench.change([frame](Session& session) { return session.go_to(frame); });
  });
}

void StudioThread::want_strip(int pictures, int step) {
  post("", [this, pictures, step](Workbench&) -> Result<void> {
    frames_->want(pictures, step);
    return {};
  });
}

void StudioThread::cancel() {
  ++cancels_;
  post("stop", [this](Workbench& bench) -> Result<void> {
    --cancels_;
    if (bench.has_session()) bench.stop();
    return {};
  });
}

bool StudioThread::progress(std::string label) {
  {
    const std::lock_guard lock(mutex_);
    doing_ = std::move(label);
  }
  if (options_.on_change) options_.on_change();
  return !cancelled();
}

bool StudioThread::undisturbed() const {
  const std::lock_guard lock(mutex_);
  const bool waited_for =
      std::ranges::any_of(queue_, [](const Entry& entry) { return !entry.label.empty() && !entry.patient; });
  return !cancelled() && !waited_for;
}

void StudioThread::show(std::shared_ptr<const Image> picture, std::shared_ptr<const ParamState> lights) {
  {
    const std::lock_guard lock(mutex_);
    auto next = std::make_shared<StudioSnapshot>(*latest_);
    next->picture = std::move(picture);
    next->shown = std::move(lights);
    next->unanswered = 0;
    latest_ = std::move(next);
  }
  if (options_.on_change) options_.on_change();
}

std::shared_ptr<const StudioSnapshot> StudioThread::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

StudioThread::Activity StudioThread::activity() const {
  const std::lock_guard lock(mutex_);
  const double seconds = doing_.empty() ? 0.0 : std::chrono::duration<double>(Clock::now() - since_).count();
  return {doing_, seconds, queue_.size()};
}

std::vector<StudioMessage> StudioThread::take_messages() {
  const std::lock_guard lock(mutex_);
  return std::exchange(messages_, {});
}

void StudioThread::tell(StudioMessage message) {
  {
    const std::lock_guard lock(mutex_);
    messages_.push_back(std::move(message));
  }
  if (options_.on_change) options_.on_change();
}

bool StudioThread::open_device() {
  auto device = options_.make_device ? options_.make_device() : Device::create_headless();
  if (!device) {
    tell(message_of(device.error()));
    return false;
  }
  device_ = std::make_unique<Device>(std::move(*device));
  bench_ = std::make_unique<Workbench>(*device_, options_.roots, options_.unsaved);
  bench_->give_way_unless([this] { return undisturbed(); });
  frames_ = std::make_unique<FrameStrip>(*device_, options_.roots);
  return true;
}

/// The session again, from its log, on another device.
void StudioThread::reopen(const std::string& why) {
  const fs::path folder = bench_->folder();
  bench_.reset();
  frames_.reset();
  device_.reset();
  if (!open_device()) return;
  if (folder.empty()) return;
  if (++reopened_ > kTriesToReopen) {
    tell({StudioMessage::Kind::kError, "this happened again and again: " + why, "",
          "what was done is in " + folder.string() + "; save elsewhere and open it again"});
    return;
  }
  auto opened = bench_->open_project(folder);
  if (opened) {
    tell({StudioMessage::Kind::kWarning, why + "; the session was opened again from its log", "", ""});
  } else {
    tell(message_of(opened.error()));
  }
}

/// Waits for the next job, or takes none if there is more to do without one. returns whether there is a job.
bool StudioThread::take(Entry& entry, bool more) {
  std::unique_lock lock(mutex_);
  if (!more) wake_.wait_for(lock, std::chrono::milliseconds(500), [this] { return ending_ || !queue_.empty(); });
  if (ending_ || queue_.empty()) return false;
  entry = std::move(queue_.front());
  queue_.pop_front();
  doing_ = entry.label;
  since_ = Clock::now();
  return true;
}

void StudioThread::attend(const Result<void>& result) {
  if (!bench_) return;
  for (std::string& line : bench_->take_warnings()) tell({StudioMessage::Kind::kWarning, std::move(line), "", ""});
  if (result) {
    reopened_ = 0;
    return;
  }
  tell(message_of(result.error()));
  if (result.error().kind == ErrorKind::kGl) reopen("the graphics context was lost");
}

void StudioThread::work(Entry entry) {
  if (options_.on_change && entry.kind == Entry::Kind::kJob) options_.on_change();
  worked_ = true;
  Result<void> result;
  switch (entry.kind) {
    case Entry::Kind::kJob:
      result = entry.job(*bench_);
      break;
    case Entry::Kind::kExtend:
      result = bench_->extend_stroke(entry.points);
      break;
    case Entry::Kind::kPreview:
      if (bench_->has_session()) result = bench_->preview(entry.assignments);
      break;
    case Entry::Kind::kFrame:
      if (const auto now = latest(); bench_->has_session() && now && now->shown) {
        result = frames_->preview(bench_->session(), *now->shown, entry.frame);
      }
      break;
  }
  attend(result);
}

/// The next of a series waits, and the last picture is not old.
bool StudioThread::series_goes_on() const {
  const std::lock_guard lock(mutex_);
  return !queue_.empty() && queue_.front().in_series && Clock::now() - published_ < kBetweenSights;
}

void StudioThread::publish() {
  if (!bench_) return;
  auto snapshot = bench_->snapshot();
  published_ = Clock::now();
  if (!snapshot) {
    {
      const std::lock_guard lock(mutex_);
      doing_.clear();
    }
    attend(std::move(snapshot).error());
    return;
  }
  auto next = std::make_shared<StudioSnapshot>(**snapshot);
  if (bench_->has_session()) frames_->tell(bench_->session(), *next);
  {
    const std::lock_guard lock(mutex_);
    latest_ = std::move(next);
    doing_.clear();
  }
  if (options_.on_change) options_.on_change();
}

/// returns whether there is more to do without a job.
bool StudioThread::step() {
  auto more = bench_->step(options_.slice);
  if (!more) {
    bench_->stop();
    attend(std::move(more).error());
  }
  const bool going = more && *more;
  if (!going || Clock::now() - published_ > kBetweenSnapshots) publish();
  return going;
}

/// One small picture of the strip. returns whether there was one to make.
Result<bool> StudioThread::draw_frame() {
  const auto shown = latest()->shown;
  if (!shown || !bench_->has_session()) return false;
  return frames_->step(bench_->session(), *shown);
}

/// What waits until there is nothing else to do. returns whether to come back at once.
bool StudioThread::idle() {
  if (!bench_ || !bench_->has_session()) return false;
  attend(bench_->sync_if_due());
  if (!bench_) return false;
  attend(bench_->prepare());
  if (!bench_) return false;
  const auto refreshed = bench_->refresh_style();
  if (!refreshed) attend(refreshed.error());
  if (refreshed && *refreshed) {
    tell({StudioMessage::Kind::kNote, "the style was read again", "", ""});
    frames_->forget();
    publish();
  }
  if (!bench_) return false;
  const auto drawn = draw_frame();
  if (!drawn) attend(drawn.error());
  const bool rests = !drawn || !*drawn;
  if (rests && worked_ && Clock::now() - trimmed_ > kBetweenTrims) {
    give_memory_back();
    worked_ = false;
    trimmed_ = Clock::now();
  }
  if (rests || !bench_) return false;
  publish();
  return true;
}

void StudioThread::run() {
  if (!open_device()) return;
  bool more = false;
  bool again = false;
  while (bench_) {  // gone if no device can be made any more, which was told
    try {
      Entry entry;
      if (take(entry, more || again)) {
        const bool in_series = entry.in_series;
        work(std::move(entry));
        if (!in_series || !series_goes_on()) publish();
        more = true;
        continue;
      }
      {
        const std::lock_guard lock(mutex_);
        if (ending_) break;
      }
      more = more && step();
      again = !more && idle();
    } catch (const std::exception& exception) {
      more = false;
      reopen(std::string("something went wrong: ") + exception.what());
      publish();
    }
  }
  bench_.reset();
  frames_.reset();
  device_.reset();
}

}  // namespace luminist
