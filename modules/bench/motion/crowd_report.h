// What `regista bench crowd` says of the games it played.
#pragma once

#include "modules/bench/motion/crowd_bench.h"
#include "modules/bench/motion/crowd_run.h"
#include "modules/bench/report.h"

namespace regista::bench {

struct CrowdRow {
  CrowdGame game;
  CrowdScore score;
};

/// Contacts, faults and pace, a line per row; the pace also as a share of the row of the same field and preset whose
/// opponents are `none`, where there is one.
Table crowd_scores(const std::vector<CrowdRow>& rows, const CrowdOptions& options);

/// What ticks took; without the rows in which nothing was measured.
Table crowd_costs(const std::vector<CrowdRow>& rows);

/// Own contacts and pace as bars, a plot per field.
void add_crowd_plots(Report& report, const std::vector<CrowdRow>& rows, const CrowdOptions& options);

}  // namespace regista::bench
