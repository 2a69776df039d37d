#include "gpu/device.h"

#include <epoxy/egl.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <utility>

#include "base/check.h"

namespace luminist {

struct Device::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;  ///< EGL_NO_CONTEXT: adopted, not ours to destroy
  EGLSurface surface = EGL_NO_SURFACE;
  std::function<void()> release;  ///< of one that is adopted
  DeviceInfo info;
  std::vector<DeviceMessage> messages;
  std::uint64_t last_id = 0;

  ~State() {
    if (context == EGL_NO_CONTEXT) {
      if (!info.version.empty()) glDebugMessageCallback(nullptr, nullptr);
      if (release) release();
      return;
    }
    // The display stays initialized: other devices of this process may share it.
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
  }
  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

namespace {

constexpr std::size_t kMostMessages = 1000;

Error no_gl(std::string what) {
  return {ErrorKind::kGl, std::move(what), "", "",
          "OpenGL 4.5 is needed: install the graphics driver, or libgl1-mesa-dri for software rendering"};
}

bool has_word(const char* list, std::string_view word) {
  std::string_view rest = list != nullptr ? list : "";
  while (!rest.empty()) {
    const std::size_t end = rest.find(' ');
    if (rest.substr(0, end) == word) return true;
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  return false;
}

/// A display that might give a context, with the name of the way it was found.
struct Candidate {
  EGLDisplay display;
  std::string platform;
};

void add_egl_devices(std::vector<Candidate>& hardware, std::vector<Candidate>& software) {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base")) {
    return;
  }
  std::array<EGLDeviceEXT, 32> devices{};
  EGLint count = 0;
  if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE) return;
  for (EGLint i = 0; i < count; ++i) {
    const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
    if (display == EGL_NO_DISPLAY) continue;
    const bool is_software = has_word(eglQueryDeviceStringEXT(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
    (is_software ? software : hardware).push_back({display, "EGL device"});
  }
}

/// In order of preference. With a vendor-neutral loader, asking for surfaceless first would give Mesa's software
/// renderer although there is a graphics card; so devices come first.
std::vector<Candidate> candidates() {
  std::vector<Candidate> found;
  std::vector<Candidate> software;
  add_egl_devices(found, software);
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display != EGL_NO_DISPLAY) found.push_back({display, "EGL surfaceless"});
  }
  if (const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY); display != EGL_NO_DISPLAY) {
    found.push_back({display, "EGL default"});
  }
  found.insert(found.end(), software.begin(), software.end());
  return found;
}

/// Makes a 4.5 core context current, or says why not.
std::string make_current(EGLDisplay display, bool debug, EGLContext& context, EGLSurface& surface) {
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return "does not initialize";
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) return "has no desktop OpenGL";

  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  const bool has_config = eglChooseConfig(display, wanted.data(), &config, 1, &configs) == EGL_TRUE && configs > 0;
  if (!has_config && !epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) return "has no usable config";

  const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                         4,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         5,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_CONTEXT_OPENGL_DEBUG,
                                         debug ? EGL_TRUE : EGL_FALSE,
                                         EGL_NONE};
  context = eglCreateContext(display, has_config ? config : nullptr, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT)
    return fmt::format("gives no OpenGL 4.5 core context (EGL error {:#x})", eglGetError());

  if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") && has_config) {
    const std::array<EGLint, 5> size{EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
    surface = eglCreatePbufferSurface(display, config, size.data());
  }
  if (eglMakeCurrent(display, surface, surface, context) == EGL_TRUE) return "";
  const EGLint error = eglGetError();
  eglDestroyContext(display, context);
  if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
  context = EGL_NO_CONTEXT;
  surface = EGL_NO_SURFACE;
  return fmt::format("does not make its context current (EGL error {:#x})", error);
}

std::string text_of(GLenum what) {
  const auto* text = reinterpret_cast<const char*>(glGetString(what));
  return text != nullptr ? text : "";
}

int integer_of(GLenum what) {
  GLint value = 0;
  glGetIntegerv(what, &value);
  return value;
}

