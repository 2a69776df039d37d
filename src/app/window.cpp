#include "app/window.h"

#include <epoxy/gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace luminist {
namespace {

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

Error no_window(const std::string& doing) {
  const char* text = nullptr;
  glfwGetError(&text);
  return {ErrorKind::kGl, doing + (text != nullptr ? std::string(": ") + text : ""), "", "",
          "luminist --help lists what works without a window"};
}

}  // namespace

bool has_display() {
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

Result<std::unique_ptr<Window>> Window::create(const std::string& title, int width, int height) {
  if (glfwInit() != GLFW_TRUE) return no_window("no window system answers");
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  std::unique_ptr<Window> window(new Window());
  window->handle_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window->handle_ == nullptr) return no_window("no window can be opened");
  glfwSetWindowSizeLimits(window->handle_, 960, 600, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwMakeContextCurrent(window->handle_);
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  window->software_ = renderer != nullptr && std::strstr(renderer, "llvmpipe") != nullptr;
  glfwSwapInterval(window->software_ ? 0 : 1);
  if (!window->software_) window->open_spare();
  float across = 1.0F;
  glfwGetWindowContentScale(window->handle_, &across, &window->scale_);
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  window->install_callbacks();  // ours alone: they pass on to ImGui
  if (!ImGui_ImplGlfw_InitForOpenGL(window->handle_, false) || !ImGui_ImplOpenGL3_Init("#version 330")) {
    return no_window("the window cannot be drawn on");
  }
  return window;
}

/// Windows are made on this thread alone, and so before anybody knows whether the context is needed.
void Window::open_spare() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  spare_ = glfwCreateWindow(16, 16, "", nullptr, nullptr);
}

Result<void> Window::make_spare_current() {
  if (spare_ == nullptr) return no_window("the window's driver gives no second context of OpenGL 4.5");
  glfwMakeContextCurrent(spare_);
  return {};
}

void Window::release_spare() {
  glfwMakeContextCurrent(nullptr);
}

Window::~Window() {
  if (handle_ != nullptr && ImGui::GetCurrentContext() != nullptr) {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  glfwTerminate();
}

Window& Window::of(GLFWwindow* handle) {
  return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

int Window::mods() const {
  const auto down = [&](int left, int right) {
    return glfwGetKey(handle_, left) == GLFW_PRESS || glfwGetKey(handle_, right) == GLFW_PRESS;
  };
  return (down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) ? GLFW_MOD_CONTROL : 0) |
         (down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT) ? GLFW_MOD_SHIFT : 0) |
         (down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT) ? GLFW_MOD_ALT : 0);
}

void Window::add(HandEvent event) {
  event.at = pointer_;
  event.mods = mods();
  event.pressure = pen_.pressure();
  event.time = seconds();
  hand_.push_back(event);
  any_event_ = true;
}

void Window::install_callbacks() {
  glfwSetWindowUserPointer(handle_, this);
  glfwSetCursorPosCallback(handle_, [](GLFWwindow* handle, double x, double y) {
    of(handle).pointer_ = Vec2(x, y);
    of(handle).add({HandEvent::Kind::kMove, {}, 0, 0, 0.0F, 1.0F});
  });
  glfwSetMouseButtonCallback(handle_, [](GLFWwindow* handle, int button, int action, int) {
    of(handle).buttons_.push_back({button, action, of(handle).pointer_});
    const auto kind = action == GLFW_PRESS ? HandEvent::Kind::kPress : HandEvent::Kind::kRelease;
    of(handle).add({kind, {}, button, 0, 0.0F, 1.0F});
  });
  glfwSetScrollCallback(handle_, [](GLFWwindow* handle, double across, double up) {
    ImGui_ImplGlfw_ScrollCallback(handle, across, up);
    of(handle).add({HandEvent::Kind::kScroll, {}, 0, 0, static_cast<float>(up), 1.0F});
  });
  glfwSetKeyCallback(handle_, [](GLFWwindow* handle, int key, int code, int action, int mods) {
    of(handle).changes_.push_back({key, code, action, mods});
    constexpr int kKnown = GLFW_MOD_CONTROL | GLFW_MOD_SHIFT | GLFW_MOD_ALT;
    of(handle).any_event_ = true;
    if (action != GLFW_RELEASE) of(handle).keys_.push_back({key, mods & kKnown});
  });
  glfwSetCharCallback(handle_, ImGui_ImplGlfw_CharCallback);
  glfwSetWindowFocusCallback(handle_, ImGui_ImplGlfw_WindowFocusCallback);
  glfwSetCursorEnterCallback(handle_, ImGui_ImplGlfw_CursorEnterCallback);
  glfwSetWindowRefreshCallback(handle_, [](GLFWwindow* handle) { of(handle).any_event_ = true; });
  glfwSetFramebufferSizeCallback(handle_, [](GLFWwindow* handle, int, int) { of(handle).any_event_ = true; });
}

