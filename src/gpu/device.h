#pragma once
// gpu/device.h -- an OpenGL 4.5 core context that is current on this thread.
#include <epoxy/gl.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace luminist {

/// What the driver says about itself, and the limits that sizes are checked against.
struct DeviceInfo {
  std::string vendor;
  std::string renderer;
  std::string version;
  std::string shading_language;
  std::string platform;      ///< how the context came about: "EGL device", "EGL surfaceless", "EGL default", "adopted"
  bool software = false;     ///< the picture is made by the CPU
  int max_texture_size = 0;  ///< texels along a side
  int max_array_layers = 0;
  float max_anisotropy = 1.0F;  ///< 1: no anisotropic filter
  std::int64_t max_storage_block_bytes = 0;
  std::int64_t max_uniform_block_bytes = 0;
  int max_groups_x = 0;  ///< work groups of a dispatch along x; y is at least 65,535
};

/// One message of the driver, of a severity above "notification".
struct DeviceMessage {
  bool error = false;  ///< an OpenGL error: our bug, or memory that ran out
  std::string text;
};

struct DeviceOptions {
  bool debug = false;  ///< ask the driver for a debug context: more messages, slower
};

/// Whoever holds a Device& may call OpenGL: its context is current on this thread. One device per thread at a time;
/// everything made from a device goes before the device does.
///
/// Conventions set here once: clip space depth is [0,1], cube maps are seamless, pixel rows are tightly packed.
class Device {
 public:
  /// A context without a window: on the first EGL device that is no software renderer; else Mesa surfaceless; else the
  /// default display; else a software EGL device. errors kGl: what was tried and what is missing.
  static Result<Device> create_headless(const DeviceOptions& options = {});

  /// Takes over the context that is current on this thread (a window's); does not destroy it.
  /// release: called on this thread when the device goes. errors kGl if there is none, or it is older than 4.5 core.
  static Result<Device> adopt(std::function<void()> release = {});

  Device(Device&&) noexcept;
  Device& operator=(Device&&) noexcept;
  ~Device();

  [[nodiscard]] const DeviceInfo& info() const;

  /// A number that this device has not given before, from 1 on: caches compare identities, and names are reused.
  std::uint64_t new_id();

  /// What the driver said since the last call, oldest first; at most 1,000 messages are kept.
  std::vector<DeviceMessage> take_messages();

  /// The OpenGL errors since the last call, as one Error: kLimit for memory, kGl for a lost context or our mistakes.
  /// `doing` completes "cannot ...". Waits for nothing.
  Result<void> check_errors(const std::string& doing);

 private:
  struct State;
  explicit Device(std::unique_ptr<State> state);
  Result<void> prepare();
  std::unique_ptr<State> state_;
};

}  // namespace luminist
