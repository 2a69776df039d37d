#pragma once
// studio/farm.h -- a sequence as a job for engines that others run: Slurm, and plain lists of commands.
#include <filesystem>
#include <string>
#include <vector>

#include "studio/sequence.h"

namespace luminist {

struct FarmJob {
  std::string program;                 ///< the executable on the machines of the farm
  std::vector<std::string> arguments;  ///< of `render`, without --frames
  FrameRange range;
  int chunk = 8;  ///< frames a task: to start one costs an engine about a second; more where tasks would be above 1,000
  std::string name = "luminist";
};

/// A word for a POSIX shell, quoted where it has to be.
std::string shell_word(const std::string& word);

/// A line a task: "luminist render ... --frames 0-7". For GNU parallel, xargs, and engines that take commands.
std::vector<std::string> farm_commands(const FarmJob& job);

/// An sbatch script: an array with a task a chunk, requeued when a node dies. Frames are written whole or not at all
/// and those that are there are skipped, so a task may run twice, and the job be submitted again to go on.
std::string slurm_script(const FarmJob& job);

/// FOLDER/commands.txt and FOLDER/job.sh. errors kUnwritable.
Result<void> write_farm_job(const FarmJob& job, const std::filesystem::path& folder);

}  // namespace luminist
