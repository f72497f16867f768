#include "modules/bench/paper/vis_race.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "modules/bench/reference.h"

namespace regista::bench {
namespace {

constexpr const char* kMark = "visibility_sampling";

/// OMPL ends a search at a path that is shorter, not equally long.
constexpr double kNoLonger = 1.0 + 1e-9;
constexpr double kAnyLength_m = 1e9;

Racer::Until until_of(const DataTable& row) {
  if (!row.has("until")) return Racer::Until::end;
  const std::string text = row.text("until");
  if (text == "no_longer") return Racer::Until::no_longer;
  if (text == "first") return Racer::Until::first;
  throw std::runtime_error("until must be no_longer or first, not " + text);
}

/// The part of a path that is searched for: the way out of a covered start is the same for all.
double searched_m(const Plan& plan) {
  return plan.length_m - (plan.start_moved ? (plan.path[1] - plan.path[0]).norm() : 0.0);
}

bool is_straight(const Plan& plan) { return plan.path.size() <= (plan.start_moved ? 3U : 2U); }

struct Mark {
  double length_m = 0.0;
  double searched_m = 0.0;
  bool is_blocked = false;
};

void count(Racer& racer, const Shot& shot, const Mark& mark, bool solved) {
  const bool reached = solved && (racer.until != Racer::Until::no_longer ||
                                  searched_m(racer.contender.answer) <= mark.searched_m * kNoLonger);
  racer.trials.push_back({shot.total_us, mark.is_blocked, reached});
  if (solved && mark.is_blocked) racer.length_ratio.push_back(racer.contender.answer.length_m / mark.length_m);
}

void run_one(Racer& racer, const Scene& scene, const Mark& mark, double budget_us, Checker& checker) {
  if (racer.until != Racer::Until::end) {
    racer.params.ompl.stop_length_m =
        racer.until == Racer::Until::first ? kAnyLength_m : std::min(mark.searched_m * kNoLonger, kAnyLength_m);
    racer.contender.planner = make_planner(racer.planner, racer.params);
  }
  const Shot shot =
      plan_once(racer.contender, scene.world, scene.request, racer.until == Racer::Until::end ? 0.0 : budget_us);
  const bool fine = checker.check(racer.name, scene.world, scene.request, racer.contender.answer);
  count(racer, shot, mark, fine && racer.contender.answer.status == PlanStatus::ok);
}

Summary times_of(const Racer& racer, bool only_blocked) {
  std::vector<double> times_us;
  for (const Racer::Trial& trial : racer.trials) {
    if (trial.is_blocked || !only_blocked) times_us.push_back(trial.time_us);
  }
  return summarise(std::move(times_us));
}

/// The times as they would be with another full budget, shorter than that of the run.
Summary times_within(const Racer& racer, double budget_us, bool only_blocked) {
  std::vector<double> times_us;
  for (const Racer::Trial& trial : racer.trials) {
    if (only_blocked && !trial.is_blocked) continue;
    times_us.push_back(trial.reached ? std::min(trial.time_us, budget_us) : budget_us);
  }
  return summarise(std::move(times_us));
}

/// Of the blocked ones, those that got there within that time, in percent.
Cell reached_percent(const Racer& racer, double budget_us) {
  std::size_t reached = 0;
  std::size_t blocked = 0;
  for (const Racer::Trial& trial : racer.trials) {
    blocked += trial.is_blocked ? 1U : 0U;
    reached += trial.is_blocked && trial.reached && trial.time_us <= budget_us ? 1U : 0U;
  }
  return blocked == 0 ? Cell{} : Cell{100.0 * static_cast<double>(reached) / static_cast<double>(blocked)};
}

Cell ratio(double value, double over) { return over > 0.0 ? Cell{value / over} : Cell{}; }

const char* until_text(const Racer& racer) {
  switch (racer.until) {
    case Racer::Until::end:
      return "its end";
    case Racer::Until::first:
      return "first path";
    case Racer::Until::no_longer:
      break;
  }
  return "no longer than vis.";
}

}  // namespace

std::vector<Racer> racers_of(const DataTable& table) {
  std::vector<Racer> racers;
  for (const DataTable& row : table.tables("row")) {
    Racer racer;
    racer.name = row.text("name");
    racer.planner = row.has("planner") ? row.text("planner") : racer.name;
    racer.params = row.planning_params("params");
    racer.until = until_of(row);
    if (row.has("published_ms")) racer.published_ms = row.number("published_ms");
    racer.contender.name = racer.name;
    racer.contender.planner = make_planner(racer.planner, racer.params);
    racers.push_back(std::move(racer));
  }
  if (racers.empty() || racers.front().planner != kMark) {
    throw std::runtime_error(std::string("the first row must be ") + kMark);
  }
  return racers;
}

bool race(std::vector<Racer>& racers, const Scene& scene, double budget_us, std::size_t round, Checker& checker) {
  Racer& first = racers.front();
  Scene asked = scene;
  asked.request.budget.iterations = kUnlimitedIterations;
  const Shot shot = plan_once(first.contender, asked.world, asked.request);
  const Plan& plan = first.contender.answer;
  if (!checker.check(first.name, asked.world, asked.request, plan) || plan.status != PlanStatus::ok) return false;
  // Where start and goal are one point there is no search.
  const Mark mark{plan.length_m, plan.path.size() > 1 ? searched_m(plan) : 0.0, !is_straight(plan)};
  count(first, shot, mark, true);
  for (const std::size_t k : rotated(racers.size() - 1, round)) run_one(racers[k + 1], asked, mark, budget_us, checker);
  return true;
}

Table table_of(const std::vector<Racer>& racers, const std::string& title) {
  Table table{title,
              {{"planner"},
               {"until"},
               {"published", "ms"},
               {"measured mean", "ms"},
               {"p50", "ms"},
               {"p99", "ms"},
               {"blocked: mean", "ms"},
               {"p50", "ms"},
               {"got there", "%"},
               {"length / vis.", "x", 5},
               {"queries"},
               {"blocked"}}};
  for (const Racer& racer : racers) {
    const Summary all = times_of(racer, false);
    const Summary blocked = times_of(racer, true);
    const Summary length = summarise(racer.length_ratio);
    table.add({racer.name, std::string(until_text(racer)), racer.published_ms ? Cell{*racer.published_ms} : Cell{},
               all.mean * 1e-3, all.p50 * 1e-3, all.p99 * 1e-3, blocked.mean * 1e-3, blocked.p50 * 1e-3,
               reached_percent(racer, std::numeric_limits<double>::infinity()),
               length.count > 0 ? Cell{length.mean} : Cell{}, count_cell(all.count), count_cell(blocked.count)});
  }
  table.notes = {"time: one query from nothing, single shots, all planners in turn; vis.: visibility_sampling",
                 "blocked: the straight line is not free; got there, length: of these",
                 "the median of all queries is a free straight line, which no planner searches for",
                 "what RRT* answered in the post is not said: here it ends as 'until' says, or with its full budget"};
  return table;
}

Table ratios_of(const std::vector<Racer>& racers, const std::string& title, const std::vector<double>& budgets_ms) {
  Table table{title,
              {{"planner"},
               {"until"},
               {"full budget", "ms"},
               {"got there", "%"},
               {"all: means", "x"},
               {"all: medians", "x"},
               {"blocked: means", "x"},
               {"blocked: medians", "x"}}};
  std::optional<double> own_ms, star_ms;
  const Summary all = times_of(racers.front(), false);
  const Summary blocked = times_of(racers.front(), true);
  for (const Racer& racer : racers) {
    if (racer.published_ms) (racer.until == Racer::Until::end ? own_ms : star_ms) = racer.published_ms;
    if (racer.until == Racer::Until::end) continue;
    for (const double budget_ms : budgets_ms) {
      const Summary a = times_within(racer, 1e3 * budget_ms, false);
      const Summary b = times_within(racer, 1e3 * budget_ms, true);
      table.add({racer.name, std::string(until_text(racer)), budget_ms, reached_percent(racer, 1e3 * budget_ms),
                 ratio(a.mean, all.mean), ratio(a.p50, all.p50), ratio(b.mean, blocked.mean),
                 ratio(b.p50, blocked.p50)});
    }
  }
  if (own_ms && star_ms) {
    table.rows.insert(table.rows.begin(), {std::string("published"), {}, {}, {}, *star_ms / *own_ms, {}, {}, {}});
  }
  table.notes = {
      "time over that of visibility_sampling, same run; whoever has not got there counts with the full budget",
      "published: RRT* over the post's own planner, which has one graph per robot"};
  return table;
}

Plot ratio_plot_of(const std::vector<Racer>& racers, const std::string& title, const std::vector<double>& budgets_ms) {
  Plot plot{title, {"full budget", "ms", true}, {"time over that of visibility_sampling", "", true}};
  const Summary mark = times_of(racers.front(), true);
  if (mark.count == 0) return plot;
  for (const Racer& racer : racers) {
    if (racer.until == Racer::Until::end) continue;
    Series series{racer.name, {}};
    for (const double budget_ms : budgets_ms) {
      series.points.push_back({budget_ms, times_within(racer, 1e3 * budget_ms, true).mean / mark.mean});
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

Plot times_of(const std::vector<Racer>& racers, const std::string& title) {
  Plot plot{title, {"planner"}, {"time", "µs", true}};
  for (const Racer& racer : racers) {
    const Summary blocked = times_of(racer, true);
    if (blocked.count > 0) plot.boxes.push_back({racer.name, blocked});
  }
  return plot;
}

}  // namespace regista::bench
