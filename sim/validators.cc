#include "sim/validators.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace regista {
namespace {

// Rounding is no violation: metres, m/s, rad/s alike.
constexpr double kSlack = 1e-9;

Violation violation(std::optional<RobotId> robot, double value, double bound, std::string unit) {
  return {"", Time{}, robot, value, bound, std::move(unit)};
}

}  // namespace

std::string to_string(const Violation& violation) {
  const std::string who = violation.robot ? " by " + to_string(*violation.robot) : "";
  return violation.validator + " violated at " + params_detail::print(to_seconds(violation.at.time_since_epoch())) +
         " s" + who + ": " + params_detail::print(violation.value) + " against " +
         params_detail::print(violation.bound) + (violation.unit.empty() ? "" : " " + violation.unit);
}

Validator inside_field(const FieldGeometry& field, double radius_m) {
  const Vec2 limit = half_extent(field, radius_m);
  return {"inside the field", Validator::When::always, [limit](const Observation& seen) -> std::optional<Violation> {
            for (const RobotState& robot : seen.truth.robots) {
              for (int axis = 0; axis < 2; ++axis) {
                const double value = std::abs(robot.pose.position_m[axis]);
                if (!(value <= limit[axis] + kSlack)) return violation(robot.id, value, limit[axis], "m");
              }
            }
            return std::nullopt;
          }};
}

Validator within_speed_limits(const RobotLimits& limits) {
  return {"speed limits", Validator::When::always, [limits](const Observation& seen) -> std::optional<Violation> {
            for (const RobotState& robot : seen.truth.robots) {
              const double speed = robot.twist.velocity_mps.norm();
              const double turning = std::abs(robot.twist.angular_radps);
              if (!(speed <= limits.speed_max_mps + kSlack)) {
                return violation(robot.id, speed, limits.speed_max_mps, "m/s");
              }
              if (!(turning <= limits.angular_speed_max_radps + kSlack)) {
                return violation(robot.id, turning, limits.angular_speed_max_radps, "rad/s");
              }
            }
            return std::nullopt;
          }};
}

Validator targets_reached(Team team, std::int64_t count_min) {
  return {std::string("targets reached by ") + name(team), Validator::When::at_end,
          [team, count_min](const Observation& seen) -> std::optional<Violation> {
            const std::int64_t count = team == Team::yellow ? seen.reached_yellow : seen.reached_blue;
            if (count >= count_min) return std::nullopt;
            return violation(std::nullopt, static_cast<double>(count), static_cast<double>(count_min), "");
          }};
}

Validator own_contacts_at_most(std::int64_t count_max) {
  return {"contacts inside teams", Validator::When::always,
          [count_max](const Observation& seen) -> std::optional<Violation> {
            const std::int64_t count = seen.contacts.own_yellow + seen.contacts.own_blue;
            if (count <= count_max) return std::nullopt;
            return violation(std::nullopt, static_cast<double>(count), static_cast<double>(count_max), "");
          }};
}

std::vector<Validator> validators_of(const Scenario& scenario, const RobotLimits& limits) {
  std::vector<Validator> validators{inside_field(field_of(scenario), limits.radius_m), within_speed_limits(limits)};
  if (scenario.expect.targets_per_team_min > 0) {
    for (const Team team : {Team::yellow, Team::blue}) {
      validators.push_back(targets_reached(team, scenario.expect.targets_per_team_min));
    }
  }
  if (scenario.expect.own_contacts_max >= 0) {
    validators.push_back(own_contacts_at_most(scenario.expect.own_contacts_max));
  }
  return validators;
}

void Validation::observe(const Observation& observation) {
  for (const Validator& validator : validators_) {
    if (validator.when == Validator::When::always) check(validator, observation);
  }
}

void Validation::finish(const Observation& observation) {
  for (const Validator& validator : validators_) check(validator, observation);
}

void Validation::check(const Validator& validator, const Observation& observation) {
  const bool known = std::any_of(violations_.begin(), violations_.end(),
                                 [&](const Violation& seen) { return seen.validator == validator.name; });
  if (known) return;
  std::optional<Violation> found = validator.check(observation);
  if (!found) return;
  found->validator = validator.name;
  found->at = observation.truth.captured;
  violations_.push_back(*found);
}

}  // namespace regista
