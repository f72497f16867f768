#include "modules/bench/motion/crowd_report.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "modules/bench/summary.h"

namespace regista::bench {
namespace {

/// The pass-through row of the same field and preset; nullptr where it was not played.
const CrowdRow* free_of(const std::vector<CrowdRow>& rows, const CrowdGame& game) {
  for (const CrowdRow& row : rows) {
    const bool same = row.game.division == game.division && row.game.preset == game.preset;
    if (same && row.game.opponents == Opponents::none) return &row;
  }
  return nullptr;
}

std::vector<Cell> game_cells(const CrowdGame& game) { return {game.division, game.preset, name(game.opponents)}; }

std::string how(const CrowdOptions& options) {
  std::string text = "driven by " + (options.system.planner.empty() ? "the default planner" : options.system.planner);
  if (!options.system.safety.empty()) text += ", safety " + options.system.safety;
  for (const std::string& setting : options.system.settings) text += ", " + setting;
  return text + (options.seeds == SeedSet::tuning ? "; tuning seeds" : "; reporting seeds");
}

/// One value of every game as bars: a group per preset, a bar per opponents.
Plot bars(const std::string& title, const Axis& y, const std::vector<CrowdRow>& rows, const CrowdOptions& options,
          const std::string& division, double (*value)(const CrowdRow& row, const CrowdRow* free)) {
  std::string label = "preset:";
  std::map<std::string, double> place;
  for (const std::string& preset : options.presets) {
    const double x = place.try_emplace(preset, static_cast<double>(place.size()) + 1.0).first->second;
    label += " " + std::to_string(std::lround(x)) + " " + preset;
  }
  Plot plot{title + ", division " + division, {label}, y};
  std::map<Opponents, Series> series;
  for (const CrowdRow& row : rows) {
    if (row.game.division != division || row.game.opponents == Opponents::none) continue;
    Series& one =
        series.try_emplace(row.game.opponents, Series{name(row.game.opponents), {}, Series::Style::bars}).first->second;
    one.points.push_back({place.at(row.game.preset), value(row, free_of(rows, row.game))});
  }
  for (auto& [opponents, one] : series) plot.series.push_back(std::move(one));
  plot.x.low = 0.5;
  plot.x.high = static_cast<double>(place.size()) + 0.5;
  plot.y.low = 0.0;
  const auto is_zero = [](const PlotPoint& point) { return point.y == 0.0; };
  const bool flat = std::all_of(plot.series.begin(), plot.series.end(), [&](const Series& one) {
    return std::all_of(one.points.begin(), one.points.end(), is_zero);
  });
  if (flat) plot.y.high = 1.0;  // gnuplot draws no axis from 0 to 0
  return plot;
}

}  // namespace

Table crowd_scores(const std::vector<CrowdRow>& rows, const CrowdOptions& options) {
  Table table{"crowd: our 11 to random targets among 11 opponents",
              {{"field"},
               {"preset"},
               {"opponents"},
               {"minutes"},
               {"reached", "1/min"},
               {"of pass-through", "%"},
               {"own contacts"},
               {"own", "1/robot-min"},
               {"of these pushed", "1/robot-min"},
               {"own touching", "s/robot-min"},
               {"with opponents", "1/robot-min"},
               {"our fault", "1/robot-min"},
               {"of these pushed too", "1/robot-min"}}};
  for (const CrowdRow& row : rows) {
    const CrowdGame& game = row.game;
    const CrowdScore& score = row.score;
    const CrowdRow* free = free_of(rows, game);
    const ContactTally& contacts = score.contacts;
    const auto rate = [&score](auto count) { return score.per_robot_minute(static_cast<double>(count)); };
    std::vector<Cell> cells = game_cells(game);
    cells.insert(cells.end(), {score.minutes, score.pace(), Cell(), contacts.own, rate(contacts.own),
                               rate(contacts.own_pushed), rate(contacts.own_touching_s), rate(contacts.opponent),
                               rate(contacts.at_fault), rate(contacts.at_fault_pushed)});
    if (free != nullptr && free->score.reached > 0) cells[5] = 100.0 * score.pace() / free->score.pace();
    table.add(cells);
  }
  table.notes = {
      how(options),
      "opponents: system as we are; random: straight to random targets at up to 2 m/s, avoiding nobody; "
      "chaser: to our nearest robot at 3 m/s; none: our robots pass through each other",
      "pushed: within 1 s after an opponent touched one of ours that meet, or a team-mate it had pushed did; "
      "fault by the crash rule"};
  return table;
}

Table crowd_costs(const std::vector<CrowdRow>& rows) {
  Table table{"crowd: time of a tick of our team of 11 among 22",
              {{"field"},
               {"preset"},
               {"opponents"},
               {"ticks"},
               {"planning mean", "us"},
               {"p99", "us"},
               {"control mean", "us"},
               {"p99 of it", "us"},
               {"simulated", "x real time"}}};
  for (const auto& [game, score] : rows) {
    if (score.times.empty()) continue;
    std::vector<double> planning, control;
    for (const DriveTime& time : score.times) {
      planning.push_back(time.planning_us);
      control.push_back(time.control_us);
    }
    const Summary plan = summarise(std::move(planning));
    const Summary act = summarise(std::move(control));
    std::vector<Cell> cells = game_cells(game);
    cells.insert(cells.end(),
                 {count_cell(plan.count), plan.mean, plan.p99, act.mean, act.p99, 60.0 * score.minutes / score.cpu_s});
    table.add(cells);
  }
  table.notes = {
      "single shots of the whole team, time of the core it runs on; simulated: likewise, both teams and all"};
  return table;
}

void add_crowd_plots(Report& report, const std::vector<CrowdRow>& rows, const CrowdOptions& options) {
  for (const std::string& division : options.fields) {
    if (options.opponents.empty()) return;
    report.add("crowd_own_" + division,
               bars("contacts among our own", {"contacts", "1/robot-min"}, rows, options, division,
                    [](const CrowdRow& row, const CrowdRow*) {
                      return row.score.per_robot_minute(static_cast<double>(row.score.contacts.own));
                    }));
    if (!options.pass_through) continue;
    report.add("crowd_pace_" + division, bars("targets reached, of pass-through", {"share", "%"}, rows, options,
                                              division, [](const CrowdRow& row, const CrowdRow* free) {
                                                const double most = free->score.pace();
                                                return most > 0.0 ? 100.0 * row.score.pace() / most : 0.0;
                                              }));
  }
}

}  // namespace regista::bench
