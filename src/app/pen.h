#pragma once
// app/pen.h -- how hard a pen presses, which GLFW does not tell: read through XInput 2.
#include <memory>
#include <string>

namespace luminist {

/// What an axis of a device says, as a pressure.
struct PressureAxis {
  int number = -1;  ///< of the device's axes; -1: it has none that tells pressure
  double least = 0.0;
  double most = 0.0;

  /// In [0,1]; an axis without a range presses fully. Raw values may lie outside of it.
  [[nodiscard]] float pressure(double raw) const;
};

/// The value of an axis among those that an event tells: mask has a bit for each axis, values only those whose bit is
/// set, in order. returns whether the event tells it.
bool axis_value(const unsigned char* mask, int mask_bytes, const double* values, int axis, double& value);

/// Listens to all pens of the X server, on a connection of its own. Where there is no X, or no XInput 2, every pointer
/// presses fully, and so does a mouse anywhere.
class Pen {
 public:
  Pen();
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  /// Of the device that moved last. Reads what came since the last call; never waits.
  [[nodiscard]] float pressure();
  /// A line that says whether there is one, and which.
  [[nodiscard]] std::string told() const;

 private:
  struct Server;
  std::unique_ptr<Server> server_;  ///< null without XInput 2
  std::string why_not_;
  float pressure_ = 1.0F;
};

}  // namespace luminist
