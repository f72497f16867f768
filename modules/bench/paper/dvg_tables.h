// The tables and figures of Costa & Tonidandel: DVG+A* against RRT, one function each.
#pragma once

#include "modules/bench/paper/paper.h"

namespace regista::bench {

int run_dvg_table1(const PaperOptions& options, const Run& run);        ///< edge limit off and on
int run_dvg_table2(const PaperOptions& options, const Run& run);        ///< grouping off and on
int run_dvg_table3(const PaperOptions& options, const Run& run);        ///< sizes of groups
int run_dvg_table4(const PaperOptions& options, const Run& run);        ///< worst case for DVG+A*
int run_dvg_table5(const PaperOptions& options, const Run& run);        ///< worst case for RRT
int run_dvg_table6(const PaperOptions& options, const Run& run);        ///< mixed
int run_dvg_table7(const PaperOptions& options, const Run& run);        ///< stoppage
int run_dvg_figures8_9(const PaperOptions& options, const Run& run);    ///< leaf size
int run_dvg_table8(const PaperOptions& options, const Run& run);        ///< dynamic: planning time
int run_dvg_table9(const PaperOptions& options, const Run& run);        ///< dynamic: recalculated paths
int run_dvg_table10(const PaperOptions& options, const Run& run);       ///< dynamic: navigation time
int run_dvg_table11(const PaperOptions& options, const Run& run);       ///< dynamic: collisions
int run_dvg_table12(const PaperOptions& options, const Run& run);       ///< within 5 ms
int run_dvg_figures22_23(const PaperOptions& options, const Run& run);  ///< dynamic: histograms of collisions

}  // namespace regista::bench