DeviceInfo read_info(std::string platform) {
  DeviceInfo info;
  info.vendor = text_of(GL_VENDOR);
  info.renderer = text_of(GL_RENDERER);
  info.version = text_of(GL_VERSION);
  info.shading_language = text_of(GL_SHADING_LANGUAGE_VERSION);
  info.platform = std::move(platform);
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR"}) {
    info.software = info.software || info.renderer.find(name) != std::string::npos;
  }
  info.max_texture_size = integer_of(GL_MAX_TEXTURE_SIZE);
  info.max_array_layers = integer_of(GL_MAX_ARRAY_TEXTURE_LAYERS);
  if (epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic") ||
      epoxy_has_gl_extension("GL_ARB_texture_filter_anisotropic")) {
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &info.max_anisotropy);
  }
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  info.max_storage_block_bytes = bytes;
  info.max_uniform_block_bytes = integer_of(GL_MAX_UNIFORM_BLOCK_SIZE);
  GLint groups = 0;
  glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &groups);
  info.max_groups_x = groups;
  return info;
}

void GLAPIENTRY collect_message(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity, GLsizei length,
                                const GLchar* text, const void* user) {
  if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
  auto& messages = *static_cast<std::vector<DeviceMessage>*>(const_cast<void*>(user));
  if (messages.size() >= kMostMessages) return;
  const std::string words = length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length));
  messages.push_back({type == GL_DEBUG_TYPE_ERROR, words});
}

}  // namespace

Device::Device(std::unique_ptr<State> state) : state_(std::move(state)) {}
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;
Device::~Device() = default;

const DeviceInfo& Device::info() const {
  return state_->info;
}

Result<Device> Device::create_headless(const DeviceOptions& options) {
  std::string tried;
  for (const Candidate& candidate : candidates()) {
    Device device(std::make_unique<State>());
    State& state = *device.state_;
    state.display = candidate.display;
    std::string why = make_current(candidate.display, options.debug, state.context, state.surface);
    if (why.empty()) {
      state.info.platform = candidate.platform;
      auto prepared = device.prepare();
      if (prepared) return device;
      why = prepared.error().what;
    }
    tried += fmt::format("{}{} {}", tried.empty() ? "" : "; ", candidate.platform, why);
  }
  return no_gl("no OpenGL context without a window: " + (tried.empty() ? "EGL offers no display" : tried));
}

Result<Device> Device::adopt(std::function<void()> release) {
  // The loader may end the process if it is asked for newer functions without a context; this one it always finds.
  if (glGetString(GL_VERSION) == nullptr) return no_gl("no OpenGL context is current on this thread");
  Device device(std::make_unique<State>());
  device.state_->info.platform = "adopted";
  device.state_->release = std::move(release);
  LUM_TRY_VOID(device.prepare());
  return device;
}

Result<void> Device::prepare() {
  const int version = epoxy_gl_version();
  if (version < 45 || !epoxy_is_desktop_gl()) {
    return no_gl(fmt::format("OpenGL {}.{} ({}) is too old", version / 10, version % 10, text_of(GL_RENDERER)));
  }
  state_->info = read_info(state_->info.platform);
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(collect_message, &state_->messages);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  return {};
}

std::uint64_t Device::new_id() {
  return ++state_->last_id;
}

std::vector<DeviceMessage> Device::take_messages() {
  return std::exchange(state_->messages, {});
}

Result<void> Device::check_errors(const std::string& doing) {
  GLenum first = GL_NO_ERROR;
  bool memory = false;
  // A lost context answers GL_CONTEXT_LOST for ever: do not wait for the last one.
  for (int i = 0; i < 16; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    if (first == GL_NO_ERROR) first = error;
    memory = memory || error == GL_OUT_OF_MEMORY;
  }
  if (first == GL_NO_ERROR) return {};
  if (memory) {
    return Error{ErrorKind::kLimit, "cannot " + doing + ": the graphics memory is exhausted", "", "",
                 "make the picture smaller"};
  }
  const std::string said = state_->messages.empty() ? "" : ": " + state_->messages.back().text;
  return Error{ErrorKind::kGl, fmt::format("cannot {}: OpenGL error {:#x}{}", doing, first, said), "", "", ""};
}

}  // namespace luminist
