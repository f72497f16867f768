#include "modules/bench/paper/paper.h"

#include <algorithm>
#include <ostream>
#include <vector>

#include "modules/bench/paper/dvg_tables.h"
#include "modules/bench/paper/irrt_table1.h"
#include "modules/bench/paper/sbp_figures.h"
#include "modules/bench/paper/sbp_tracking.h"
#include "modules/bench/paper/vis_tables.h"
#include "modules/bench/table.h"

namespace regista::bench {

std::span<const PaperTable> paper_tables() {
  static const std::vector<PaperTable> kTables{
      {"dvg-table1", "edges limited to the distance of the centres, or not", "Costa & Tonidandel, table 1",
       run_dvg_table1},
      {"dvg-table2", "near objects as one, or not", "Costa & Tonidandel, table 2", run_dvg_table2},
      {"dvg-table3", "robots in a group", "Costa & Tonidandel, table 3", run_dvg_table3},
      {"dvg-table4", "worst case for DVG+A*", "Costa & Tonidandel, table 4", run_dvg_table4},
      {"dvg-table5", "worst case for RRT", "Costa & Tonidandel, table 5", run_dvg_table5},
      {"dvg-table6", "mixed case", "Costa & Tonidandel, table 6", run_dvg_table6},
      {"dvg-table7", "positioning during a stoppage", "Costa & Tonidandel, table 7", run_dvg_table7},
      {"dvg-table8", "dynamic: planning time of a drive", "Costa & Tonidandel, table 8", run_dvg_table8},
      {"dvg-table9", "dynamic: recalculated paths", "Costa & Tonidandel, table 9", run_dvg_table9},
      {"dvg-table10", "dynamic: time from start to goal", "Costa & Tonidandel, table 10", run_dvg_table10},
      {"dvg-table11", "dynamic: collisions of a drive", "Costa & Tonidandel, table 11", run_dvg_table11},
      {"dvg-table12", "worst cases within 5 ms", "Costa & Tonidandel, table 12", run_dvg_table12},
      {"dvg-figures8-9", "leaf size of RRT's KD-tree", "Costa & Tonidandel, figures 8, 9", run_dvg_figures8_9},
      {"dvg-figures22-23", "dynamic: histograms of collisions", "Costa & Tonidandel, figures 22, 23",
       run_dvg_figures22_23},
      {"sbp-figures6-9", "success and spread of length against samples per batch", "Pinheiro et al., figures 6, 9",
       run_sbp_batches},
      {"sbp-figures7-8", "success and length against allowed time", "Pinheiro et al., figures 7, 8", run_sbp_times},
      {"sbp-figure10", "an ideal tracker, planning anew with every frame", "Pinheiro et al., figure 10",
       run_sbp_tracking},
      {"irrt-table1", "time and length of six planners on one map", "iterative RRT-Smooth, table I", run_irrt_table1},
      {"vis-wall", "31 plannings behind a wall of robots", "visibility sampling 2022, first table", run_vis_wall},
      {"vis-agents", "10,000 plannings with 12 agents; how long RRT* needs to be as good",
       "visibility sampling 2022, second table", run_vis_agents},
  };
  return kTables;
}

const PaperTable* find_paper_table(std::string_view name) {
  const auto tables = paper_tables();
  const auto found = std::find_if(tables.begin(), tables.end(), [&](const PaperTable& t) { return t.name == name; });
  return found == tables.end() ? nullptr : &*found;
}

void print_list(std::span<const PaperTable> tables, std::ostream& out) {
  std::size_t name_width = 0;
  std::size_t source_width = 0;
  for (const PaperTable& table : tables) {
    name_width = std::max(name_width, table.name.size());
    source_width = std::max(source_width, table.source.size());
  }
  for (const PaperTable& table : tables) {
    out << table.name << std::string(name_width - table.name.size() + 2, ' ') << table.source
        << std::string(source_width - table.source.size() + 2, ' ') << table.what << '\n';
  }
}

}  // namespace regista::bench
