// How long RRT*, which never ends by itself, needs for what visibility_sampling answers: it plans the same query until
// its path is no longer, or until its first path, or until its budget is spent. Interleaved with the other planners.
#pragma once

#include "modules/bench/bench.h"
#include "modules/bench/paper/sampling_data.h"

namespace regista::bench {

/// One planner of a race. The first of all is visibility_sampling, whose length is the mark.
struct Racer {
  enum class Until { end, no_longer, first };
  std::string name;
  std::string planner;  ///< of the registry
  PlanningParams params;
  Until until = Until::end;
  std::optional<double> published_ms = {};
  Contender contender = {};
  struct Trial {
    double time_us = 0.0;
    bool is_blocked = false;  ///< the straight line is not free
    bool reached = false;     ///< ended as it should, not by its budget
  };
  std::vector<Trial> trials = {};
  std::vector<double> length_ratio = {};  ///< over the length of the mark, where blocked
};

/// From the rows of a table of the data file. Throws std::runtime_error where the first is not visibility_sampling.
std::vector<Racer> racers_of(const DataTable& table);

/// All of them on one scene; budget_us is the full budget of those that do not end by themselves. False, and nothing is
/// counted, where visibility_sampling finds no path.
bool race(std::vector<Racer>& racers, const Scene& scene, double budget_us, std::size_t round, Checker& checker);

Table table_of(const std::vector<Racer>& racers, const std::string& title);

/// For each RRT*, and for each full budget up to that of the run: its time over that of visibility_sampling. Whoever
/// has not got there in the full budget counts with it.
Table ratios_of(const std::vector<Racer>& racers, const std::string& title, const std::vector<double>& budgets_ms);

/// The same ratio of means, where blocked, against the full budget.
Plot ratio_plot_of(const std::vector<Racer>& racers, const std::string& title, const std::vector<double>& budgets_ms);

/// Boxes of the times where the straight line is blocked.
Plot times_of(const std::vector<Racer>& racers, const std::string& title);

}  // namespace regista::bench
