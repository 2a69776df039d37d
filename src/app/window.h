#pragma once
// app/window.h -- a window with a context of its own for what is drawn on it, and every event of the hand.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/hand_event.h"
#include "app/pen.h"
#include "base/result.h"

struct GLFWwindow;

namespace luminist {

struct KeyPress {
  int key = 0;   ///< GLFW's
  int mods = 0;  ///< control, shift and alt only
};

/// Whether the system shows windows: DISPLAY or WAYLAND_DISPLAY is set.
bool has_display();

/// GLFW and the frame of ImGui around it. One at a time, on the main thread.
class Window {
 public:
  /// errors kGl: no display, or no OpenGL for it.
  static Result<std::unique_ptr<Window>> create(const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for events, so long at most. returns whether any came.
  bool wait(double seconds);
  /// Wakes wait(). Any thread.
  static void wake();
  void begin_frame();
  void end_frame();  ///< draws what ImGui gathered and shows it

  [[nodiscard]] std::vector<HandEvent> take_hand() { return std::exchange(hand_, {}); }
  [[nodiscard]] std::vector<KeyPress> take_keys() { return std::exchange(keys_, {}); }
  [[nodiscard]] bool space_down() const;
  [[nodiscard]] bool take_close();  ///< the lighter asked to close it
  [[nodiscard]] float scale() const { return scale_; }
  [[nodiscard]] bool software() const { return software_; }
  /// A context of the window's driver for the thread that calls, beside the window's own; one thread at a time.
  /// errors kGl where the window system gives none of OpenGL 4.5, or the processor draws the window.
  Result<void> make_spare_current();
  static void release_spare();            ///< on that thread
  [[nodiscard]] static double seconds();  ///< since the start
  void set_title(const std::string& title);
  [[nodiscard]] const Pen& pen() const { return pen_; }

 private:
  Window() = default;
  static Window& of(GLFWwindow* handle);
  void install_callbacks();
  void open_spare();
  [[nodiscard]] int mods() const;
  void add(HandEvent event);
  void pass_on_buttons();
  void pass_on_keys();

  GLFWwindow* handle_ = nullptr;
  GLFWwindow* spare_ = nullptr;  ///< never shown: its context is what counts
  std::vector<HandEvent> hand_;
  std::vector<KeyPress> keys_;
  struct Button {
    int button = 0;
    int action = 0;
    Vec2 at{0.0F};  ///< where the pointer was
  };
  std::vector<Button> buttons_;     ///< not told to ImGui yet
  bool waited_ = false;             ///< the first of them, for a frame
  std::optional<Vec2> pressed_at_;  ///< where ImGui is to see the pointer in this frame
  std::array<bool, 5> down_{};      ///< buttons, as ImGui was told
  struct KeyChange {
    int key = 0;
    int code = 0;
    int action = 0;
    int mods = 0;
  };
  std::vector<KeyChange> changes_;  ///< the same
  Pen pen_;
  Vec2 pointer_{0.0F};
  Vec2 framed_{-1.0F};  ///< the pointer of the last frame
  float scale_ = 1.0F;
  bool software_ = false;
  bool any_event_ = false;
  std::string title_;
};

}  // namespace luminist
