#include <spdlog/fmt/fmt.h>

#include "modules/lockstep/scenario_run.h"

namespace regista {
namespace {

std::string times(const char* what, const Percentiles& p) {
  const auto us = [](std::int64_t ns) { return static_cast<double>(ns) * 1e-3; };
  return fmt::format("  {:<28} {:>10.1f} {:>10.1f} {:>10.1f} {:>10}\n", what, us(p.p50_ns), us(p.p99_ns), us(p.max_ns),
                     p.count);
}

std::string rates(const char* what, double yellow, double blue) {
  return fmt::format("  {:<28} {:>10.1f} {:>10.1f}\n", what, yellow, blue);
}

}  // namespace

std::string to_table(const RunSummary& summary) {
  const ContactCounts& contacts = summary.contacts;
  std::string table =
      fmt::format("{}: {} against {}, {:.1f} s simulated in {:.2f} s, {:.1f} times real time\n", summary.scenario.name,
                  summary.scenario.robots_per_team, summary.scenario.robots_per_team, summary.simulated_s,
                  summary.wall_s, summary.wall_s > 0.0 ? summary.simulated_s / summary.wall_s : 0.0);
  table += fmt::format("  {:<28} {:>10} {:>10}\n", "", "yellow", "blue");
  table += fmt::format("  {:<28} {:>10} {:>10}\n", "targets reached", summary.reached_yellow, summary.reached_blue);
  table += fmt::format("  {:<28} {:>10} {:>10}\n", "contacts inside the team", contacts.own_yellow, contacts.own_blue);
  table += fmt::format("  {:<28} {:>10} {:>10}\n", "contacts with opponents", contacts.opponent, contacts.opponent);
  table +=
      fmt::format("  {:<28} {:>10} {:>10}\n", "  of these at fault", contacts.at_fault_yellow, contacts.at_fault_blue);
  table += rates("side changes/robot/minute", summary.side_changes_yellow.all, summary.side_changes_blue.all);
  table += rates("  of these within 0.2 s", summary.side_changes_yellow.quick, summary.side_changes_blue.quick);
  table += fmt::format("  {:<28} {:>10} {:>10} {:>10} {:>10}\n", "time in us", "p50", "p99", "max", "count");
  table += times("planning, one robot", summary.robot_planning);
  table += times("planning, a team", summary.team_planning);
  table += times("loop, one vision frame", summary.frame);
  for (const Violation& violation : summary.violations) table += "  broken: " + to_string(violation) + "\n";
  return table;
}

}  // namespace regista
