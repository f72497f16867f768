#include "sim/validators.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sim/rule_validators.h"

namespace regista {
namespace {

// Rounding is no violation: metres, m/s, rad/s alike.
constexpr double kSlack = 1e-9;

Violation violation(std::optional<RobotId> robot, double value, double bound, std::string unit) {
  return {"", Time{}, robot, value, bound, std::move(unit)};
}

std::optional<Violation> too_fast(RobotId robot, double speed_mps, double turning_radps, const RobotLimits& limits) {
  if (!(speed_mps <= limits.speed_max_mps + kSlack)) {
    return violation(robot, speed_mps, limits.speed_max_mps, "m/s");
  }
  if (!(std::abs(turning_radps) <= limits.angular_speed_max_radps + kSlack)) {
    return violation(robot, std::abs(turning_radps), limits.angular_speed_max_radps, "rad/s");
  }
  return std::nullopt;
}

std::optional<Violation> too_many(std::int64_t count, std::int64_t count_max) {
  if (count <= count_max) return std::nullopt;
  return violation(std::nullopt, static_cast<double>(count), static_cast<double>(count_max), "");
}

/// One robot's stay in a defence area.
struct AreaStay {
  std::optional<Time> since;  // when it came in; empty while it is outside
  bool may_stay = false;      // it began there
};

bool is_wholly_in_area(const Vec2& centre_m, const FieldGeometry& field, double radius_m) {
  const double x = std::abs(centre_m.x());
  return x > field.length_m / 2.0 - field.defence_depth_m + radius_m && x < field.length_m / 2.0 &&
         std::abs(centre_m.y()) < field.defence_width_m / 2.0 - radius_m;
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
              auto found = too_fast(robot.id, robot.twist.velocity_mps.norm(), robot.twist.angular_radps, limits);
              if (found) return found;
            }
            return std::nullopt;
          }};
}

Validator commands_within_limits(const RobotLimits& limits) {
  return {
      "commands within limits", Validator::When::always, [limits](const Observation& seen) -> std::optional<Violation> {
        for (const TeamCommands& team : seen.commands) {
          for (const RobotCommand& command : team.commands) {
            const BodyVelocity& v = command.velocity;
            auto found =
                too_fast({team.team, command.robot}, std::hypot(v.forward_mps, v.left_mps), v.angular_radps, limits);
            if (found) return found;
          }
        }
        return std::nullopt;
      }};
}

Validator defence_areas_kept(const FieldGeometry& field, double radius_m) {
  return {"defence areas kept", Validator::When::always,
          [field, radius_m,
           stays = std::map<RobotId, AreaStay>()](const Observation& seen) mutable -> std::optional<Violation> {
            const Time now = seen.truth.captured;
            for (const RobotState& robot : seen.truth.robots) {
              const bool inside = is_wholly_in_area(robot.pose.position_m, field, radius_m);
              const auto [entry, is_new] = stays.try_emplace(robot.id);
              AreaStay& stay = entry->second;
              if (is_new) stay.may_stay = inside;
              if (!inside) stay = {};
              if (!inside || stay.may_stay) continue;
              if (!stay.since) stay.since = now;
              if (now - *stay.since <= kAreaStay) continue;
              return violation(robot.id, to_seconds(now - *stay.since), to_seconds(kAreaStay), "s");
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
  return {"contacts inside teams", Validator::When::always, [count_max](const Observation& seen) {
            return too_many(seen.contacts.own_yellow + seen.contacts.own_blue, count_max);
          }};
}

Validator opponent_contacts_at_most(std::int64_t count_max) {
  return {"contacts between teams", Validator::When::always,
          [count_max](const Observation& seen) { return too_many(seen.contacts.opponent, count_max); }};
}

std::vector<Validator> validators_of(const Scenario& scenario, const RobotLimits& limits) {
  const FieldGeometry field = field_of(scenario);
  std::vector<Validator> validators{inside_field(field, limits.radius_m), within_speed_limits(limits),
                                    commands_within_limits(limits), defence_areas_kept(field, limits.radius_m)};
  if (scenario.expect.targets_per_team_min > 0) {
    for (const Team team : {Team::yellow, Team::blue}) {
      validators.push_back(targets_reached(team, scenario.expect.targets_per_team_min));
    }
  }
  if (scenario.expect.own_contacts_max >= 0) {
    validators.push_back(own_contacts_at_most(scenario.expect.own_contacts_max));
  }
  if (scenario.expect.opponent_contacts_max >= 0) {
    validators.push_back(opponent_contacts_at_most(scenario.expect.opponent_contacts_max));
  }
  for (Validator& validator : rule_validators(scenario, limits)) validators.push_back(std::move(validator));
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
