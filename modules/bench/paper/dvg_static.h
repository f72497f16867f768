// One static test of Costa & Tonidandel: planners on a scenario, time, length and safety of every sample.
#pragma once

#include "modules/bench/paper/comparison.h"
#include "modules/bench/paper/dvg_entrant.h"
#include "modules/bench/paper/paper.h"

namespace regista::bench {

struct StaticTest {
  std::string title;     ///< of the report
  std::string stem;      ///< of the files: "dvg_table4"
  std::string table;     ///< of the published rows: "table4"; "" where no number is printed
  std::string scenario;  ///< file
  std::vector<std::string> notes = {};
};

/// Published samples, where the file has any of that table.
Published published_of(const std::string& table);

struct StaticSamples {
  std::vector<Sampled> sampled;    ///< per entrant time [ms], length [m], safety [m]
  std::vector<std::string> notes;  ///< what else was counted
};

/// `samples` tries each, entrants one after another in rotating order; `where` becomes the scenario of the rows.
StaticSamples measure_static(Entrants& entrants, const ObjectsQuery& query, const std::string& where,
                             std::size_t samples, std::uint64_t seed, Checker& checker);

/// The whole test: table, CSV, and box plots of the three quantities. Returns the exit status.
int run_static_test(const StaticTest& test, Entrants entrants, const PaperOptions& options, const Run& run);

}  // namespace regista::bench
