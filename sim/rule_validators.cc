#include "sim/rule_validators.h"

#include <cmath>

#include "world_model/types/field_side.h"

namespace regista {
namespace {

constexpr double kStopSpeed_mps = 1.5;
constexpr double kBallDistance_m = 0.5;
constexpr double kAreaDistance_m = 0.2;
constexpr double kBallRadius_m = 0.0215;
constexpr double kStill_mps = 1e-3;  // the simulator brakes to an exact stop, vision's noise makes controllers settle

/// What is measured of a robot, and the bound it must keep.
using Measure = std::function<std::optional<double>(const RobotState&, const WorldState&)>;

/// From the grace's end on, every robot's measure is at least (or at most) the bound.
Validator after_grace(std::string name, double bound, bool at_least, std::string unit, Measure measure) {
  return {std::move(name), Validator::When::always,
          [bound, at_least, unit = std::move(unit), measure = std::move(measure),
           began = std::optional<Time>()](const Observation& seen) mutable -> std::optional<Violation> {
            if (!began) began = seen.truth.captured;
            if (seen.truth.captured - *began < kRuleGrace) return std::nullopt;
            for (const RobotState& robot : seen.truth.robots) {
              const std::optional<double> value = measure(robot, seen.truth);
              const bool kept = !value || (at_least ? *value >= bound : *value <= bound);
              if (!kept) return Violation{"", Time{}, robot.id, *value, bound, unit};
            }
            return std::nullopt;
          }};
}

double speed(const RobotState& robot) { return robot.twist.velocity_mps.norm(); }

/// From a body to the defence area on that side (-1, 1), which reaches behind the goal line as far as one likes.
double area_distance(const Vec2& place_m, double side, const FieldGeometry& field, double robot_radius_m) {
  const double before_m = field.length_m / 2.0 - field.defence_depth_m - side * place_m.x();
  const double beside_m = std::abs(place_m.y()) - field.defence_width_m / 2.0;
  return std::hypot(std::max(before_m, 0.0), std::max(beside_m, 0.0)) - robot_radius_m;
}

}  // namespace

Validator stop_speed_kept() {
  return after_grace("speed in stop", kStopSpeed_mps, false, "m/s",
                     [](const RobotState& robot, const WorldState&) { return speed(robot); });
}

Validator halt_kept() {
  return after_grace("standing at halt", kStill_mps, false, "m/s",
                     [](const RobotState& robot, const WorldState&) { return speed(robot); });
}

Validator ball_distance_kept(std::optional<Team> exempt, double robot_radius_m) {
  return after_grace(
      "distance from the ball", kBallDistance_m, true, "m",
      [exempt, robot_radius_m](const RobotState& robot, const WorldState& world) -> std::optional<double> {
        if (!world.ball || robot.id.team == exempt) return std::nullopt;
        return (robot.pose.position_m - world.ball->position_m).norm() - robot_radius_m - kBallRadius_m;
      });
}

Validator placement_kept(std::optional<Team> placing, const Vec2& place_m, double robot_radius_m) {
  return after_grace(
      "distance from the placement", kBallDistance_m, true, "m",
      [placing, place_m, robot_radius_m](const RobotState& robot, const WorldState& world) -> std::optional<double> {
        if (!world.ball || robot.id.team == placing) return std::nullopt;
        const Vec2& centre_m = robot.pose.position_m;
        return (centre_m - nearest_on_segment(centre_m, world.ball->position_m, place_m)).norm() - robot_radius_m;
      });
}

Validator area_distance_kept(const FieldGeometry& field, double robot_radius_m) {
  return after_grace("distance from the opponent's area", kAreaDistance_m, true, "m",
                     [field, robot_radius_m](const RobotState& robot, const WorldState&) {
                       const double side = defends_negative_x(robot.id.team, field) ? 1.0 : -1.0;
                       return area_distance(robot.pose.position_m, side, field, robot_radius_m);
                     });
}

std::vector<Validator> rule_validators(const Scenario& scenario, const RobotLimits& limits) {
  const std::optional<GameState> game = stated_game(scenario);
  if (!game) return {};
  switch (game->command) {
    case GameCommand::halt:
      return {halt_kept()};
    case GameCommand::stop:
      return {stop_speed_kept(), ball_distance_kept(std::nullopt, limits.radius_m),
              area_distance_kept(field_of(scenario), limits.radius_m)};
    case GameCommand::kick_off:
      return {ball_distance_kept(game->team, limits.radius_m)};
    case GameCommand::ball_placement:
      return {placement_kept(game->team, game->placement_m.value_or(Vec2::Zero()), limits.radius_m)};
    default:
      return {};
  }
}

}  // namespace regista
