#include "sim/task.h"

#include <algorithm>
#include <cmath>

namespace regista {
namespace {

// Streams 0–15 of a scenario's seed belong to the simulator.
constexpr std::uint64_t kTaskStream = 16;

bool in_own_area(const Vec2& point_m, Team team, const FieldGeometry& field, double radius_m) {
  const double towards_goal = defends_negative_x(team, field) ? -point_m.x() : point_m.x();
  return towards_goal > field.length_m / 2.0 - field.defence_depth_m - radius_m &&
         std::abs(point_m.y()) < field.defence_width_m / 2.0 + radius_m;
}

}  // namespace

StandTargets::StandTargets(Team team, const FieldGeometry& field) : field_(field) { targets_.team = team; }

const Targets& StandTargets::update(const WorldState& world) {
  bool changed = false;
  for (const RobotState& robot : world.robots) {
    if (robot.id.team != targets_.team) continue;
    auto& all = targets_.targets;
    const auto place =
        std::lower_bound(all.begin(), all.end(), robot.id.number,
                         [](const Target& target, std::uint16_t number) { return target.robot < number; });
    if (place != all.end() && place->robot == robot.id.number) continue;
    Target target;
    target.robot = robot.id.number;
    target.pose = robot.pose;
    // Whoever stands there at the beginning may stay.
    target.may_enter_own_area = in_own_area(robot.pose.position_m, targets_.team, field_, RobotLimits{}.radius_m);
    all.insert(place, target);
    changed = true;
  }
  if (changed) {
    targets_.captured = world.captured;
    ++targets_.sequence;
  }
  return targets_;
}

Task make_task(const Scenario& scenario, Team team) {
  validate(scenario);
  const FieldGeometry field = field_of(scenario);
  if (scenario.task == "stand") return StandTargets(team, field);
  RandomTargetsParams params;
  params.distance_min_m = scenario.target_distance_min_m;
  params.arrival_m = scenario.arrival_m;
  const std::uint64_t stream = kTaskStream + (team == Team::yellow ? 0 : 1);
  return RandomTargets(team, field, params, mixed(static_cast<std::uint64_t>(scenario.seed), stream));
}

const Targets& update(Task& task, const WorldState& world) {
  return std::visit([&](auto& kind) -> const Targets& { return kind.update(world); }, task);
}

std::int64_t reached(const Task& task) {
  const auto* random = std::get_if<RandomTargets>(&task);
  return random != nullptr ? random->reached() : 0;
}

}  // namespace regista
