// A grid of planner settings from a TOML file: every combination of the values listed for a planner.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "planning/planning_params.h"

namespace regista::bench {

struct Setting {
  std::string planner;
  double time_us = 0.0;  ///< allowed per query
  /// Keys of PlanningParams::ompl (without "ompl.") with their values.
  std::vector<std::pair<std::string, std::string>> params;

  /// "range_m 0.5, simplify true".
  std::string text() const;
  /// Throws ParamError.
  PlanningParams planning_params() const;
};

/// time_us and simplify for all; a table per planner with a list of values per parameter. Throws std::runtime_error
/// naming the file where it makes no sense.
std::vector<Setting> load_grid(const std::filesystem::path& file);

/// A file of modules/bench/data/, which travels beside the program in bench_data/.
std::filesystem::path data_file(const std::string& name);

}  // namespace regista::bench
