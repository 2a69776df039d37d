#include "app/studio_app.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>

#include <imgui_internal.h>  // which popup is open

#include "app/canvas_panel.h"
#include "app/ink_clock.h"
#include "app/kept_sessions.h"
#include "app/layout.h"
#include "app/questions.h"
#include "app/window.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr double kLinger = 0.8;      // seconds after an event in which something may still move: tooltips
constexpr double kSlowFrame = 0.02;  // seconds between frames at least, where the processor draws them

/// A device on the card that draws the window. NVIDIA's driver (580) gives a process with a GLX window no EGL context
/// beside it; then another driver would answer, which draws on the processor, or none.
Result<Device> device_beside(Window& window) {
  auto device = Device::create_headless();
  if (window.software() || (device && !device->info().software)) return device;
  device = Error{ErrorKind::kGl, "", "", "", ""};  // no two contexts on one thread
  if (!window.make_spare_current()) return Device::create_headless();
  return Device::adopt(Window::release_spare);
}

class StudioApp {
 public:
  StudioApp(const StudioRequest& request, Window& window)
      : window_(&window),
        studio_(
            {request.roots, unsaved_folder(), [this] { note_change(); }, [this] { return device_beside(*window_); }}) {
    desk_.studio = &studio_;
    desk_.roots = request.roots;
    desk_.theme = make_theme(window.scale());
    desk_.software = window.software();
    desk_.now = studio_.latest();
  }

  void open(const StudioRequest& request) {
    if (!request.path.empty()) return open_path(desk_, request.path);
    if (questions_.find_kept(unsaved_folder())) desk_.ask(Question::kRecover);
    Shot shot;
    shot.scene = "meshes/still_life/still_life.glb";
    studio_.post("open the demo scene", [shot](Workbench& bench) { return bench.open(shot, fs::current_path()); });
  }

  void run() {
    double moved = Window::seconds();
    double drawn = -1.0;
    while (!desk_.quit) {
      const double now = Window::seconds();
      const bool busy = !studio_.activity().label.empty();
      const bool lively = now - moved < kLinger;
      const bool event = window_->wait(lively ? 0.05 : busy ? 0.1 : 1.0);
      const bool changed = changed_.exchange(false);
      if (event || changed) moved = Window::seconds();
      if (window_->software() && drawn >= 0.0) {
        for (double left = kSlowFrame - (Window::seconds() - drawn); left > 0.0;
             left = kSlowFrame - (Window::seconds() - drawn)) {
          static_cast<void>(window_->wait(left));
        }
      }
      drawn = Window::seconds();
      frame();
    }
    tidy();
  }

 private:
  void note_change() {
    changed_ = true;
    Window::wake();
  }

  void frame() {
    desk_.time = Window::seconds();
    desk_.see(studio_.latest());
    desk_.pen = window_->pen().told();
    desk_.activity = studio_.activity();
    for (StudioMessage& message : studio_.take_messages()) desk_.messages.push_back({std::move(message), desk_.time});
    if (window_->take_close()) desk_.ask(Question::kQuit);
    window_->begin_frame();
    const bool typing = ImGui::GetIO().WantTextInput;
    desk_.space_down = window_->space_down() && !typing;
    for (const KeyPress& press : window_->take_keys()) key(press, typing);
    const std::vector<HandEvent> hand = window_->take_hand();
    layout_.draw(desk_, canvas_, hand);
    questions_.draw(desk_);
    window_->end_frame();
    ink_clock_.note(hand, desk_.hand_down, desk_.time, Window::seconds());
    title();
  }

  /// Leaves the menu or list that is open on top of all; a field that is typed in takes Esc for itself first.
  /// returns whether Esc has done its work.
  static bool close_popup(bool typing) {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const int open = context.OpenPopupStack.Size;
    if (open == 0) return false;
    const ImGuiWindow* top = context.OpenPopupStack[open - 1].Window;
    if (top != nullptr && (top->Flags & ImGuiWindowFlags_Modal) != 0) return false;
    if (!typing) ImGui::ClosePopupToLevel(open - 1, true);
    return true;
  }

  void key(const KeyPress& press, bool typing) {
    if (press.key == GLFW_KEY_ESCAPE) {
      if (close_popup(typing)) return;
      if (desk_.question != Question::kNone) return questions_.leave(desk_);
      if (!std::exchange(desk_.linking, "").empty()) return;
      if (std::exchange(desk_.goal, DragGoal::kNone) != DragGoal::kNone) return;
      if (std::exchange(desk_.pick_material, false)) return;
      if (std::exchange(desk_.pick_clip, false) || canvas_.cancel_stroke(desk_)) return;
    }
    if (typing || desk_.question != Question::kNone || desk_.hand_down) return;
    const Deed deed = desk_.keys().find(press.key, press.mods);
    if (deed != Deed::kNone) perform(desk_, deed, press.key - GLFW_KEY_0);
  }

  void title() {
    if (!desk_.has_shot()) return;
    const HistoryFacts& history = desk_.now->history;
    if (!history.unsaved && history.folder != remembered_) remember_file(remembered_ = history.folder);
    const std::string name = history.unsaved ? fs::path(desk_.now->facts->shot.scene).stem().string() + " (unsaved)"
                                             : history.folder.filename().string();
    window_->set_title(name + " - Luminist");
  }

  /// A session in which nothing was done is not worth keeping.
  void tidy() {
    const auto last = studio_.latest();
    if (!last->history.unsaved || last->history.undo_steps + last->history.redo_steps > 0) return;
    nothing_done_ = last->history.folder;
  }

 public:
  [[nodiscard]] const fs::path& nothing_done() const { return nothing_done_; }

 private:
  Window* window_;
  std::atomic<bool> changed_ = false;
  StudioThread studio_;
  Desk desk_;
  Layout layout_;
  CanvasPanel canvas_;
  Questions questions_;
  InkClock ink_clock_;
  fs::path nothing_done_;
  fs::path remembered_;
};

/// Pictures are large and come and go in any order. Mapped each by itself they leave no holes between what stays; left
/// to itself the C library would take them from its heaps after the first was freed.
void keep_pictures_apart() {
#ifdef __GLIBC__
  constexpr int kLarge = 1 << 20;  // bytes
  ::mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

}  // namespace

Result<int> run_studio(const StudioRequest& request) {
  if (!has_display()) {
    return Error{ErrorKind::kGl, "there is no display to open the window on", "", "DISPLAY",
                 "start it in a desktop session, or see luminist --help for what works without a window"};
  }
  keep_pictures_apart();
  LUM_TRY(const std::unique_ptr<Window> window, Window::create("Luminist", 1280, 720));
  fs::path nothing_done;
  {
    StudioApp app(request, *window);
    app.open(request);
    app.run();
    nothing_done = app.nothing_done();
  }
  std::error_code error;
  if (!nothing_done.empty()) fs::remove_all(nothing_done, error);
  return 0;
}

}  // namespace luminist
