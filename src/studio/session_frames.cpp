// The part of a session that moves through time.
#include "studio/session.h"
#include "studio/shot_view.h"
#include "studio/shots.h"

namespace luminist {

Result<void> Session::go_to(double frame) {
  return view().look_through({vantage().camera, frame});
}

Result<int> Session::set_keys(const std::string& pattern, KeyInterpolation interpolation) {
  return Shots(*this).set_keys(pattern, interpolation);
}

Result<int> Session::remove_keys(const std::string& pattern) {
  return Shots(*this).remove_keys(pattern, shot_.frame);
}

}  // namespace luminist
