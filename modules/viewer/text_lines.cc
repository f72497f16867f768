#include <algorithm>
#include <cstdio>

#include "modules/viewer/scene_drawing.h"

namespace regista {
namespace {

std::string p50_and_max(const DurationSummary& times) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f / %.3f", static_cast<double>(times.p50_ns) * 1e-6,
                static_cast<double>(times.max_ns) * 1e-6);
  return text;
}

TextLine team_line(const ViewerScene& scene, Team team) {
  const TeamScene& play = scene.of(team);
  std::string text = team == Team::yellow ? "yellow" : "blue  ";
  if (!play.plans.empty()) text += "  " + play.plans.begin()->second.planner;
  if (play.planning_robot) text += "   planning p50 / max: robot " + p50_and_max(*play.planning_robot);
  if (play.planning_team) text += "  team " + p50_and_max(*play.planning_team) + " ms";
  return {text, color_of(team)};
}

}  // namespace

std::vector<TextLine> team_lines(const ViewerScene& scene) {
  return {team_line(scene, Team::yellow), team_line(scene, Team::blue)};
}

std::vector<TextLine> state_lines(const ViewerScene& scene) {
  const auto yellow = std::count_if(scene.world.robots.begin(), scene.world.robots.end(),
                                    [](const RobotState& robot) { return robot.id.team == Team::yellow; });
  const auto all = static_cast<std::ptrdiff_t>(scene.world.robots.size());
  char text[64];
  std::snprintf(text, sizeof text, "%td : %td robots  %6.2f s", yellow, all - yellow,
                to_seconds(scene.world.captured - scene.began));
  return {{text, palette::kFieldLine}, {scene.notice, palette::kWarning}};
}

}  // namespace regista
