#pragma once
// studio/light_list.h -- the list of lights as a lighter keeps it: names, groups, copies, each a gesture of a session.
#include <string>
#include <vector>

#include "studio/session.h"

namespace luminist {

/// Obtained by Session::light_list(); the session outlives it. Every call is one command, with the errors of its
/// namesake in rig/light_list.h.
class LightList {
 public:
  explicit LightList(Session& session) : session_(&session) {}

  Result<void> rename(const std::string& light, const std::string& name);
  /// returns the copy's name. It adds its light to the picture at once.
  Result<std::string> duplicate(const std::string& light, const std::string& name = "");
  /// lights: names, or "group:NAME". "" ungroups.
  Result<void> group(const std::vector<std::string>& lights, const std::string& group);
  /// All of these, or all of a group, muted or not, as one command.
  Result<void> mute(const std::vector<std::string>& lights, bool muted);

 private:
  Session* session_;
};

}  // namespace luminist
