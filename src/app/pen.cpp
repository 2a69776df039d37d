#include "app/pen.h"

#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace luminist {

float PressureAxis::pressure(double raw) const {
  if (number < 0 || !(most > least)) return 1.0F;
  return static_cast<float>(std::clamp((raw - least) / (most - least), 0.0, 1.0));
}

bool axis_value(const unsigned char* mask, int mask_bytes, const double* values, int axis, double& value) {
  if (axis < 0 || axis >= 8 * mask_bytes || !XIMaskIsSet(mask, axis)) return false;
  int before = 0;
  for (int i = 0; i < axis; ++i) before += XIMaskIsSet(mask, i) ? 1 : 0;
  value = values[before];
  return true;
}

/// The X server as a pen needs it.
struct Pen::Server {
  Display* display = nullptr;
  int opcode = 0;                    ///< of the extension's events
  std::map<int, PressureAxis> axes;  ///< by device; those of other devices have no number
  std::string name;                  ///< of the first with pressure

  Server() = default;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server() {
    if (display != nullptr) XCloseDisplay(display);
  }

  /// returns why it cannot be; "" if it is there.
  std::string open() {
    display = XOpenDisplay(nullptr);
    if (display == nullptr) return "no X server";
    int event = 0;
    int error = 0;
    if (XQueryExtension(display, "XInputExtension", &opcode, &event, &error) == 0) return "no XInput";
    int major = 2;
    int minor = 2;  // raw events also while another client holds the pointer
    if (XIQueryVersion(display, &major, &minor) != 0) return "no XInput 2";
    std::array<unsigned char, XIMaskLen(XI_LASTEVENT)> mask{};
    for (const int wanted : {XI_RawMotion, XI_RawButtonPress, XI_HierarchyChanged}) XISetMask(mask.data(), wanted);
    XIEventMask all{XIAllDevices, static_cast<int>(mask.size()), mask.data()};
    XISelectEvents(display, XDefaultRootWindow(display), &all, 1);
    find_pens();
    XFlush(display);
    return "";
  }

  void find_pens() {
    axes.clear();
    name.clear();
    const Atom wanted = XInternAtom(display, "Abs Pressure", False);
    int count = 0;
    XIDeviceInfo* devices = XIQueryDevice(display, XIAllDevices, &count);
    for (int d = 0; d < count; ++d) {
      if (devices[d].use != XISlavePointer && devices[d].use != XIFloatingSlave) continue;
      for (int c = 0; c < devices[d].num_classes; ++c) {
        if (devices[d].classes[c]->type != XIValuatorClass) continue;
        const auto& axis = *reinterpret_cast<const XIValuatorClassInfo*>(devices[d].classes[c]);
        if (axis.label != wanted) continue;
        axes[devices[d].deviceid] = {axis.number, axis.min, axis.max};
        if (name.empty()) name = devices[d].name;
      }
    }
    if (devices != nullptr) XIFreeDeviceInfo(devices);
  }

  void take(const XIRawEvent& event, float& pressure) const {
    const auto axis = axes.find(event.sourceid != 0 ? event.sourceid : event.deviceid);
    if (axis == axes.end()) {
      pressure = 1.0F;  // a mouse
      return;
    }
    double raw = 0.0;
    const XIValuatorState& told = event.valuators;  // what did not change is not told
    if (axis_value(told.mask, told.mask_len, event.raw_values, axis->second.number, raw)) {
      pressure = axis->second.pressure(raw);
    }
  }
};

Pen::Pen() : server_(std::make_unique<Server>()) {
  const char* session = std::getenv("DISPLAY");
  why_not_ = session == nullptr || *session == '\0' ? "no X server" : server_->open();
  if (!why_not_.empty()) server_.reset();
}

Pen::~Pen() = default;

float Pen::pressure() {
  if (!server_) return 1.0F;
  bool other_devices = false;
  while (XPending(server_->display) > 0) {
    XEvent event;
    XNextEvent(server_->display, &event);
    XGenericEventCookie& cookie = event.xcookie;
    if (event.type != GenericEvent || cookie.extension != server_->opcode) continue;
    if (XGetEventData(server_->display, &cookie) == 0) continue;
    if (cookie.evtype == XI_HierarchyChanged) {
      other_devices = true;
    } else {
      server_->take(*static_cast<const XIRawEvent*>(cookie.data), pressure_);
    }
    XFreeEventData(server_->display, &cookie);
  }
  if (other_devices) server_->find_pens();
  return pressure_;
}

std::string Pen::told() const {
  if (!server_) return "No pen pressure: " + why_not_;
  return server_->name.empty() ? "No pen: the mouse presses fully" : "Pen: " + server_->name;
}

}  // namespace luminist
