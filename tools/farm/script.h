#pragma once
/// The script that Slurm runs for each task of a job.

#include <span>
#include <string>
#include <vector>

#include "farm/job.h"

namespace tyndall::farm {

/// A word for the shell that stands for `text` exactly, whatever it holds but NUL.
[[nodiscard]] std::string shell_quote(const std::string& text);
/// Task numbers as Slurm's --array takes them: "1-3,7". `tasks` ascend.
[[nodiscard]] std::string array_of(std::span<const int> tasks);
/// The whole script for these tasks of the job.
[[nodiscard]] std::string script_of(const Job& job, std::span<const int> tasks);

}  // namespace tyndall::farm
