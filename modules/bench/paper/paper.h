// `regista bench paper`: each table and figure that the planners' papers print, measured again beside the printed row.
#pragma once

#include <iosfwd>
#include <span>
#include <string_view>

#include "modules/bench/record.h"

namespace regista::bench {

struct PaperOptions {
  std::size_t samples = 0;  ///< per planner and scenario; 0: as many as the paper took, or the data file says
  double budget_us = 0.0;   ///< time per query; 0: the paper's, which is none where it names none
};

/// A published table or figure.
struct PaperTable {
  std::string_view name;    ///< as typed: "dvg-table4"
  std::string_view what;    ///< one line
  std::string_view source;  ///< paper and number
  /// Returns the exit status.
  int (*run)(const PaperOptions& options, const Run& run) = nullptr;
};

/// In the order of the papers.
std::span<const PaperTable> paper_tables();

/// nullptr where there is none of that name.
const PaperTable* find_paper_table(std::string_view name);

/// One line per table.
void print_list(std::span<const PaperTable> tables, std::ostream& out);

}  // namespace regista::bench