bool Window::wait(double seconds) {
  if (seconds > 0.0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
  static_cast<void>(pen_.pressure());  // it hears of all pointers, also over other windows
  return std::exchange(any_event_, false);
}

void Window::wake() {
  glfwPostEmptyEvent();
}

double Window::seconds() {
  return glfwGetTime();
}

bool Window::space_down() const {
  return glfwGetKey(handle_, GLFW_KEY_SPACE) == GLFW_PRESS;
}

bool Window::take_close() {
  const bool wanted = glfwWindowShouldClose(handle_) == GLFW_TRUE;
  glfwSetWindowShouldClose(handle_, GLFW_FALSE);
  return wanted;
}

void Window::set_title(const std::string& title) {
  if (title == title_) return;
  title_ = title;
  glfwSetWindowTitle(handle_, title.c_str());
}

/// A press counts for what was hovered in a frame before it: one that came together with a move waits for one frame, in
/// which the pointer is where it was pressed. A release never waits for the hand to rest. ImGui looks at buttons once a
/// frame: of one that went down and up since, or twice, each change has a frame.
void Window::pass_on_buttons() {
  const bool moved = std::exchange(framed_, pointer_) != pointer_;
  pressed_at_.reset();
  if (buttons_.empty()) return;
  any_event_ = true;
  if (buttons_.front().action == GLFW_PRESS) pressed_at_ = buttons_.front().at;
  if (moved && pressed_at_ && !std::exchange(waited_, true)) return;
  waited_ = false;
  std::vector<int> turned;
  std::size_t next = 0;
  for (; next < buttons_.size(); ++next) {
    const Button& change = buttons_[next];
    if (std::find(turned.begin(), turned.end(), change.button) != turned.end()) break;
    turned.push_back(change.button);
    const auto index = static_cast<std::size_t>(change.button);
    if (index < down_.size()) down_[index] = change.action == GLFW_PRESS;
  }
  buttons_.erase(buttons_.begin(), buttons_.begin() + static_cast<std::ptrdiff_t>(next));
}

/// ImGui looks at keys once a frame: one that was pressed and let go since is told in two.
void Window::pass_on_keys() {
  std::vector<int> turned;
  std::size_t next = 0;
  for (; next < changes_.size(); ++next) {
    const KeyChange& change = changes_[next];
    if (std::find(turned.begin(), turned.end(), change.key) != turned.end()) break;
    turned.push_back(change.key);
    ImGui_ImplGlfw_KeyCallback(handle_, change.key, change.code, change.action, change.mods);
  }
  changes_.erase(changes_.begin(), changes_.begin() + static_cast<std::ptrdiff_t>(next));
  any_event_ = any_event_ || !changes_.empty();
}

void Window::begin_frame() {
  pass_on_buttons();
  pass_on_keys();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  std::copy(down_.begin(), down_.end(), ImGui::GetIO().MouseDown);  // not as they are by now
  if (pressed_at_) ImGui::GetIO().MousePos = {pressed_at_->x, pressed_at_->y};
  ImGui::NewFrame();
}

void Window::end_frame() {
  ImGui::Render();
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(handle_, &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(0.1F, 0.1F, 0.1F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(handle_);
}

}  // namespace luminist
