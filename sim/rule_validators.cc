#include "sim/rule_validators.h"

#include <cmath>
#include <map>

#include "world_model/types/field_side.h"

namespace regista {
namespace {

constexpr double kStopSpeed_mps = 1.5;
constexpr double kBallDistance_m = 0.5;
constexpr double kAreaDistance_m = 0.2;
constexpr double kBallRadius_m = 0.0215;
constexpr double kStill_mps = 0.05;  // less is vision's noise, to which controllers answer

/// What is measured of a robot, and the bound it must keep.
using Measure = std::function<std::optional<double>(const RobotState&, const WorldState&)>;

/// The bound, and whether a measure is to be at least or at most that.
struct Bound {
  double value = 0.0;
  bool at_least = true;
  const char* unit = "";
  bool holds(std::optional<double> measured) const {
    return !measured || (at_least ? *measured >= value : *measured <= value);
  }
};

/// Every robot's measure keeps the bound, but for the grace.
Validator kept(std::string name, const Bound& bound, Grace grace, Measure measure) {
  return {std::move(name), Validator::When::always,
          [bound, grace, measure = std::move(measure), began = std::optional<Time>(),
           kept_at = std::map<RobotId, Time>()](const Observation& seen) mutable -> std::optional<Violation> {
            const Time now = seen.truth.captured;
            if (!began) began = now;
            for (const RobotState& robot : seen.truth.robots) {
              const std::optional<double> value = measure(robot, seen.truth);
              Time& last_kept = kept_at.try_emplace(robot.id, *began).first->second;
              if (grace == Grace::each_stay && bound.holds(value)) last_kept = now;
              if (now - last_kept < kRuleGrace || bound.holds(value)) continue;
              return Violation{"", Time{}, robot.id, *value, bound.value, bound.unit};
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
  return kept("speed in stop", {kStopSpeed_mps, false, "m/s"}, Grace::at_first,
              [](const RobotState& robot, const WorldState&) { return speed(robot); });
}

Validator halt_kept() {
  return kept("standing at halt", {kStill_mps, false, "m/s"}, Grace::at_first,
              [](const RobotState& robot, const WorldState&) { return speed(robot); });
}

Validator ball_distance_kept(std::optional<Team> exempt, double robot_radius_m, Grace grace) {
  return kept("distance from the ball", {kBallDistance_m, true, "m"}, grace,
              [exempt, robot_radius_m](const RobotState& robot, const WorldState& world) -> std::optional<double> {
                if (!world.ball || robot.id.team == exempt) return std::nullopt;
                return (robot.pose.position_m - world.ball->position_m).norm() - robot_radius_m - kBallRadius_m;
              });
}

Validator placement_kept(std::optional<Team> placing, const Vec2& place_m, double robot_radius_m, Grace grace) {
  return kept(
      "distance from the placement", {kBallDistance_m, true, "m"}, grace,
      [placing, place_m, robot_radius_m](const RobotState& robot, const WorldState& world) -> std::optional<double> {
        if (!world.ball || robot.id.team == placing) return std::nullopt;
        const Vec2& centre_m = robot.pose.position_m;
        return (centre_m - nearest_on_segment(centre_m, world.ball->position_m, place_m)).norm() - robot_radius_m;
      });
}

Validator area_distance_kept(const FieldGeometry& field, double robot_radius_m, Grace grace) {
  return kept("distance from the opponent's area", {kAreaDistance_m, true, "m"}, grace,
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
      return {stop_speed_kept(), ball_distance_kept(std::nullopt, limits.radius_m, Grace::each_stay),
              area_distance_kept(field_of(scenario), limits.radius_m, Grace::each_stay)};
    case GameCommand::kick_off:
      return {ball_distance_kept(game->team, limits.radius_m, Grace::each_stay)};
    case GameCommand::ball_placement:
      return {placement_kept(game->team, game->placement_m.value_or(Vec2::Zero()), limits.radius_m, Grace::each_stay)};
    default:
      return {};
  }
}

}  // namespace regista
