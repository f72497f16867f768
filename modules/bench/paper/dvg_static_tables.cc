// Tables 1, 2 and 4 to 7, and figures 8 and 9: static scenarios.
#include "modules/bench/paper/dvg_static.h"
#include "modules/bench/paper/dvg_tables.h"

namespace regista::bench {

int run_dvg_table1(const PaperOptions& options, const Run& run) {
  DvgParams without;
  without.edge_limit = false;
  Entrants entrants;
  entrants.push_back(published_dvg("dvg, no limit", without));
  entrants.push_back(published_dvg("dvg", {}));
  add_ours(entrants);
  return run_static_test(
      {"dvg-table1: edges limited to the distance of the centres, or not", "dvg_table1", "table1", "dvg_connections"},
      std::move(entrants), options, run);
}

int run_dvg_table2(const PaperOptions& options, const Run& run) {
  DvgParams grouped = grouped_dvg_params();
  grouped.group_distance_m = load_dvg_scenario("dvg_worst_dvg").group_distance_m;
  Entrants entrants;
  entrants.push_back(published_dvg("dvg", {}));
  entrants.push_back(published_dvg("dvg, grouped", grouped));
  add_ours(entrants);
  return run_static_test({"dvg-table2: near objects as one, or not", "dvg_table2", "table2", "dvg_worst_dvg"},
                         std::move(entrants), options, run);
}

int run_dvg_table4(const PaperOptions& options, const Run& run) {
  return run_static_test({"dvg-table4: worst case for DVG+A*", "dvg_table4", "table4", "dvg_worst_dvg"},
                         dvg_and_rrt_and_ours(), options, run);
}

int run_dvg_table5(const PaperOptions& options, const Run& run) {
  return run_static_test({"dvg-table5: worst case for RRT", "dvg_table5", "table5", "dvg_worst_rrt"},
                         dvg_and_rrt_and_ours(), options, run);
}

int run_dvg_table6(const PaperOptions& options, const Run& run) {
  return run_static_test({"dvg-table6: mixed", "dvg_table6", "table6", "dvg_mixed"}, dvg_and_rrt_and_ours(), options,
                         run);
}

int run_dvg_table7(const PaperOptions& options, const Run& run) {
  return run_static_test({"dvg-table7: positioning during a stoppage", "dvg_table7", "table7", "dvg_stoppage"},
                         dvg_and_rrt_and_ours(), options, run);
}

int run_dvg_figures8_9(const PaperOptions& options, const Run& run) {
  Entrants entrants;
  for (const std::int64_t leaf_size : {5, 10, 20, 200, 500}) {
    RrtParams params;
    params.leaf_size = leaf_size;
    entrants.push_back(published_rrt("rrt, leaf " + std::to_string(leaf_size), params));
  }
  return run_static_test({"dvg-figures8-9: leaf size of RRT's KD-tree",
                          "dvg_figures8_9",
                          "",
                          "dvg_mixed",
                          {"the figures are lost and print no numbers; the text: time and length do not change "
                           "considerably with the leaf size, except for 20; 5 has the lowest maximum of time",
                           "the paper does not say in which scenario; this is the mixed one"}},
                         std::move(entrants), options, run);
}

}  // namespace regista::bench
