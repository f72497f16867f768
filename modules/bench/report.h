// Where a bench's results go: tables to the terminal and to CSV, plots beside them, one exit status.
#pragma once

#include <string>

#include "modules/bench/checker.h"
#include "modules/bench/plot.h"
#include "modules/bench/table.h"

namespace regista::bench {

class Report {
 public:
  /// Makes the folder. Throws std::filesystem::filesystem_error.
  explicit Report(const Run& run);

  /// Prints the table and writes <out>/<name>.csv.
  void add(const std::string& name, const Table& table);

  /// Draws <out>/<name>.svg and .png. Where that fails, says why on stderr in one line, and the bench will fail.
  void add(const std::string& name, const Plot& plot);

  /// Says what was written and which answers were faulty. The exit status: 1 where there was a faulty answer or a plot
  /// was not drawn.
  int finish(const Checker& checker) const;

 private:
  std::filesystem::path out_;
  Record record_;
  bool complete_ = true;
};

}  // namespace regista::bench
