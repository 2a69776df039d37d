#pragma once
// app/kept_sessions.h -- what the studio remembers from one start to the next: sessions without a name, recent files.
#include <filesystem>
#include <string>
#include <vector>

namespace luminist {

/// Where sessions without a name are kept: luminist/unsaved below XDG_STATE_HOME or ~/.local/state.
std::filesystem::path unsaved_folder();

/// A session that nobody saved and whose program has ended.
struct KeptSession {
  std::filesystem::path folder;
  std::string scene;
  std::size_t steps = 0;
  std::string when;  ///< of the last gesture, local time
};
/// Those with something in them, newest first; empty ones of ended programs are deleted. cost reading their logs.
std::vector<KeptSession> kept_sessions(const std::filesystem::path& folder);

/// Files that were opened or saved, newest first, at most ten; those that are gone are left out.
std::vector<std::filesystem::path> recent_files();
void remember_file(const std::filesystem::path& path);

/// Whether something is told only once, and was.
bool was_told(const std::string& what);
void remember_told(const std::string& what);

}  // namespace luminist
