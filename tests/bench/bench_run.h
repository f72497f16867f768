// A bench's run in a folder of its own, and what it left there.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "modules/bench/record.h"
#include "tests/support/temporary_folder.h"

namespace regista::bench {

struct BenchRun {
  TemporaryFolder folder;
  Run run;
  BenchRun() { run.out = folder.path("out"); }

  /// Rows of a table, its head left out.
  std::size_t rows(const std::string& name) const {
    std::ifstream file(run.out / (name + ".csv"));
    std::size_t lines = 0;
    for (std::string line; std::getline(file, line);) lines += line.starts_with("#") ? 0U : 1U;
    return lines == 0 ? 0 : lines - 1;
  }
  bool has_plot(const std::string& name) const {
    return std::filesystem::file_size(run.out / (name + ".svg")) > 0 &&
           std::filesystem::file_size(run.out / (name + ".png")) > 0;
  }
};

}  // namespace regista::bench
