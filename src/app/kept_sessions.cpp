#include "app/kept_sessions.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <ctime>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "project/project.h"
#include "project/project_lock.h"

namespace luminist {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecent = 10;

fs::path state_folder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base = state != nullptr && *state != '\0' ? fs::path(state)
                        : home != nullptr                  ? fs::path(home) / ".local/state"
                                                           : fs::temp_directory_path();
  return base / "luminist";
}

/// Whether the process that "untitled-PID-N.lum" names still runs.
bool is_alive(const std::string& name) {
  constexpr std::string_view kStart = "untitled-";
  if (!name.starts_with(kStart)) return false;
  int process = 0;
  const char* begin = name.data() + kStart.size();
  if (std::from_chars(begin, name.data() + name.size(), process).ec != std::errc() || process <= 0) return false;
  return process_runs(process);
}

std::string local_time(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  if (error) return "";
  const auto moment = std::chrono::system_clock::to_time_t(std::chrono::file_clock::to_sys(written));
  std::tm parts{};
  ::localtime_r(&moment, &parts);
  char text[32];
  return std::string(text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts));
}

}  // namespace

fs::path unsaved_folder() {
  return state_folder() / "unsaved";
}

std::vector<KeptSession> kept_sessions(const fs::path& folder) {
  std::vector<KeptSession> kept;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".lum" || is_alive(entry.path().filename().string())) continue;
    const auto project = Project::open(entry.path(), Project::Access::kRead);
    if (!project) continue;
    const std::size_t steps = project->undo_steps() + project->redo_steps();
    if (steps == 0) {
      fs::remove_all(entry.path(), error);
      continue;
    }
    const auto scene = nlohmann::json::parse(project->document().get("shot/scene"), nullptr, false);
    kept.push_back({entry.path(), scene.is_string() ? fs::path(scene.get<std::string>()).stem().string() : "a shot",
                    steps, local_time(entry.path() / "log.jsonl")});
  }
  std::sort(kept.begin(), kept.end(), [](const KeptSession& a, const KeptSession& b) { return a.when > b.when; });
  return kept;
}

std::vector<fs::path> recent_files() {
  std::vector<fs::path> files;
  const auto text = read_file(state_folder() / "recent");
  if (!text) return files;
  std::error_code error;
  for (std::size_t start = 0; start < text->size();) {
    const std::size_t end = std::min(text->find('\n', start), text->size());
    const fs::path path = text->substr(start, end - start);
    start = end + 1;
    if (!path.empty() && fs::exists(path, error)) files.push_back(path);
  }
  return files;
}

void remember_file(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::weakly_canonical(path, error);
  std::vector<fs::path> files = recent_files();
  std::erase(files, absolute);
  files.insert(files.begin(), absolute);
  files.resize(std::min(files.size(), kMostRecent));
  std::string text;
  for (const fs::path& file : files) text.append(file.string()).append("\n");
  // A list that cannot be kept is no reason to disturb anybody.
  if (make_folder(state_folder())) static_cast<void>(write_file_atomic(state_folder() / "recent", text));
}

bool was_told(const std::string& what) {
  std::error_code error;
  return fs::exists(state_folder() / (what + "-told"), error);
}

void remember_told(const std::string& what) {
  if (make_folder(state_folder())) static_cast<void>(write_file_atomic(state_folder() / (what + "-told"), ""));
}

}  // namespace luminist
