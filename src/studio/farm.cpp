#include "studio/farm.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include <fmt/format.h>

#include "base/files.h"

namespace luminist {
namespace {

/// The frames of each task, as --frames takes them.
std::vector<std::string> chunks(const FarmJob& job) {
  const std::vector<int> frames = job.range.frames();
  // Slurm takes arrays of up to 1,001 tasks unless it is told otherwise.
  constexpr std::size_t kMostTasks = 1000;
  const std::size_t least = (frames.size() + kMostTasks - 1) / kMostTasks;
  const auto size = std::max(static_cast<std::size_t>(std::max(job.chunk, 1)), least);
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < frames.size(); begin += size) {
    const int last = frames[std::min(begin + size, frames.size()) - 1];
    words.push_back(job.range.step == 1 ? fmt::format("{}-{}", frames[begin], last)
                                        : fmt::format("{}-{}x{}", frames[begin], last, job.range.step));
  }
  return words;
}

std::string command_without_frames(const FarmJob& job) {
  std::string line = shell_word(job.program) + " render";
  for (const std::string& argument : job.arguments)
    fmt::format_to(std::back_inserter(line), " {}", shell_word(argument));
  return line;
}

}  // namespace

std::string shell_word(const std::string& word) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_-./:,=+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::vector<std::string> farm_commands(const FarmJob& job) {
  std::vector<std::string> lines;
  for (const std::string& frames : chunks(job)) {
    lines.push_back(fmt::format("{} --frames={}", command_without_frames(job), frames));
  }
  return lines;
}

std::string slurm_script(const FarmJob& job) {
  const std::vector<std::string> all = chunks(job);
  std::string text = fmt::format(
      "#!/bin/sh\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --array=0-{}\n"
      "#SBATCH --requeue\n"
      "#SBATCH --output=task-%a.log\n"
      "#SBATCH --open-mode=append\n"
      "# Frames that are there and whole are skipped: submit it again to go on after a failure.\n"
      "set -eu\n"
      "case $SLURM_ARRAY_TASK_ID in\n",
      shell_word(job.name), all.size() - 1);
  for (std::size_t i = 0; i < all.size(); ++i) text += fmt::format("  {}) frames={} ;;\n", i, all[i]);
  return text + fmt::format("esac\nexec {} --frames=\"$frames\"\n", command_without_frames(job));
}

Result<void> write_farm_job(const FarmJob& job, const std::filesystem::path& folder) {
  LUM_TRY_VOID(make_folder(folder));
  std::string lines;
  for (const std::string& line : farm_commands(job)) lines += line + "\n";
  LUM_TRY_VOID(write_file_atomic(folder / "commands.txt", lines));
  LUM_TRY_VOID(write_file_atomic(folder / "job.sh", slurm_script(job)));
  std::error_code error;
  std::filesystem::permissions(folder / "job.sh", std::filesystem::perms::owner_exec,
                               std::filesystem::perm_options::add, error);
  return {};
}

}  // namespace luminist
