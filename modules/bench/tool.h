// Runs another program to its end: gnuplot, git.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace regista::bench {

struct ToolResult {
  int status = 0;      ///< exit status; 127 where there is no such program
  std::string output;  ///< stdout and stderr
};

/// In that folder, through the shell with every word quoted.
ToolResult run_tool(const std::filesystem::path& folder, const std::vector<std::string>& words);

}  // namespace regista::bench
